// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/solids/mesh.h"

/// Readers of geometry files: surfaces with names, in the file's unit. Nothing is repaired here.
namespace voussoir::io {

/// One unit of a file: an object, a group, a node of an assembly, a cell.
struct FileSolid {
  std::string name;
  std::vector<std::string> groups;
  geometry::Mesh mesh;
  bool support = false;  // marked as a support in the file
  bool whole = true;     // false: loose faces, whose connected parts are the stones
};

struct StoneFile {
  std::vector<FileSolid> solids;
  std::vector<std::string> notes;   // descriptions of content that was left out, and is no stone
  std::vector<std::string> doubts;  // why the file may be damaged, or hold more stones than were read: findings of `check`
};

/// Readers take the text of a file; `path` is for messages. Numbers are read as doubles.
/// \throw FileError with the line, or the place in the file, at fault
///
/// Wavefront OBJ: `o` (else `g`) begins a stone, `g` gives its groups; without either, connected parts are the stones. Texture and normal
/// numbers, materials, lines and points are ignored.
StoneFile read_obj(const std::string& path, std::string_view text);
/// PLY, ASCII or binary of either order: `vertex` with x, y, z of any type, `face` with a list vertex_indices (or vertex_index).
StoneFile read_ply(const std::string& path, std::string_view text);
/// STL, ASCII (each `solid` with a name of its own is a stone) or binary.
/// Binary: a count of 0 or 4294967295 was never filled in, so the length of the file determines it; an incomplete triangle at the end is
/// ignored.
StoneFile read_stl(const std::string& path, std::string_view text);
/// Whether the text is binary STL: its length agrees with its number of triangles.
bool is_binary_stl(std::string_view text);
/// Whether the text is ASCII STL: "solid" in any case, after optional blanks, followed by facets or the end.
bool is_ascii_stl(std::string_view text);
/// VTU (unstructured grid): each tetrahedron, hexahedron, wedge, pyramid, voxel and polyhedron is a stone, or all cells that share a value
/// of a cell array `element`; polygons are loose faces. ASCII, base64 or raw, plain or deflated.
StoneFile read_vtu(const std::string& path, std::string_view text);
/// JSON of COMPAS: every mesh, polyhedron or box, at any depth; nodes of an assembly give names and supports. Interfaces are ignored.
StoneFile read_compas(const std::string& path, std::string_view text);

/// Reads a file of any format, recognised by its beginning, not by its name. \throw FileError
StoneFile read_stone_file(const std::string& path, std::string_view text);

}  // namespace voussoir::io
