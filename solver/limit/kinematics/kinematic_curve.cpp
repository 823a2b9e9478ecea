// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/kinematics/kinematic_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "cases/case.h"
#include "cases/loads/gravity.h"
#include "cases/loads/loads.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/limit/kinematics/mechanism.h"
#include "solver/limit/kinematics/null_space.h"

namespace voussoir::solver {
namespace {

constexpr double kBears = 1e-6;   // of the moving weight: a tie that bears less bears nothing
constexpr double kAtRest = 1e-3;  // of the fastest point: relative speed of a point on a hinge
constexpr double kRank = 3e-3;    // singular value, of the mean norm of columns, below which a hinge holds nothing
constexpr double kAsFast = 1e-6;  // relative
constexpr int kSteps = 200;       // up to the displacement at which the first slope would lead to zero
constexpr int kMostSteps = 5 * kSteps;
constexpr double kFirstStep = 1e-4;  // m, of the fastest point

/// A force that stays in its direction, at a point of the material of a part.
struct DeadForce {
  std::size_t part = 0;
  Vec3 at, force, moment;  // m, from the part's centre at first; N; N m
};

/// Two material points that stay together. \param b  −1: the ground
struct HingePoint {
  std::int32_t a = -1, b = -1;  // parts
  Vec3 on_a, on_b;              // m, from the centres at first (of the ground: the place)
};

/// A tie that yields: it pulls with `most` while it gets longer and with `least` while it gets shorter. Longer than `longest` it has broken
/// and pulls with nothing.
struct YieldingTie {
  struct Hold {
    std::int32_t part = -1;  // −1: the ground
    double share = 0.0;
    Vec3 arm;  // m, from the part's centre at first (of the ground: the place)
  };
  std::array<std::vector<Hold>, 2> ends;
  double most = 0.0, least = 0.0;  // N
  double longest = 0.0;            // m, at which it breaks
};

/// Places of the parts: centre of mass, and rotation since the beginning.
struct Place {
  Vec3 centre;
  Mat3 turn{};
};

Vec3 turned(const Place& p, Vec3 arm) { return p.turn * arm; }

/// Part of each body; −1: at rest, the ground.
std::vector<std::int32_t> parts_by_body(const LimitContacts& contacts, const Mechanism& mechanism) {
  std::vector<std::int32_t> part_of(contacts.bodies.size(), -1);
  for (std::size_t k = 0; k < mechanism.parts.size(); ++k)
    for (const std::int32_t b : mechanism.parts[k].bodies) nth(part_of, b) = static_cast<std::int32_t>(k);
  return part_of;
}

/// Whether a tie holds one part alone, whatever it pulls.
bool is_within_a_part(const LimitTie& tie, const std::vector<std::int32_t>& part_of) {
  const auto part = [&](const LimitTie::Hold& h) { return h.body < 0 ? -1 : nth(part_of, h.body); };
  const std::int32_t first = part(tie.ends[0].front());
  return std::ranges::all_of(tie.ends, [&](const std::vector<LimitTie::Hold>& end) {
    return std::ranges::all_of(end, [&](const LimitTie::Hold& h) { return part(h) == first; });
  });
}

class Chain {
 public:
  Chain(const cases::Case& c, const cases::Model& model, const LimitContacts& contacts, const Mechanism& mechanism, Vec3 live)
      : live_(live), gravity_(cases::gravity_on_base(c)) {
    const std::vector<std::int32_t> part_of = parts_by_body(contacts, mechanism);
    for (const MechanismPart& p : mechanism.parts) mass_.push_back(p.mass), start_.push_back({p.centre}), motion_.push_back(p.motion);
    add_hinges(contacts, mechanism, part_of);
    find_lengths();
    add_loads(c, model, contacts, part_of);
    add_ties(model, contacts, part_of);
  }

  [[nodiscard]] const std::vector<Place>& start() const { return start_; }
  [[nodiscard]] const std::vector<kernels::Twist>& motion() const { return motion_; }
  [[nodiscard]] const std::vector<HingePoint>& hinges() const { return hinges_; }
  [[nodiscard]] const std::vector<double>& mass() const { return mass_; }

