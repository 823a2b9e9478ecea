// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/live_load.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/loads/gravity.h"
#include "cases/loads/loaded_place.h"
#include "cases/loads/loads.h"
#include "cases/model.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

class Forces {
 public:
  Forces(const cases::Model& model, const LimitContacts& contacts) : model_(model), contacts_(contacts) {}

  [[nodiscard]] BodyForces none() const { return {std::vector<Vec3>(contacts_.bodies.size()), std::vector<Vec3>(contacts_.bodies.size())}; }
  void act(std::int32_t body, Vec3 where, Vec3 force, BodyForces& on) const {
    nth(on.force, body) += force;
    nth(on.moment, body) += cross(where - nth(contacts_.bodies, body).centre, force);
  }
  void add(const cases::Load& load, std::size_t index, BodyForces& on) const {
    if (load.history)
      throw cases::InputError(cases::indexed_key("load", index, "history"),
                              "does not go with limit analysis, which knows no time; allowed: force");
    if (load.path)
      throw cases::InputError(cases::indexed_key("load", index, "path"),
                              "does not go with limit analysis, which knows no time; allowed: at; voussoir limit --path tries many places");
    for (const cases::LoadShare& share : cases::load_shares(model_, load, index)) {
      const std::int32_t body = nth(contacts_.body_of, share.element);
      act(body, share.point, share.part * load.force, on);
      nth(on.moment, body) += share.part * load.moment;
    }
  }
  void add_weights(const LiveLoad& live, double gravity, BodyForces& on) const {
    std::vector<bool> loaded(contacts_.bodies.size(), live.on.empty());
    for (const std::string& name : live.on)
      for (const std::int32_t e : named(name)) nth(loaded, nth(contacts_.body_of, e)) = true;
    for (std::size_t b = 0; b < loaded.size(); ++b)
      if (loaded[b]) on.force[b] += (contacts_.bodies[b].mass * gravity) * live.direction;
  }
  void add_force(const LiveLoad& live, BodyForces& on) const {
    cases::Load load;
    load.force = live.force * live.direction, load.at = live.at;
    for (const std::string& name : live.on) {
      load.block = name;
      if (!named(name).empty()) add(load, 0, on);
    }
    if (!live.on.empty() || !live.at) return;
    const cases::LoadedPlace place = cases::place_of_load(model_, *live.at, live.direction);
    const std::int32_t body = place.element < 0 ? -1 : nth(contacts_.body_of, place.element);
    if (body < 0) throw cases::InputError("--at", "no block that can move lies there, or behind it along the force");
    act(body, place.at, load.force, on);
  }

 private:
  /// The elements of this name that can move.
  [[nodiscard]] std::vector<std::int32_t> named(const std::string& name) const {
    const std::vector<std::vector<std::int32_t>> wholes = cases::parts_named(model_, name);
    if (wholes.empty()) {
      std::vector<std::string> names;
      for (const cases::Block& b : model_.blocks) names.push_back(b.name);
      const std::string meant = cases::did_you_mean(name, names);
      throw cases::InputError("--on", cases::quoted(name) + " is the name of no block, stone or group" +
                                          (meant.empty() ? "" : "; " + meant.substr(0, meant.size() - 1)));
    }
    std::vector<std::int32_t> elements;
    for (const std::vector<std::int32_t>& parts : wholes)
      std::ranges::copy_if(parts, std::back_inserter(elements), [&](std::int32_t e) { return nth(contacts_.body_of, e) >= 0; });
    if (elements.empty()) throw cases::InputError("--on", cases::quoted(name) + " is fixed, a load cannot move it");
    return elements;
  }

  const cases::Model& model_;
  const LimitContacts& contacts_;
};

double mean_lever(const LimitContacts& c) {
  double sum = 0.0;
  for (const LimitPoint& p : c.points) sum += norm(p.at - nth(c.bodies, p.a).centre);
  return c.points.empty() ? 1.0 : sum / static_cast<double>(c.points.size());
}

bool is_nothing(const BodyForces& f) {
  const auto zero = [](Vec3 v) { return v == Vec3{}; };
  return std::ranges::all_of(f.force, zero) && std::ranges::all_of(f.moment, zero);
}

void refuse_growing(const cases::Case& c) {
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    if (c.loads[i].grows)
      throw cases::InputError(cases::indexed_key("load", i, "grows"),
                              "= true makes this load the live one; allowed beside it: no --direction, --on, --force, --at or --path");
  }
}

}  // namespace

LimitForces limit_forces(const cases::Case& c, const cases::Model& model, const LimitContacts& contacts, const LiveLoad& live) {
  const Forces forces(model, contacts);
  const Vec3 g = cases::gravity_on_base(c);
  LimitForces out{forces.none(), forces.none(), 0.0, mean_lever(contacts)};
  for (std::size_t b = 0; b < contacts.bodies.size(); ++b) {
    out.dead.force[b] += contacts.bodies[b].mass * g;
    out.weight += contacts.bodies[b].mass * norm(g);
  }
  const bool growing = live.kind == LiveLoad::Kind::loads;
  if (!growing) refuse_growing(c);
  for (std::size_t i = 0; i < c.loads.size(); ++i) forces.add(c.loads[i], i, c.loads[i].grows ? out.live : out.dead);
  if (live.kind == LiveLoad::Kind::weight) forces.add_weights(live, norm(g), out.live);
  if (live.kind == LiveLoad::Kind::force) forces.add_force(live, out.live);
  if (is_nothing(out.live)) throw cases::InputError("", growing ? "has growing loads without a force or moment" : "the live load is zero");
  return out;
}

Vec3 main_direction(const cases::Case& c, const LiveLoad& live) {
  if (live.kind != LiveLoad::Kind::loads) return live.direction;
  Vec3 sum;
  for (const cases::Load& load : c.loads)
    if (load.grows) sum += load.force;
  return norm(sum) > 0.0 ? normalised(sum) : Vec3{};
}

}  // namespace voussoir::solver
