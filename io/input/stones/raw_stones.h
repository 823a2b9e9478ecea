// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/solids/stones.h"
#include "io/input/stones/stone_file.h"

/// From files to closed solids in metres, by name. Internal to io/input/stones/.
namespace voussoir::io {

/// What a file holds as one stone: once it is closed up, a closed solid, oriented outward, with exactly coplanar faces merged; or a faulty
/// one.
struct RawStone {
  std::string name;
  std::vector<std::string> groups;
  geometry::Mesh mesh;  // m, in the axes of the case
  bool support = false;
  std::size_t merged = 0;  // number of faces merged into coplanar ones
  std::size_t turned = 0;  // number of faces that were drawn inside out
  std::string fault = {};  // why it bounds no solid, with the place and the remedy; the mesh is then as read, its faces turned outward where that is known
};

/// Messages about a file as a whole, to which readers add lines.
struct StonesTold {
  std::vector<std::string>&notes, &doubts;  // as those of StoneFile
};

/// All stones of one table, in file order, not closed up yet. \param key  of the table
std::vector<RawStone> raw_stones(const cases::StonesSpec& spec, const std::string& key, const std::string& folder, StonesTold told);

/// Joins corners, and faces in one plane; says in RawStone::fault why it cannot be done.
void close_up(RawStone& stone);

/// "12 stones", "1 stone".
std::string counted(std::size_t n, const std::string& what);

/// 'stone "Mesh_12" of "dome.obj"'
std::string stone_words(const cases::StonesSpec& spec, const std::string& name);

}  // namespace voussoir::io
