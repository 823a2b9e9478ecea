// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0

#include <cstring>
#include <set>

#include "solver/run/run.h"
#include "solver/state/saved_state.h"
#include "solver/world/errors.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// What a checkpoint says: the input changes the state of a good one. A state that is taken, however odd, can be stepped.

namespace {

using namespace voussoir;

/// Changes of twelve bytes each: field, size, entry (two), value.
constexpr std::size_t kChange = 12;

/// A wall in the middle of its collapse. Its segments are as coarse as can be: what they are made of takes most of the building of a
/// world, and that is done anew for every input.
struct Wall {
  cases::Case c = testing::small_wall(1, 2);
  cases::Model m;
  cases::GroundMotion g = testing::strong_shaking();
  solver::SavedState good;

  Wall() {
    c.segment_size = 0.1;
    m = cases::build_model(c);
    solver::Simulation sim(c, m, g, {});
    solver::RunState plan;
    testing::RowHash rows;
    solver::run(sim, plan, c, 1.0, rows, [&sim](const solver::RunStatus&) { return !falling(sim.world()); });
    if (!falling(sim.world())) std::abort();  // there would be little to spoil
    good = solver::save(sim, plan);
  }
  /// Joints have come apart, and something may touch.
  static bool falling(const solver::World& w) { return w.patches.from_side.back() >= 0 && !w.contacts.candidate.empty(); }
};

/// The good state, spoilt by an input and mended when that is done.
class Spoilt {
 public:
  Spoilt(const solver::SavedState& good) : good_(good), state_(good) {
    for (auto& [name, field] : state_) fields_.push_back(&field), names_.push_back(name);
  }

  const solver::SavedState& with(const std::uint8_t* data, std::size_t size) {
    for (const std::size_t i : spoilt_) *fields_[i] = good_.at(names_[i]);
    spoilt_.clear();
    for (; size >= kChange; data += kChange, size -= kChange) change(data);
    return state_;
  }

 private:
  void change(const std::uint8_t* data) {
    const std::size_t i = data[0] % fields_.size();
    spoilt_.insert(i);
    solver::SavedField& f = *fields_[i];
    const std::size_t bytes = size_of(f.type);
    if (data[1] == 255) {  // another size
      f.count = data[2];
      f.bytes.resize(f.count * f.columns * bytes);
    }
    if (f.bytes.size() < bytes) return;
    const std::size_t entry = (data[2] * 256U + data[3]) % (f.bytes.size() / bytes);
    std::memcpy(f.bytes.data() + entry * bytes, data + 4, bytes);
  }

  const solver::SavedState& good_;
  solver::SavedState state_;
  std::vector<solver::SavedField*> fields_;
  std::vector<std::string> names_;
  std::set<std::size_t> spoilt_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Wall wall;
  static Spoilt spoilt(wall.good);
  solver::Simulation sim(wall.c, wall.m, wall.g, {});
  solver::RunState plan;
  try {
    solver::restore(sim, plan, spoilt.with(data, size));
    for (int i = 0; i < 5; ++i) sim.step({true, true});
  } catch (const solver::StateError&) {
  } catch (const solver::NumericalError&) {
  }
  return 0;
}
