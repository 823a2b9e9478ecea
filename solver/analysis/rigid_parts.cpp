// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/rigid_parts.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <set>
#include <tuple>

#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kRadius = 0.01;     // m, of gyration that an element counts with: what lies on a line has a definite turn
constexpr double kBaseWeight = 1e6;  // of all mass: what is part of the base does not move

/// Elements, and the least squares of a rigid motion over them: of mass × (displacement − v − w × centre)².
struct Part {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double square = 0.0;  // of the displacements
  double left = 0.0;    // of them, what the best rigid motion leaves
  std::set<std::int32_t> neighbours;
  int version = 0;  // how often it has grown; −1: it is part of another

  [[nodiscard]] double left_with(const Part& other) const {
    const Matrix6 n = normal + other.normal;
    const Vector6 r = right + other.right;
    return std::max(0.0, square + other.square - r.dot(n.llt().solve(r)));
  }
};

struct Union {
  double cost = 0.0;  // what it leaves more than its two parts
  std::int32_t a = 0, b = 0;
  int version_a = 0, version_b = 0;
  bool operator>(const Union& o) const { return std::tie(cost, a, b) > std::tie(o.cost, o.a, o.b); }
};

class Parts {
 public:
  explicit Parts(const ElementMotion& m) : parts_(m.mass.size() + 1), part_of_(m.mass.size() + 1) {
    Vec3 middle;
    double all = 0.0;
    for (std::size_t e = 0; e < m.mass.size(); ++e) middle += m.mass[e] * m.centre[e], all += m.mass[e];
    if (all > 0.0) middle = middle / all;
    for (std::size_t e = 0; e < m.mass.size(); ++e) add(m.mass[e], m.centre[e] - middle, m.displacement[e], parts_[e]);
    parts_.back().normal = kBaseWeight * std::max(all, 1.0) * Matrix6::Identity();
    for (std::size_t e = 0; e < parts_.size(); ++e) {
      part_of_[e] = static_cast<std::int32_t>(e);
      if (e < m.mass.size() && m.mass[e] > 0.0) parts_[e].left = parts_[e].left_with({});
      square_ += parts_[e].square, left_ += parts_[e].left;
    }
    const auto base = static_cast<std::int32_t>(m.mass.size());
    for (const auto& [a, b] : m.touching) join(a < 0 ? base : a, b < 0 ? base : b, m);
  }

  void merge(double misfit) {
    for (std::size_t a = 0; a < parts_.size(); ++a)
      for (const std::int32_t b : parts_[a].neighbours)
        if (static_cast<std::int32_t>(a) < b) propose(static_cast<std::int32_t>(a), b);
    while (!unions_.empty()) {
      const Union u = unions_.top();
      unions_.pop();
      if (at(u.a).version != u.version_a || at(u.b).version != u.version_b) continue;
      if (left_ + u.cost > misfit * misfit * square_) return;
      left_ += u.cost;
      unite(u);
    }
  }

  [[nodiscard]] std::vector<std::int32_t> result(const std::vector<double>& mass) {
    const std::int32_t base = root(static_cast<std::int32_t>(mass.size()));
    std::vector<std::int32_t> least(parts_.size(), -1), out(mass.size(), -1);
    for (std::size_t e = 0; e < mass.size(); ++e) {
      const std::int32_t r = root(static_cast<std::int32_t>(e));
      if (r == base || mass[e] <= 0.0) continue;
      auto& first = nth(least, r);
      if (first < 0) first = static_cast<std::int32_t>(e);
      out[e] = first;
    }
    return out;
  }

 private:
  Part& at(std::int32_t i) { return nth(parts_, i); }
  std::int32_t root(std::int32_t i) {
    while (nth(part_of_, i) != i) i = nth(part_of_, i);
    return i;
  }
  static void add(double mass, Vec3 x, Vec3 d, Part& p) {
    if (mass <= 0.0) return;
    Eigen::Matrix<double, 3, 6> rigid;  // of (v, w): v + w × x
    rigid << 1, 0, 0, 0, x.z, -x.y, 0, 1, 0, -x.z, 0, x.x, 0, 0, 1, x.y, -x.x, 0;
    const Eigen::Vector3d moved(d.x, d.y, d.z);
    p.normal = mass * rigid.transpose() * rigid;
    p.normal.bottomRightCorner<3, 3>().diagonal().array() += mass * kRadius * kRadius;
    p.right = mass * rigid.transpose() * moved;
    p.square = mass * moved.squaredNorm();
  }
  void join(std::int32_t a, std::int32_t b, const ElementMotion& m) {
    const auto moves = [&](std::int32_t e) { return static_cast<std::size_t>(e) >= m.mass.size() || nth(m.mass, e) > 0.0; };
    if (a == b || !moves(a) || !moves(b)) return;
    at(a).neighbours.insert(b), at(b).neighbours.insert(a);
  }
  void propose(std::int32_t a, std::int32_t b) {
    if (a > b) std::swap(a, b);
    const Part &p = at(a), &q = at(b);
    unions_.push({std::max(0.0, p.left_with(q) - p.left - q.left), a, b, p.version, q.version});
  }
  void unite(const Union& u) {
    Part &p = at(u.a), &q = at(u.b);
    p.normal += q.normal, p.right += q.right, p.square += q.square, p.left += q.left + u.cost;
    ++p.version, q.version = -1;
    nth(part_of_, u.b) = u.a;
    p.neighbours.erase(u.b);
    for (const std::int32_t n : q.neighbours) {
      if (n == u.a) continue;
      at(n).neighbours.erase(u.b), at(n).neighbours.insert(u.a);
      p.neighbours.insert(n);
    }
    q.neighbours.clear();
    for (const std::int32_t n : p.neighbours) propose(u.a, n);
  }

  std::vector<Part> parts_;  // by their least element; the last is the base
  std::vector<std::int32_t> part_of_;
  std::priority_queue<Union, std::vector<Union>, std::greater<>> unions_;
  double square_ = 0.0, left_ = 0.0;
};

}  // namespace

std::vector<std::int32_t> rigid_parts(const ElementMotion& motion, double misfit) {
  Parts parts(motion);
  parts.merge(misfit);
  return parts.result(motion.mass);
}

}  // namespace voussoir::solver
