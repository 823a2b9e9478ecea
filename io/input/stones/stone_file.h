// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/solids/mesh.h"

/// Files of geometry, read: surfaces with their names, in the file's unit. Nothing is mended here.
namespace voussoir::io {

/// What a file holds as one thing: an object, a group, a node of an assembly, a cell.
struct FileSolid {
  std::string name;
  std::vector<std::string> groups;
  geometry::Mesh mesh;
  bool support = false;  // the file marks it as one
  bool whole = true;     // false: a heap of faces; its connected parts are the stones
};

struct StoneFile {
  std::vector<FileSolid> solids;
  std::vector<std::string> notes;  // what was left out, for people
};

/// Each takes the text of a file; `path` is for messages. Numbers are read as doubles.
/// \throw FileError with the line, or the place in the file, at fault
/// Wavefront OBJ: `o` (else `g`) begins a stone, `g` gives its groups; without either its connected parts are the stones. Texture and
/// normal numbers, materials, lines and points are passed over.
StoneFile read_obj(const std::string& path, std::string_view text);
/// PLY, ASCII or binary of either order: `vertex` with x, y, z of any type, `face` with a list vertex_indices (or vertex_index).
StoneFile read_ply(const std::string& path, std::string_view text);
/// STL, ASCII (each `solid` a stone if it has a name of its own) or binary.
/// Binary: a count of 0 or 4294967295 was never filled in, so the length tells; less than one triangle behind the last is passed over.
StoneFile read_stl(const std::string& path, std::string_view text);
/// Binary STL says how many triangles it has, and is as long.
bool is_binary_stl(std::string_view text);
/// ASCII STL begins with "solid" in any case, perhaps behind blanks, and goes on with facets or ends at once.
bool is_ascii_stl(std::string_view text);
/// VTU (unstructured grid): each tetrahedron, hexahedron, wedge, pyramid, voxel and polyhedron is a stone, or all of them that share a
/// value of a cell array `element`; polygons are a heap of faces. ASCII, base64 or raw, plain or deflated.
StoneFile read_vtu(const std::string& path, std::string_view text);
/// JSON of COMPAS: every mesh, polyhedron or box in it, wherever it stands; nodes of an assembly give names and supports. Interfaces
/// are passed over.
StoneFile read_compas(const std::string& path, std::string_view text);

/// By what the file begins with, whatever its name. \throw FileError
StoneFile read_stone_file(const std::string& path, std::string_view text);

}  // namespace voussoir::io
