// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>

#include <cstring>
#include <span>

#include "io/checkpoint_file.h"
#include "io/session.h"
#include "solver/errors.h"
#include "tests/fuzz/memory_file.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// Checkpoints. The first byte chooses: the bytes as a file, or as changes to the state of a good checkpoint whose seal holds: a state that
// is taken, however odd, can be stepped.

namespace {

using namespace voussoir;

void as_file(std::span<const std::byte> bytes) {
  try {
    io::parse_checkpoint("fuzz", bytes);
  } catch (const io::FileError&) {
  }
}

/// A wall in the middle of its collapse.
struct Wall {
  cases::Case c = testing::small_wall(1, 2);
  cases::Model m = cases::build_model(c);
  cases::GroundMotion g = testing::strong_shaking();
  solver::SavedState good;

  Wall() {
    omp_set_num_threads(1);
    solver::Simulation sim(c, m, g, {});
    solver::RunState plan;
    testing::RowHash rows;
    solver::run(sim, plan, c, 1.0, rows, [](const solver::RunStatus& s) { return s.step < 2500; });
    good = solver::save(sim, plan);
  }
};

/// Changes of twelve bytes each: field, size, entry, value.
void spoil(solver::SavedState& state, const std::uint8_t* data, std::size_t size) {
  for (; size >= 12; data += 12, size -= 12) {
    auto it = state.begin();
    std::advance(it, data[0] % state.size());
    solver::SavedField& f = it->second;
    if (data[1] == 255) {  // another size
      f.count = data[2];
      f.bytes.resize(f.count * f.columns * size_of(f.type));
    }
    const std::size_t bytes = size_of(f.type);
    if (f.bytes.size() < bytes) continue;
    const std::size_t entry = (data[2] * 256U + data[3]) % (f.bytes.size() / bytes);
    std::memcpy(f.bytes.data() + entry * bytes, data + 4, bytes);
  }
}

void as_changes(const std::uint8_t* data, std::size_t size) {
  static const Wall wall;
  solver::SavedState state = wall.good;
  spoil(state, data, size);
  solver::Simulation sim(wall.c, wall.m, wall.g, {});
  solver::RunState plan;
  try {
    solver::restore(sim, plan, state);
    for (int i = 0; i < 5; ++i) sim.step({true, true});
  } catch (const solver::StateError&) {
  } catch (const solver::NumericalError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  if (data[0] % 8 == 0) {
    as_file(std::as_bytes(std::span(data + 1, size - 1)));
  } else {
    as_changes(data + 1, size - 1);
  }
  return 0;
}
