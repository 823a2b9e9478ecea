// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/tables/blocks.h"
#include "geometry/polyhedron.h"

/// Stones from geometry files: keys of the case, and contents of the files.
namespace voussoir::cases {

/// A convex part of a stone; most stones have one part.
struct StonePiece {
  geometry::Polyhedron shape;      // global axes, m
  std::vector<std::int32_t> beds;  // faces that lie on a mortar bed of StonesSpec::gap
};

/// A stone as read, placed and repaired.
struct Stone {
  std::string name;
  std::vector<std::string> groups;  // groups of the file that contain the stone
  bool fixed = false;               // decided by StonesSpec::supports
  std::vector<StonePiece> pieces;   // more than one: the stone is not convex
  std::string change;               // description of changes made to the stone; empty: none. Not part of a checkpoint
};

/// Rule for which stones are fixed.
struct StoneSupports {
  enum class Kind : std::uint8_t {
    automatic,  // stones marked in the file; if none is marked, and the case has neither a base nor a fixed block: `ground`
    ground,     // all stones that touch the lowest level of the file
    none,
    below,  // all stones that reach below a level
    named,  // by name or group
  };
  Kind kind = Kind::automatic;
  double level = 0.0;              // m, of `below`
  std::vector<std::string> names;  // of `named`
};

struct StoneTurn {
  Vec3 axis{0, 0, 1};
  double angle = 0.0;  // degrees
  Vec3 about;          // m
};

/// Treatment of faces that are warped by more than snap.
enum class WarpedFaces : std::uint8_t { refuse, triangles };

/// How stones are made to touch.
enum class StoneFit : std::uint8_t {
  snap,    // faces within StonesSpec::snap of each other
  planes,  // a plane for each pair that touches (geometry/solids/fit/fit_planes.h)
};

/// One [[stones]] table: a file or a folder of stones.
struct StonesSpec {
  std::string file;
  std::string unit;                  // of the file: "m", "cm", "mm", "in", "ft"
  std::string name;                  // prefix of the names of its stones: NAME/STONE; empty: no prefix
  std::vector<std::string> only;     // names and groups of the file that are used; empty: all
  Vec3 place;                        // m, translation after the turn
  StoneTurn turn;                    // about a point of the file [m]
  std::string material;              // empty: the only material of the case
  std::string part;                  // part of a building, as BlockSpec::part
  std::optional<std::string> joint;  // law between stones of this table; none: [joints]
  double snap = 1e-3;                // m, faces nearer than this are in contact
  std::optional<double> gap;         // m, thickness of the mortar between faces at that distance (within snap)
  WarpedFaces warped = WarpedFaces::refuse;
  StoneFit fit = StoneFit::snap;    // the same for all tables of a case
  std::optional<double> fit_limit;  // m, how far the surface of a stone may move by the fit to planes; none: a share of its least width
  StoneSupports supports;
  std::optional<SupportMotion> motion;  // of its fixed stones; each turns about its own centroid, unless `about` is given

  std::vector<Stone> stones;        // not a key: filled by io/input/stones before a model is built
  std::vector<std::string> notes;   // not a key: descriptions of changes made to the file as a whole
  std::vector<std::string> doubts;  // not a key: why the file may be damaged, or not be read as a whole
};

/// Metres per unit of length. \pre `unit` is one of the words of StonesSpec::unit
double metres_in(const std::string& unit) noexcept;

}  // namespace voussoir::cases