  /// The motion nearest to `before` in which the hinges hold.
  [[nodiscard]] std::vector<kernels::Twist> held(const std::vector<Place>& at, const std::vector<kernels::Twist>& before) const {
    if (hinges_.empty()) return before;
    return unpacked(null_part(constraints(at), packed(before), kRank));
  }
  [[nodiscard]] std::size_t freedoms() const { return hinges_.empty() ? 6 * mass_.size() : nullity(constraints(start_), kRank); }
  /// The multiplier by virtual work. NaN: the live forces do no work.
  [[nodiscard]] double multiplier(const std::vector<Place>& at, const std::vector<kernels::Twist>& motion) const {
    double dead = 0.0, live = 0.0;
    for (std::size_t k = 0; k < mass_.size(); ++k) {
      dead += mass_[k] * dot(gravity_, motion[k].v);
      live += mass_[k] * norm(gravity_) * dot(live_, motion[k].v);
    }
    for (const DeadForce& f : forces_) {
      const Vec3 arm = turned(at[f.part], f.at);
      dead += dot(f.force, motion[f.part].v + cross(motion[f.part].w, arm)) + dot(f.moment, motion[f.part].w);
    }
    for (const YieldingTie& t : ties_) dead -= power(t, at, motion);
    return live > 0.0 ? -dead / live : KinematicCurve::kNone;
  }

