// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "kernels/side.h"
#include "kernels/whole_sides.h"

/// Two bricks with a joint of a chosen number of segments, at any pose: what the kernels need, and nothing else.
namespace voussoir::testing {

/// A platform-independent source of numbers in [-1, 1].
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return 2.0 * static_cast<double>(engine_() >> 11) * 0x1.0p-53 - 1.0; }
  Vec3 vector(double size) { return {size * (*this)(), size * (*this)(), size * (*this)()}; }

 private:
  std::mt19937_64 engine_;
};

struct TwoBodies {
  std::array<double, 3 * kernels::kPoseStride> pose{};  // master, slave, base
  std::array<double, 3 * kernels::kTwistStride> twist{};

  void place(int body, Vec3 u, Vec3 turn) {
    const double h2 = 0.25 * dot(turn, turn);
    const double f = 1.0 / std::sqrt(1.0 + h2);
    const Mat3 d = rotation_minus_identity({f, 0.5 * f * turn.x, 0.5 * f * turn.y, 0.5 * f * turn.z});
    double* r = pose.data() + body * kernels::kPoseStride;
    const double values[12] = {d.r0.x, d.r0.y, d.r0.z, u.x, d.r1.x, d.r1.y, d.r1.z, u.y, d.r2.x, d.r2.y, d.r2.z, u.z};
    std::copy_n(values, 12, r);
  }
  void move(int body, Vec3 v, Vec3 w) {
    const double values[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
    std::copy_n(values, 6, twist.data() + body * kernels::kTwistStride);
  }
};

/// One side with points on a grid, and its history.
struct SideUnderTest {
  kernels::Side side;
  kernels::SideConstants constants{};  // of the last block()
  kernels::WholeConstants whole{};
  kernels::SteadySides steady{};  // of a block with the side in lane kLane
  std::vector<double> s, t, area;
  std::vector<kernels::Bond> bond;
  std::vector<kernels::Mode> first_mode;
  std::vector<double> first_time;
  std::vector<kernels::SegmentSprings> springs;
  kernels::Softening softening;
  std::vector<double> wear;  // by segment; empty: its bonds do not soften
  kernels::Crushing crushing;
  std::vector<double> crushed;  // by segment; empty: its contacts bear any pressure
  kernels::Closing closing;     // off: its stiffness is one number
  int n = 0;

  SideUnderTest(int ns, int nt, double mean) {
    side.master = 0, side.slave = 1;
    side.ca = {0.05, 0.0, 0.02}, side.cb = {-0.05, 0.01, -0.03};
    side.es = {0.0, 1.0, 0.0}, side.et = {0.0, 0.0, 1.0};
    side.mean = mean;
    side.factor = mean > 0.0 ? 1.0 : 0.5;
    side.k = {1.0e9, 3.75e8, 4.0e5, 2.4e5};
    side.strength = {1.27e5, 3.04e4, std::tan(0.5585), 4.9e5, 9.0, 0.55};
    for (int i = 0; i < ns; ++i) {
      for (int j = 0; j < nt; ++j) {
        s.push_back(0.025 * (i - 0.5 * (ns - 1)));
        t.push_back(0.025 * (j - 0.5 * (nt - 1)));
        area.push_back(0.025 * 0.025);
      }
    }
    n = ns * nt;
    const std::size_t padded = static_cast<std::size_t>((n + kernels::kLanes - 1) / kernels::kLanes * kernels::kLanes);
    s.resize(padded, s.back()), t.resize(padded, t.back()), area.resize(padded, 0.0);
    bond.assign(padded, kernels::Bond::bonded), first_mode.assign(padded, kernels::Mode::none);
    first_time.assign(padded, 0.0), springs.assign(padded / kernels::kWidth, {});
  }

  void soften(kernels::Softening law) { softening = law, wear.assign(s.size(), 0.0); }
  void crush(kernels::Crushing law) { crushing = law, crushed.assign(s.size(), 0.0); }
  kernels::SideLaws laws() {
    return {.soft = {softening, wear.empty() ? nullptr : wear.data()},
            .closing = closing,
            .crushing = crushed.empty() ? nullptr : &crushing,
            .crushed = crushed.empty() ? nullptr : crushed.data()};
  }

  /// Against the base instead of the other body.
  void put_onto_base() { side.slave = 2, side.on_base = true, side.mean = 0.0, side.factor = 1.0; }

  kernels::PointsView points() const { return {s.data(), t.data(), area.data(), n}; }
  kernels::SegmentsView segments() { return {bond.data(), first_mode.data(), first_time.data(), springs.data()}; }

  kernels::SideParts parts() { return {7, side.factor, side.k.cn, side.k.cs, points(), segments()}; }

