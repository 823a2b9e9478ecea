// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/polyhedron.h"

/// Stones out of files of geometry: what a case says of them, and what the file holds.
namespace voussoir::cases {

/// A convex part of a stone; most stones are one.
struct StonePiece {
  geometry::Polyhedron shape;      // global axes, m
  std::vector<std::int32_t> beds;  // faces that stand on a bed of mortar of StonesSpec::gap
};

/// A stone as it was read, placed and mended.
struct Stone {
  std::string name;
  std::vector<std::string> groups;  // that the file puts it into
  bool fixed = false;               // StonesSpec::supports, decided
  std::vector<StonePiece> pieces;   // more than one: the stone is not convex
  std::string change;               // what was done to it, for people; empty: nothing. Not part of a checkpoint
};

/// Which stones are fixed.
struct StoneSupports {
  enum class Kind : std::uint8_t {
    automatic,  // those that the file marks; if it marks none, and the case has neither a base nor a fixed block: ground
    ground,     // all that touch the lowest level of the file
    none,
    below,  // all that reach below a level
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

/// What is done about faces that are warped by more than snap.
enum class WarpedFaces : std::uint8_t { refuse, triangles };

/// One [[stones]]: a file or a folder of stones.
struct StonesSpec {
  std::string file;
  std::string unit;                  // of the file: "m", "cm", "mm", "in", "ft"
  std::string name;                  // before the names of its stones: NAME/STONE; empty: nothing
  std::vector<std::string> only;     // names and groups of the file that are taken; empty: all
  Vec3 place;                        // m, by which all are moved, after the turn
  StoneTurn turn;                    // about a point of the file, in m
  std::string material;              // empty: the only one of the case
  std::string part;                  // of a building, as BlockSpec::part
  std::optional<std::string> joint;  // a law between stones of this table; none: [joints]
  double snap = 1e-3;                // m, faces nearer than this are in contact
  std::optional<double> gap;         // m, thickness of the mortar between faces so far apart (within snap)
  WarpedFaces warped = WarpedFaces::refuse;
  StoneSupports supports;

  std::vector<Stone> stones;       // no key: io/input/stones fills it in before a model is built
  std::vector<std::string> notes;  // no key: what was done to the file as a whole, for people
};

/// Metres in a unit of length. \pre one of the words of StonesSpec::unit
double metres_in(const std::string& unit) noexcept;

}  // namespace voussoir::cases
