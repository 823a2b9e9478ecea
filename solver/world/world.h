// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "cases/forward.h"
#include "geometry/nth.h"
#include "kernels/contact/contact_patch.h"
#include "kernels/law.h"
#include "kernels/rows.h"
#include "kernels/side.h"
#include "solver/team/team.h"
#include "solver/world/array.h"
#include "solver/world/contacts.h"
#include "solver/world/dashpot_bounds.h"
#include "solver/world/elements.h"
#include "solver/world/loads.h"
#include "solver/world/multirate.h"
#include "solver/world/options.h"
#include "solver/world/overlaps.h"
#include "solver/world/patches.h"
#include "solver/world/sides.h"
#include "solver/world/step_log.h"
#include "solver/world/ties.h"
#include "solver/world/travel.h"

/// All data of a step, in structures of arrays. The state, which a checkpoint contains, is listed in state/field_table.cpp; the rest is
/// built from the model (setup/setup.h) or derived from the state (contact candidates, the grid).
namespace voussoir::solver {

struct World {
  explicit World(const cases::Model& m);
  ~World();

  // Input and options.
  const cases::Model& model;
  Options options;
  kernels::FailureOptions failure;
  kernels::ContactOptions contact;
  std::vector<double> friction;  // tan φ by pair of materials, the table used by `contact`: Model::contact_friction
  bool has_base = false;
  bool drop_debris_damping = false;  // elements without a bond have no mass damping
  bool out_of_cache = false;         // the model is larger than the caches, see schedule/out_of_cache.h
  bool keep_pairs = false;           // in this step sides and overlaps store a copy of their forces, for cuts
  Team team;                         // threads that work on it
  StepLog log;                       // stages of the last step, for tests

  // Time.
  double dt = 0.0;     // s
  double bound = 0.0;  // s, the longest stable step (Eq. 19)
  Multirate multirate;

  // Bodies.
  Elements elements;
  std::vector<kernels::Face> faces;  // of all elements, and one for the base
  std::int32_t most_faces = 1;       // greatest number of one element
  DashpotBounds dashpot_bounds;
  Travel travel;

  // Forces between bodies.
  PointSets points;
  Sides sides;
  Patches patches;
  Contacts contacts;
  Overlaps overlaps;
  Ties ties;

  // Forces and motions from outside.
  std::vector<std::shared_ptr<const cases::SupportHistory>> moving_forces;  // over time, of the stations of loads that move
  std::vector<PointLoad> loads;
  std::vector<Support> supports;

  // State by batch of elements with multi-rate stepping, else empty: the level in whose steps its elements move, by all steps of a period
  // at once. None of their pairs has a lower level.
  std::vector<std::uint8_t> moved_at;

  /// Rows read and written by pairs of a level (multirate.h), and their step.
  [[nodiscard]] kernels::Bodies bodies(int level = 0) const noexcept;
  [[nodiscard]] kernels::Rows rows(int level = 0) noexcept;
  [[nodiscard]] const double* twist_rows(int level) const noexcept;
  [[nodiscard]] double step_of(int level) const noexcept { return level == 0 ? dt : multirate.steps_of(level) * dt; }
  [[nodiscard]] kernels::ContactOptions contact_of(int level) const noexcept;
  [[nodiscard]] kernels::ElementRows element_rows() noexcept;

  /// Whether the element is the base or a part of it.
  [[nodiscard]] bool is_ground(std::int32_t element) const noexcept { return nth(faces, nth(elements.first_face, element)).is_ground(); }

  /// Time by which an element moves at once [s].
  [[nodiscard]] double step_of_element(std::size_t e) const noexcept { return step_of(batch_level(e / kernels::kBatch)); }
  [[nodiscard]] int batch_level(std::size_t batch) const noexcept { return multirate.on() ? moved_at[batch] : 0; }
};

}  // namespace voussoir::solver
