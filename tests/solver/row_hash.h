// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "solver/run/recorder.h"
#include "solver/state/hash.h"

namespace voussoir::testing {

/// A Recorder that keeps no row, but a hash and a count of each table.
class RowHash final : public solver::Recorder {
 public:
  void history(double time, std::span<const solver::HistorySample> samples) override {
    add(0, &time, sizeof time);
    add(0, samples.data(), samples.size_bytes());
    ++rows[0];
  }
  void ties(double, std::span<const solver::TieSample> samples) override {
    for (const solver::TieSample& s : samples)
      for (const double v : {s.force, s.elongation, s.plastic, s.broken ? 1.0 : 0.0}) add(0, &v, sizeof v);
  }
  void energy(const solver::EnergyRow& row) override { add(1, &row, sizeof row), ++rows[1]; }
  void forces(const solver::ForcesRow& row) override { add(2, &row, sizeof row), ++rows[2]; }
  void damage(const solver::DamageRow& row) override { add(3, &row, sizeof row), ++rows[3]; }
  void cracks(std::span<const solver::CrackRow> all) override {
    for (const solver::CrackRow& c : all) {
      for (const double v : {c.time, c.position.x, c.position.y, c.position.z, c.normal.x, c.normal.y, c.normal.z, c.area, c.first_time})
        add(4, &v, sizeof v);
      const std::int32_t n[] = {c.joint, c.element_a, c.element_b, static_cast<std::int32_t>(c.mode),
                                static_cast<std::int32_t>(c.first_mode)};
      add(4, n, sizeof n);
      ++rows[4];
    }
  }
  void frame(const solver::FrameView& f) override {
    add(5, &f.time, sizeof f.time);
    for (const auto& part : {f.displacement, f.quaternion, f.broken}) add(5, part.data(), part.size_bytes());
    ++rows[5];
    last_frame = f.time;
  }
  void summary(const solver::Summary& s) override { last = s; }

  [[nodiscard]] std::array<std::uint64_t, 6> values() const {
    std::array<std::uint64_t, 6> v{};
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = hashes_[i].value();
    return v;
  }

  std::array<std::uint64_t, 6> rows{};
  solver::Summary last;
  double last_frame = -1.0;  // s

 private:
  void add(std::size_t table, const void* data, std::size_t bytes) { hashes_[table].add(data, bytes); }
  std::array<solver::Hash, 6> hashes_;
};

}  // namespace voussoir::testing
