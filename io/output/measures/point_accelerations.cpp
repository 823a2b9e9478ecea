// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/point_accelerations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr double kRowsPerPeriod = 4.0;  // rows per period of the corner frequency, at least

Vec3 row_of(const std::vector<double>& values, std::size_t i) {
  return 3 * i + 2 < values.size() ? Vec3{values[3 * i], values[3 * i + 1], values[3 * i + 2]} : Vec3{};
}

PointAcceleration accelerations_of(const std::string& name, const std::vector<double>& velocity, const std::vector<double>& base,
                                   std::size_t rows, double interval) {
  PointAcceleration p{name, std::vector<Vec3>(rows), 0.0};
  LowPass x(kInstrumentCorner, 1.0 / interval), y = x, z = x;
  Vec3 before = row_of(velocity, 0) + row_of(base, 0);
  for (std::size_t i = 1; i < rows; ++i) {
    const Vec3 now = row_of(velocity, i) + row_of(base, i), mean = (now - before) * (1.0 / interval);
    p.acceleration[i] = {x(mean.x), y(mean.y), z(mean.z)};
    p.peak_horizontal = std::max(p.peak_horizontal, std::hypot(p.acceleration[i].x, p.acceleration[i].y));
    before = now;
  }
  return p;
}

}  // namespace

LowPass::LowPass(double corner, double rate) : first_{}, second_{} {
  const double k = std::tan(std::numbers::pi * corner / rate);
  const auto section = [k](double angle) {  // section of the pole pair at this angle from the negative axis
    const double damping = 2.0 * std::cos(angle), norm = 1.0 / (1.0 + damping * k + k * k);
    return Section{k * k * norm, 2.0 * k * k * norm, k * k * norm, 2.0 * (k * k - 1.0) * norm, (1.0 - damping * k + k * k) * norm};
  };
  first_ = section(std::numbers::pi / 8.0);
  second_ = section(3.0 * std::numbers::pi / 8.0);
}

double LowPass::operator()(double value) noexcept {
  for (Section* s : {&first_, &second_}) {
    const double out = s->b0 * value + s->s1;
    s->s1 = s->b1 * value - s->a1 * out + s->s2;
    s->s2 = s->b2 * value - s->a2 * out;
    value = out;
  }
  return value;
}

PointAccelerations point_accelerations(const Hdf5File& run, std::uint64_t most_rows) {
  if (!run.exists("/history/time") || run.count_of("/history/time") > most_rows) return {};
  std::vector<double> time = run.read<double>("/history/time");
  if (time.size() < 2) return {};
  const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  if (!(interval > 0.0 && interval * kInstrumentCorner * kRowsPerPeriod <= 1.0 + 1e-9)) return {};
  std::vector<double> base;
  if (run.exists("/motion/velocity")) base = run.read<double>("/motion/velocity");
  PointAccelerations out;
  for (const std::string& name : run.children("/history")) {
    const std::string velocity = "/history/" + name + "/velocity";
    if (name != "time" && run.exists(velocity))
      out.points.push_back(accelerations_of(name, run.read<double>(velocity), base, time.size(), interval));
  }
  out.time = std::move(time);
  return out;
}

void write_accelerations(Hdf5File& file, const PointAccelerations& a) {
  if (a.points.empty()) return;
  const auto put = [&](const std::string& name, const std::vector<double>& values, Shape shape, const Hdf5Note& note) {
    const std::size_t row = shape.size() > 1 ? 3 * sizeof(double) : sizeof(double);
    file.write_dataset("/acceleration/" + name, Hdf5Type::f64, shape, values.data(), checked_layout(row), note);
  };
  put("time", a.time, {a.time.size()}, {"s", "time of the rows, those of /history"});
  for (const PointAcceleration& p : a.points) {
    std::vector<double> values;
    for (const Vec3 v : p.acceleration) values.insert(values.end(), {v.x, v.y, v.z});
    put(p.name, values, {p.acceleration.size(), 3},
        {"m/s2", "absolute acceleration of the point along x, y, z; low-pass of Butterworth's, fourth order, 50 Hz, causal"});
  }
}

}  // namespace voussoir::io
