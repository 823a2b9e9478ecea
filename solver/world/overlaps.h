// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec3.h"
#include "kernels/contact/contact_patch.h"
#include "kernels/contact/overlap.h"
#include "solver/world/multirate.h"
#include "solver/world/search_room.h"

namespace voussoir::solver {

/// The spring between two elements with more than the allowed overlap (all members are state).
struct OverlapSpring {
  std::int32_t a = 0, b = 0;
  Vec3 shear;                      // m, elongation along the contact, in body axes of a
  double stored = 0.0;             // J
  Vec3 force, torque_a, torque_b;  // N, N m: elastic part at the last step, on a; b gets −force
  double share = 1.0;              // share of its stiffness and dashpots allowed by the step, least value so far
  double from = 0.0;               // m, beyond the allowed overlap: overlap at the creation of the spring that has not disappeared since
  Vec3 dashpot, dashpot_torque_a, dashpot_torque_b;  // N, N m: dashpot part, likewise
};

/// Contact of whole bodies by their exact overlap, where contact points miss it: at edges, corners and crossed edges, and deep inside
/// (THEORY.md (21a)).
struct Overlaps {
  // Constants.
  std::vector<Vec3> vertices, edges;             // of all shapes: m, relative to the centroid; unit directions
  std::vector<kernels::Crease> creases;          // of all shapes
  std::vector<kernels::ConvexShape> shape;       // each distinct shape once, with the faces of the first element that has it
  std::vector<std::int32_t> shape_of;            // by element
  std::vector<double> stiffness_n, stiffness_s;  // N/m, by element; 0 for the base, which is rigid
  std::vector<double> allowed;                   // m, by element
  std::vector<std::int64_t> first_side;          // by first element of a pair, count + 1 entries: range in the next two
  std::vector<std::int32_t> joined_to, side;     // the other element of a joint (may be the base), and a side of the joint
  // State.
  std::vector<OverlapPair> pairs;           // ascending (a, b); state, since with several rates they determine when elements move
  ByLevel by_level;                         // of pairs; empty without multi-rate stepping (derived)
  std::vector<OverlapSpring> springs;       // ascending (a, b)
  std::vector<kernels::PairWrench> wrench;  // of each spring with its dashpot in this step, if World::keep_pairs (derived)
  double friction = 0.0, impact = 0.0;      // J, losses so far
  double dashpots = 0.0;                    // J, losses so far of their own dashpots; included in the losses of elements
};

}  // namespace voussoir::solver