  /// The side in a lane of a block; the other lanes rest. The constants are this object's.
  kernels::SideBlock block(int lane) {
    kernels::SideConstants& c = constants = {};
    kernels::SideBlock b{.constants = &constants, .master = {}, .slave = {}};
    for (int l = 0; l < kernels::kLanes; ++l) {
      b.master[l] = b.slave[l] = 2;
      c.es[0][l] = c.et[1][l] = 1.0;
      c.kn[l] = c.ks[l] = 1.0;
    }
    const auto put = [lane](double(&to)[3][kernels::kLanes], Vec3 v) { to[0][lane] = v.x, to[1][lane] = v.y, to[2][lane] = v.z; };
    put(c.ca, side.ca), put(c.cb, side.cb), put(c.es, side.es), put(c.et, side.et);
    if (side.on_base) b.on_base |= 1U << lane;
    b.master[lane] = side.master, b.slave[lane] = side.slave, c.mean[lane] = side.mean;
    c.kn[lane] = side.k.kn, c.ks[lane] = side.k.ks;
    c.tension[lane] = side.strength.tension, c.cohesion[lane] = side.strength.cohesion, c.tan_phi[lane] = side.strength.tan_phi;
    c.compression[lane] = side.strength.compression, c.cap[lane] = side.strength.cap, c.friction[lane] = side.strength.friction;
    c.twist[lane] = side.twist;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      const double da = side.factor * area[i];
      c.area[lane] += da, c.sss[lane] += da * s[i] * s[i], c.sst[lane] += da * s[i] * t[i], c.stt[lane] += da * t[i] * t[i];
      c.s_low[lane] = std::min(c.s_low[lane], s[i]), c.s_high[lane] = std::max(c.s_high[lane], s[i]);
      c.t_low[lane] = std::min(c.t_low[lane], t[i]), c.t_high[lane] = std::max(c.t_high[lane], t[i]);
    }
    whole = kernels::whole_constants(c, b.on_base);
    kernels::set_whole(b, whole);
    return b;
  }

  kernels::SideFrame frame(const TwoBodies& b) const {
    return kernels::side_frame(side, kernels::load_pose(b.pose.data(), side.master), kernels::load_pose(b.pose.data(), side.slave),
                               kernels::load_twist(b.twist.data(), side.master), kernels::load_twist(b.twist.data(), side.slave));
  }
};

/// The lane that a side under test is put into.
inline constexpr int kLane = 5;

/// One step of a side under test on its own block: what it did, and the forces it left on the rows of both bodies.
struct SideStep {
  bool looked_at = false;       // at its segments
  kernels::DamagedSide result;  // then
  Vec3 force_a, torque_a, dash_a, force_b, torque_b, force_base;
};

inline SideStep advance(kernels::AdvanceSides& kernel, SideUnderTest& u, const TwoBodies& b, double step, double time,
                        kernels::FailureOptions o, std::vector<kernels::SegmentEvent>& events,
                        kernels::SideState state = kernels::SideState::segments) {
  SideStep s;
  alignas(64) double wrench[3 * kernels::kWrenchStride] = {}, dashpot[3 * kernels::kDashpotStride] = {};
  kernels::SideParts parts[kernels::kLanes];
  parts[kLane] = u.parts();
  kernels::DamagedSide result[kernels::kLanes];
  kernels::SideState states[kernels::kLanes] = {};
  states[kLane] = state;
  kernels::SideLaws laws[kernels::kLanes];
  laws[kLane] = u.laws();
  const std::size_t before = events.size();
  events.resize(before + u.s.size());
  kernels::EventSink sink{events.data() + before, 0};
  const kernels::BlockState block{.side_state = states, .steady = &u.steady, .parts = parts, .laws = laws, .first = 0, .live = 1U << kLane};
  const kernels::Rows rows{b.pose.data(), b.twist.data(), wrench, dashpot, {}};
  s.looked_at = kernel(u.block(kLane), block, rows, {step, time}, o, result, sink) != 0;
  events.resize(before + static_cast<std::size_t>(sink.count));
  const auto row = [&](int e, int at) {
    const double* r = wrench + e * kernels::kWrenchStride + at;
    return Vec3{r[0], r[1], r[2]};
  };
  if (s.looked_at) s.result = result[kLane];
  s.force_a = row(0, 0), s.torque_a = row(0, 3), s.force_b = row(1, 0), s.torque_b = row(1, 3), s.force_base = row(2, 0);
  if (wrench[kernels::kDashedColumn] != 0.0) s.dash_a = {dashpot[0], dashpot[1], dashpot[2]};  // else nobody looks there
  return s;
}

/// Makes the side steady where it was looked at last, if it can be.
inline bool make_steady(SideUnderTest& u, const SideStep& looked_at, double farthest, kernels::FailureOptions o) {
  return kernels::make_steady(u.block(kLane), kLane, u.parts(), looked_at.result.u, farthest, o, u.steady);
}

/// Elastic energy in the segments of a side under test.
inline kernels::SideEnergy energy(SideUnderTest& u, const TwoBodies& b) {
  kernels::Side side = u.side;
  const kernels::SideLaws laws = u.laws();
  side.laws = &laws;
  return kernels::segment_energy(side, u.frame(b), u.points(), u.segments());
}

inline double distance(Vec3 a, Vec3 b) { return norm(a - b); }

}  // namespace voussoir::testing
