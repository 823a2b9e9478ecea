// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/report_loads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "cases/model.h"
#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostLoads = 30;  // arrows in one picture

/// A share of a load on one element.
struct Share {
  std::int32_t load = 0, element = 0;
  Vec3 point;
  bool follows = false, grows = false;
  cases::SupportHistory force;  // N
};

Vec3 vector_at(const std::vector<double>& values, std::size_t row) { return {values[3 * row], values[3 * row + 1], values[3 * row + 2]}; }

std::vector<Share> shares_of(const Hdf5File& run) {
  const auto load = run.read<std::int32_t>("/loads/load"), element = run.read<std::int32_t>("/loads/element"),
             first = run.read<std::int32_t>("/loads/first_row");
  const auto follows = run.read<std::uint8_t>("/loads/follows"), grows = run.read<std::uint8_t>("/loads/grows");
  const auto point = run.read<double>("/loads/point"), time = run.read<double>("/loads/time"), force = run.read<double>("/loads/force");
  const std::size_t n = load.size();
  if (element.size() != n || first.size() != n || follows.size() != n || grows.size() != n || point.size() != 3 * n ||
      force.size() != 3 * time.size())
    throw FileError(run.path(), "/loads does not fit together");
  std::vector<Share> shares;
  for (std::size_t i = 0; i < n; ++i) {
    Share& s = shares.emplace_back(Share{load[i], element[i], vector_at(point, i), follows[i] != 0, grows[i] != 0, {}});
    const auto from = static_cast<std::size_t>(first[i]), end = i + 1 < n ? static_cast<std::size_t>(first[i + 1]) : time.size();
    if (from >= end || end > time.size()) throw FileError(run.path(), "/loads/first_row does not fit together");
    for (std::size_t k = from; k < end; ++k) s.force.time.push_back(time[k]), s.force.displacement.push_back(vector_at(force, k));
  }
  return shares;
}

/// Load factors at times [s]: of the row of /assessment nearest before; 0 without such rows.
class Factors {
 public:
  explicit Factors(const Hdf5File& run) {
    if (!run.exists("/assessment/factor")) return;
    time_ = run.read<double>("/assessment/time"), factor_ = run.read<double>("/assessment/factor");
    if (time_.size() != factor_.size()) throw FileError(run.path(), "/assessment does not fit together");
  }
  [[nodiscard]] double at(double t) const {
    const auto after = std::ranges::upper_bound(time_, t + 1e-9) - time_.begin();
    return after == 0 ? 0.0 : nth(factor_, after - 1);
  }

 private:
  std::vector<double> time_, factor_;
};

/// The shares of one load in a frame as one force; null: none.
class Sum {
 public:
  void add(const Share& s, Vec3 force) {
    const double size = norm(force);
    force_ += force, weighted_ += size * s.point, weight_ += size;
    if (size > most_) most_ = size, element_ = s.element;
  }
  [[nodiscard]] Json json() const {
    if (!(norm(force_) > 0)) return {};
    const Vec3 at = weighted_ / weight_;
    const auto rounded = [](double x, double step) { return std::round(x / step) * step; };
    Json out = Json::array({element_});
    for (const double x : {at.x, at.y, at.z}) out.push_back(rounded(x, 1e-4));
    const double step = std::pow(10.0, std::floor(std::log10(norm(force_))) - 3);
    for (const double x : {force_.x, force_.y, force_.z}) out.push_back(rounded(x, step));
    return out;
  }

 private:
  Vec3 force_, weighted_;
  double weight_ = 0, most_ = 0;
  std::int32_t element_ = -1;
};

}  // namespace

std::string report_loads(const Hdf5File& run, const FrameReader& frames) {
  if (!run.exists("/loads/element") || frames.frames() == 0) return {};
  const std::vector<Share> shares = shares_of(run);
  const Factors factors(run);
  std::size_t loads = 0;
  for (const Share& s : shares) loads = std::max(loads, std::min(kMostLoads, static_cast<std::size_t>(s.load) + 1));
  Json out = Json::array();
  for (std::size_t i = 0; i < loads; ++i) out.push_back({{"name", "load " + std::to_string(i + 1)}, {"frames", Json::array()}});
  bool any = false;
  for (std::uint64_t f = 0; f < frames.frames(); ++f) {
    const double t = frames.times()[f];
    const std::vector<Pose> poses = poses_of(frames, f);
    std::vector<Sum> sums(loads);
    for (const Share& s : shares) {
      if (static_cast<std::size_t>(s.load) >= loads) continue;
      Vec3 force = cases::value_at(s.force, t);
      if (s.grows) force = factors.at(t) * force;
      if (s.follows) force = nth(poses, s.element).rotation * force;
      if (norm(force) > 0) nth(sums, s.load).add(s, force);
    }
    for (std::size_t i = 0; i < loads; ++i) {
      out[i]["frames"].push_back(sums[i].json());
      any = any || !out[i]["frames"].back().is_null();
    }
  }
  return any ? out.dump() : std::string();
}

}  // namespace voussoir::io