 private:
  /// Power that a tie takes.
  [[nodiscard]] static double power(const YieldingTie& t, const std::vector<Place>& at, const std::vector<kernels::Twist>& motion) {
    std::array<Vec3, 2> place, speed;
    for (std::size_t k = 0; k < 2; ++k) {
      for (const YieldingTie::Hold& h : t.ends[k]) {
        const Vec3 arm = h.part < 0 ? h.arm : turned(nth(at, h.part), h.arm);
        place[k] += h.share * (h.part < 0 ? arm : nth(at, h.part).centre + arm);
        if (h.part >= 0) speed[k] += h.share * (nth(motion, h.part).v + cross(nth(motion, h.part).w, arm));
      }
    }
    const Vec3 along = place[1] - place[0];
    const double length = norm(along), longer = dot(speed[1] - speed[0], along) / length;
    return length > t.longest ? 0.0 : (longer > 0.0 ? t.most : t.least) * longer;
  }
  void add_hinges(const LimitContacts& contacts, const Mechanism& mechanism, const std::vector<std::int32_t>& part_of) {
    for (const LimitPoint& p : contacts.points) {
      const std::int32_t a = p.a < 0 ? -1 : nth(part_of, p.a), b = p.b < 0 ? -1 : nth(part_of, p.b);
      if (a == b) continue;
      const auto of = std::minmax(a, b);
      const bool hinge =
          std::ranges::any_of(mechanism.seams, [&](const MechanismSeam& s) { return s.hinge && s.a == of.first && s.b == of.second; });
      if (!hinge || norm(speed(b, p.at) - speed(a, p.at)) >= kAtRest) continue;
      const auto arm = [&](std::int32_t part) { return part < 0 ? p.at : p.at - nth(start_, part).centre; };
      hinges_.push_back({a, b, arm(a), arm(b)});
    }
  }
  void add_loads(const cases::Case& c, const cases::Model& model, const LimitContacts& contacts, const std::vector<std::int32_t>& part_of) {
    for (std::size_t i = 0; i < c.loads.size(); ++i) {
      for (const cases::LoadShare& share : cases::load_shares(model, c.loads[i], i)) {
        const std::int32_t body = nth(contacts.body_of, share.element), part = body < 0 ? -1 : nth(part_of, body);
        if (part < 0) continue;
        forces_.push_back({static_cast<std::size_t>(part), share.point - nth(start_, part).centre, share.part * c.loads[i].force,
                           share.part * c.loads[i].moment});
      }
    }
  }
  void add_ties(const cases::Model& model, const LimitContacts& contacts, const std::vector<std::int32_t>& part_of) {
    for (const LimitTie& tie : contacts.ties) {
      if (!std::isfinite(tie.most)) continue;
      const cases::TieBar& bar = nth(model.ties, tie.number);
      YieldingTie& out = ties_.emplace_back();
      out.most = tie.most, out.least = tie.least, out.longest = bar.length + bar.breaking;
      for (std::size_t k = 0; k < 2; ++k) {
        for (const LimitTie::Hold& h : tie.ends[k]) {
          const std::int32_t part = h.body < 0 ? -1 : nth(part_of, h.body);
          out.ends[k].push_back({part, h.share, part < 0 ? h.at : h.at - nth(start_, part).centre});
        }
      }
    }
  }
  [[nodiscard]] Vec3 speed(std::int32_t part, Vec3 at) const {
    return part < 0 ? Vec3{} : nth(motion_, part).v + cross(nth(motion_, part).w, at - nth(start_, part).centre);
  }
  void find_lengths() {
    length_.assign(mass_.size(), 0.0);
    const auto take = [&](std::int32_t part, Vec3 arm) {
      if (part >= 0) nth(length_, part) = std::max(nth(length_, part), norm(arm));
    };
    for (const HingePoint& h : hinges_) take(h.a, h.on_a), take(h.b, h.on_b);
    for (double& l : length_) l = l > 0.0 ? l : 1.0;
  }
  /// Three rows a hinge point: the relative velocity of its two sides. Rotations count times the length of the part.
  [[nodiscard]] SparseEntries constraints(const std::vector<Place>& at) const {
    SparseEntries a{3 * hinges_.size(), 6 * mass_.size(), {}};
    const auto put = [&](std::size_t row, std::int32_t part, Vec3 arm, double sign) {
      if (part < 0) return;
      const Vec3 r = turned(nth(at, part), arm);
      const std::size_t k = 6 * static_cast<std::size_t>(part);
      const double s = sign / nth(length_, part);
      const auto entry = [&](std::size_t i, std::size_t column, double value) { a.entries.push_back({row + i, k + column, value}); };
      for (std::size_t i = 0; i < 3; ++i) entry(i, i, sign);  // v + w × r
      entry(0, 4, s * r.z), entry(0, 5, -s * r.y);
      entry(1, 3, -s * r.z), entry(1, 5, s * r.x);
      entry(2, 3, s * r.y), entry(2, 4, -s * r.x);
    };
    for (std::size_t i = 0; i < hinges_.size(); ++i) {
      put(3 * i, hinges_[i].a, hinges_[i].on_a, 1.0);
      put(3 * i, hinges_[i].b, hinges_[i].on_b, -1.0);
    }
    return a;
  }
  [[nodiscard]] std::vector<double> packed(const std::vector<kernels::Twist>& motion) const {
    std::vector<double> v;
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const kernels::Twist& t = motion[k];
      const Vec3 w = length_[k] * t.w;
      v.insert(v.end(), {t.v.x, t.v.y, t.v.z, w.x, w.y, w.z});
    }
    return v;
  }
  [[nodiscard]] std::vector<kernels::Twist> unpacked(const std::vector<double>& v) const {
    std::vector<kernels::Twist> motion(mass_.size());
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double* s = v.data() + 6 * k;
      motion[k] = {{s[0], s[1], s[2]}, Vec3{s[3], s[4], s[5]} / length_[k]};
    }
    return motion;
  }

  Vec3 live_, gravity_;                // unit; m/s2
  std::vector<double> mass_, length_;  // kg; m, of a part's hinges from its centre
  std::vector<Place> start_;
  std::vector<kernels::Twist> motion_;  // at first
  std::vector<HingePoint> hinges_;
  std::vector<DeadForce> forces_;
  std::vector<YieldingTie> ties_;
};

/// Rotation by a rotation vector.
Mat3 turned_by(Vec3 by) {
  const double angle = norm(by);
  if (angle == 0.0) return {};
  const Vec3 s = (std::sin(0.5 * angle) / angle) * by;
  return rotation(Quaternion{std::cos(0.5 * angle), s.x, s.y, s.z});
}

/// The places after a while of a motion.
std::vector<Place> moved(const std::vector<Place>& from, const std::vector<kernels::Twist>& motion, double time) {
  std::vector<Place> to(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) to[k] = {from[k].centre + time * motion[k].v, turned_by(time * motion[k].w) * from[k].turn};
  return to;
}

