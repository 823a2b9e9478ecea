// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"
#include "io/input/stones/stone_file.h"

/// From files to closed solids in metres, by name. Internal to io/input/stones/.
namespace voussoir::io {

/// A closed solid, oriented outward, with exactly coplanar faces merged; or a faulty one.
struct RawStone {
  std::string name;
  std::vector<std::string> groups;
  geometry::Mesh mesh;  // global axes, m
  bool support = false;
  std::size_t merged = 0;  // number of faces merged into coplanar ones
  std::string fault = {};  // why it bounds no solid, with the place and the remedy; the mesh is then as read
};

/// All stones of one table, in file order. \param key  of the table \param notes  descriptions of skipped content are appended
std::vector<RawStone> raw_stones(const cases::StonesSpec& spec, const std::string& key, const std::string& folder,
                                 std::vector<std::string>& notes);

/// "12 stones", "1 stone".
std::string counted(std::size_t n, const std::string& what);

/// 'stone "Mesh_12" of "dome.obj"'
std::string stone_words(const cases::StonesSpec& spec, const std::string& name);

}  // namespace voussoir::io
