// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/cut_stone.h"

#include <cmath>
#include <optional>
#include <string>

#include "geometry/message.h"
#include "geometry/prism.h"
#include "geometry/solids/flatten.h"
#include "geometry/solids/pieces.h"

namespace voussoir::io {
namespace {

using geometry::Mesh;
using geometry::Polyhedron;

/// The mesh as a polyhedron. \return nothing if it is not convex
std::optional<Polyhedron> convex_shape(const Mesh& mesh) {
  Polyhedron shape = geometry::in_prism_order({mesh.vertices, mesh.faces});
  try {
    geometry::validate(shape);
  } catch (const geometry::ModelError& e) {
    if (std::string(e.what()).find("not convex") != std::string::npos) return std::nullopt;
    throw;
  }
  return shape;
}

/// Cuts a stone in coordinates about one of its corners, so that a stone far from the origin keeps its digits.
std::vector<Polyhedron> pieces_about_corner(Mesh mesh, double snap, double tolerance = 1e-9) {
  const Vec3 first = mesh.vertices.front(), origin{std::round(first.x), std::round(first.y), std::round(first.z)};
  for (Vec3& v : mesh.vertices) v = v - origin;
  std::vector<Polyhedron> pieces = geometry::convex_pieces(mesh, snap, tolerance);
  for (Polyhedron& p : pieces) {
    for (Vec3& v : p.vertices) v += origin;
  }
  return pieces;
}

std::vector<Polyhedron> checked(std::vector<Polyhedron> pieces) {
  for (Polyhedron& p : pieces) {
    p = geometry::in_prism_order(p);
    geometry::validate(p);
  }
  return pieces;
}

/// Makes the faces of pieces plane. \throw ModelError if a corner would have to move by more than twice `within` [m]
std::vector<Polyhedron> made_plane(std::vector<Polyhedron> pieces, double within) {
  for (Polyhedron& p : pieces) {
    std::vector<geometry::RoughSolid> one = {{{std::move(p.vertices), std::move(p.faces)}, within, std::nullopt}};
    geometry::flatten(one, std::nullopt);
    p = {std::move(one.front().mesh.vertices), std::move(one.front().mesh.faces)};
  }
  return pieces;
}

std::optional<CutStone> cut_but_for_dents(const Mesh& mesh, double snap) {
  const double size = geometry::diagonal(mesh);
  for (const double tolerance : {3e-9, 1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 3e-6}) {
    for (const double reach : {snap, 0.0}) {
      try {
        return CutStone{checked(made_plane(pieces_about_corner(mesh, reach, tolerance), 10.0 * tolerance * size)), tolerance * size};
      } catch (const geometry::ModelError&) {
        continue;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

CutStone cut_stone(const Mesh& mesh, double snap) {
  if (auto shape = convex_shape(mesh)) return {{*std::move(shape)}, 0.0};
  std::optional<geometry::ModelError> first;
  for (const bool about_corner : {false, true}) {
    for (const double reach : {snap, 0.0}) {
      try {
        return {checked(about_corner ? pieces_about_corner(mesh, reach) : geometry::convex_pieces(mesh, reach)), 0.0};
      } catch (const geometry::ModelError& e) {
        if (!first) first = e;
      }
    }
  }
  if (auto done = cut_but_for_dents(mesh, snap)) return *std::move(done);
  throw geometry::ModelError(*first);
}

}  // namespace voussoir::io