/// e* and d/d_C of the first motion, from the parts' weights and their horizontal velocities.
void take_shares(KinematicCurve& out, const std::vector<MechanismPart>& parts, Vec3 live, std::size_t control, double gravity) {
  double all = 0.0, first = 0.0, second = 0.0;
  for (const MechanismPart& part : parts) {
    const double p = part.mass * gravity, d = dot(part.motion.v, live);
    all += p, first += p * d, second += p * d * d;
  }
  out.weight = all;
  out.participation = first * first / (all * second);
  out.spectral = second / (dot(parts[control].motion.v, live) * first);
}

/// Follows the motion until the multiplier is zero.
void follow(KinematicCurve& out, const Chain& chain, Vec3 live, std::size_t control) {
  std::vector<Place> at = chain.start();
  std::vector<kernels::Twist> motion = chain.held(at, chain.motion());
  double multiplier = chain.multiplier(at, motion);
  out.points.push_back({0.0, multiplier});
  // The first step is short; the following ones go by the slope that it has found.
  double step = kFirstStep;
  for (int n = 0; n < kMostSteps; ++n) {
    const std::vector<Place> half = moved(at, motion, 0.5 * step);
    const std::vector<kernels::Twist> middle = chain.held(half, motion);
    at = moved(at, middle, step);
    motion = chain.held(at, middle);
    const double before = multiplier, d = dot(at[control].centre - chain.start()[control].centre, live);
    multiplier = chain.multiplier(at, motion);
    if (std::isnan(multiplier) || d <= out.points.back().displacement) {
      out.none = "the mechanism does not go on along the live load: it is followed no farther";
      return;
    }
    const double from = out.points.back().displacement;
    out.points.push_back({d, multiplier});
    if (multiplier <= 0.0) {
      out.zero = from + (d - from) * before / (before - multiplier);
      out.points.back() = {out.zero, 0.0};
      return;
    }
    if (n == 0) {
      if (multiplier >= before) {
        out.none =
            "the multiplier does not fall as the mechanism moves, as of one that slides: there is no displacement at which it is zero";
        return;
      }
      step *= before / (before - multiplier) / kSteps;
    }
  }
  out.none = "the multiplier is not zero at five times the displacement to which its first slope leads";
}

}  // namespace

double KinematicCurve::at(double displacement) const {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (displacement > points[i].displacement) continue;
    const KinematicPoint &a = points[i - 1], &b = points[i];
    return a.multiplier + (b.multiplier - a.multiplier) * (displacement - a.displacement) / (b.displacement - a.displacement);
  }
  return points.back().multiplier;
}

KinematicCurve kinematic_curve(const cases::Case& c, const cases::Model& model, const LimitContacts& contacts, const LimitState& state,
                               Vec3 live) {
  KinematicCurve out;
  const Mechanism mechanism = mechanism_of(contacts, state);
  const std::vector<MechanismPart>& parts = mechanism.parts;
  out.parts = parts.size();
  std::size_t control = 0;
  for (std::size_t k = 1; k < parts.size(); ++k)  // of parts that are as fast but for round-off the first
    if (dot(parts[k].motion.v, live) > (1.0 + kAsFast) * dot(parts[control].motion.v, live)) control = k;
  if (parts.empty() || !(dot(parts[control].motion.v, live) > 0.0)) {
    out.none = "no part moves along the live load";
    return out;
  }
  out.control = parts[control].centre;
  out.sliding = static_cast<std::size_t>(std::ranges::count_if(mechanism.seams, [](const MechanismSeam& s) { return !s.hinge; }));
  take_shares(out, parts, live, control, norm(c.gravity.acceleration));
  std::size_t links = 0;
  const std::vector<std::int32_t> part_of = parts_by_body(contacts, mechanism);
  for (std::size_t k = 0; k < state.ties.size(); ++k) {
    const bool bears = std::abs(state.ties[k]) > kBears * out.weight && !is_within_a_part(contacts.ties[k], part_of);
    if (bears && std::abs(stretching(contacts.ties[k], contacts, state.motion)) < kAtRest) ++links;
  }
  if (links > 0) {
    out.points.push_back({0.0, state.multiplier});
    out.none = std::to_string(links) + " ties bear without yielding: what they hold is not followed";
    return out;
  }
  const Chain chain(c, model, contacts, mechanism, live);
  out.freedoms = chain.freedoms();
  follow(out, chain, live, control);
  return out;
}

}  // namespace voussoir::solver
