// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "cases/case.h"
#include "cases/census.h"
#include "cases/loads/loads.h"
#include "cases/loads/moving_load.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/setup/laws/optional_laws.h"
#include "solver/setup/patch_order.h"
#include "solver/setup/point_sets.h"
#include "solver/setup/setup_stages.h"
#include "solver/setup/setup_ties.h"
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

/// m, by which the rectangle of a patch reaches out of the box round its element, in body axes.
double reach_beyond_box(const Elements& e, const kernels::Patch& p) {
  const auto i = static_cast<std::size_t>(p.element);
  double beyond = 0.0;
  for (const double s : {p.s_low, p.s_high}) {
    for (const double t : {p.t_low, p.t_high}) {
      const Vec3 at = p.centre + s * p.es + t * p.et;
      beyond = std::max({beyond, std::abs(at.x) - e.half_x[i], std::abs(at.y) - e.half_y[i], std::abs(at.z) - e.half_z[i]});
    }
  }
  return beyond;
}

}  // namespace

void append_patch(World& w, const kernels::Patch& patch, std::int32_t set, std::int32_t from_side, bool mastered) {
  Patches& p = w.patches;
  const auto n = static_cast<std::size_t>(nth(w.points.count, set));
  p.patch.push_back({patch, set, 0, static_cast<std::int64_t>(p.partner.size())});
  const auto e = static_cast<std::size_t>(patch.element);
  p.patch.back().face_number = static_cast<std::uint16_t>(patch.face - w.elements.first_face[e]);
  p.patch.back().face_count = static_cast<std::uint16_t>(w.elements.face_count[e]);
  p.element.push_back(patch.element);
  p.beyond = std::max(p.beyond, reach_beyond_box(w.elements, patch));
  p.from_side.push_back(from_side);
  p.mastered.push_back(mastered ? 1 : 0);
  const std::size_t end = p.partner.size() + static_cast<std::size_t>(round_up(static_cast<std::int64_t>(n), kernels::kLanes));
  p.partner.resize(end, kernels::kNobody);
  p.face.resize(end, kernels::kNoFace);
  p.springs.resize(end / kernels::kWidth);
  if (w.contact.crushing.on()) p.crushed.resize(end, 0.0);
  if (w.contact.restitution > 0.0) p.pressed.resize(end, 0.0);
}

void reserve_patches(World& w, std::size_t patches, std::size_t points) {
  Patches& p = w.patches;
  reserve_in_shares(p.patch, patches, w.team);
  reserve_in_shares(p.partner, points, w.team), reserve_in_shares(p.face, points, w.team);
  p.element.reserve(patches), p.from_side.reserve(patches), p.mastered.reserve(patches);
}

void set_up_patches(World& w) {
  const geometry::Assembly& a = w.model.assembly;
  std::int64_t points = 0;
  for (const geometry::FreePatch& f : a.patches) points += round_up(static_cast<std::int64_t>(f.segments.size()), kernels::kLanes);
  reserve_patches(w, a.patches.size(), static_cast<std::size_t>(points));
  PointSetBuilder sets(w.points);
  for (const geometry::FreePatch& p : a.patches) {
    const geometry::Element& e = nth(a.elements, p.element);
    kernels::Patch patch;
    patch.element = p.element;
    patch.face = e.first_face + p.face;
    patch.centre = p.centre - e.mass.centroid;
    patch.es = p.frame().axis_s, patch.et = p.frame().axis_t;
    patch.s_low = patch.t_low = 1e300, patch.s_high = patch.t_high = -1e300;
    for (const geometry::Segment& s : p.segments) {
      patch.s_low = std::min(patch.s_low, s.s), patch.s_high = std::max(patch.s_high, s.s);
      patch.t_low = std::min(patch.t_low, s.t), patch.t_high = std::max(patch.t_high, s.t);
    }
    append_patch(w, patch, sets.add(p.segments), -1, true);
  }
  sort_patches(w);
}

namespace {

void add_moving_load(World& w, const cases::Load& l, std::size_t i) {
  for (cases::MovingShare& m : cases::moving_shares(w.model, l, i, nth(w.model.support_motions, w.model.load_path[i]))) {
    const Vec3 centre = nth(w.model.assembly.elements, m.share.element).mass.centroid;
    w.moving_forces.push_back(std::make_shared<cases::SupportHistory>(std::move(m.force)));
    PointLoad p;
    p.element = m.share.element, p.arm = m.share.point - centre, p.history = w.moving_forces.back().get(), p.follows = l.follows;
    p.moves = true, p.load = static_cast<std::int32_t>(i);
    w.loads.push_back(p);
  }
}

}  // namespace

void set_up_loads(World& w, const cases::Case& c) {
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    const cases::Load& l = c.loads[i];
    if (l.path) {
      add_moving_load(w, l, i);
      continue;
    }
    for (const cases::LoadShare& s : cases::load_shares(w.model, l, i)) {
      const Vec3 centre = nth(w.model.assembly.elements, s.element).mass.centroid;
      PointLoad p{s.element, s.part * l.force, s.part * l.moment, s.point - centre, l.ramp[0], l.ramp[1],
                  nullptr,   l.follows,        l.grows,           s.part,           false,     static_cast<std::int32_t>(i)};
      if (const std::int32_t h = l.history ? w.model.load_history[i] : -1; h >= 0) p.history = &nth(w.model.support_motions, h);
      w.loads.push_back(p);
    }
  }
  for (std::size_t i = 0; i < w.model.blocks.size(); ++i) {
    const std::int32_t history = w.model.blocks[i].support_motion;
    if (history >= 0) w.supports.push_back({static_cast<std::int32_t>(i), &nth(w.model.support_motions, history)});
  }
}

namespace {

double dashpot_excess(const cases::Contact& c) { return c.dashpots == cases::Dashpots::bounded ? kernels::kBounded : kernels::kUnbounded; }

kernels::FailureOptions failure_options(const cases::Failure& f, const cases::Contact& contact) {
  kernels::FailureOptions o;
  o.dashpot_excess = dashpot_excess(contact);
  o.shear = f.shear;
  o.brittle = f.post_shear == cases::PostShear::brittle;
  o.in_tension = f.shear_in_tension == cases::ShearInTension::cohesion ? kernels::ShearInTension::cohesion
                 : f.shear_in_tension == cases::ShearInTension::none   ? kernels::ShearInTension::none
                                                                       : kernels::ShearInTension::coulomb;
  return o;
}

/// Under half the smallest segment: by the rule of centres coplanar neighbours in an intact wall, whose points lie half a segment apart,
/// are no candidates then.
double choose_skin(const cases::Model& m) {
  double smallest = 1e300;
  for (const cases::Block& b : m.blocks) smallest = std::min(smallest, b.segment_size);
  return 0.4 * smallest;
}

void set_up_step(World& w, const cases::Case& c) {
  w.bound = cases::census(w.model).step_bound;
  w.dt = choose_step(c, w.options, w.bound);
}

void set_up_friction(World& w, const cases::Case& c) {
  const cases::Model& m = w.model;
  for (const double angle : m.contact_friction) w.friction.push_back(std::tan(angle * std::numbers::pi / 180.0));
  w.contact = {.step = w.dt,
               .damping = c.contact.damping,
               .friction = {w.friction.data(), static_cast<std::int32_t>(m.materials.size()) + 1},
               .master_normal = c.contact.normal == cases::ContactNormal::master};
  w.contact.crossed_faces = m.assembly.rule == geometry::SegmentRule::centres;
  w.contact.crushing = crushing_of(c.contact);
  w.contact.dashpot_excess = dashpot_excess(c.contact);
  w.contact.restitution = c.contact.restitution.value_or(0.0);
}

void set_up_laws(World& w, const cases::Case& c) {
  for (const OptionalLaw& law : optional_laws()) law.set_up(w, c);
}

void choose_ties(World& w, const cases::Case& c) { cases::finds_rest(c.analysis) ? set_up_stiff_ties(w) : set_up_ties(w); }

void set_up_travel(World& w, const cases::Case& /*c*/) {
  // With several rates all else is faster, so searches weigh more, and reaches of their own pay.
  constexpr double kAhead = 0.01;  // s
  w.travel = Travel(w.elements, choose_skin(w.model), w.multirate.wanted > 1 ? kAhead : 0.0);
  w.travel.set_margin(search_margin(w, w.travel.skin()));
}

/// A stage that needs nothing of the case.
template <void (*stage)(World&)>
void without_case(World& w, const cases::Case& /*c*/) {
  stage(w);
}

using namespace part;

constexpr SetUpStage kStages[] = {
    {"step", 0, kStep, set_up_step},
    {"friction", kStep, kFriction, set_up_friction},
    {"elements", 0, kElements, set_up_elements},
    {"faces", 0, kFaces, without_case<set_up_faces>},
    {"bound of dashpots", kElements | kFaces | kFriction, kDashpotBound, without_case<set_up_damping_bound>},
    {"levels", kStep | kElements, kLevels, set_up_multirate},
    {"sides", kStep | kFriction | kElements | kFaces | kDashpotBound | kLevels, kSides, set_up_sides},
    {"patches", kFriction | kElements | kSides, kPatches, without_case<set_up_patches>},
    {"views of sides", kSides | kPatches, kSideViews, without_case<set_up_side_views>},
    {"overlaps", kFriction | kElements | kFaces | kSides, kShapes, without_case<set_up_overlaps>},
    {"optional laws", kFriction | kFaces | kSides | kSideViews, kLaws, set_up_laws},
    {"forces of sides", kElements | kSides, kPairBuffer, set_up_pair_forces},
    {"ties", kStep | kElements | kSides | kSideViews, kTies, choose_ties},
    {"loads", 0, kLoads, set_up_loads},
    {"travel", kStep | kElements | kLevels, kTravel, set_up_travel},
};
static_assert(in_order(kStages), "a stage of the set-up comes before what it needs");

}  // namespace

std::span<const SetUpStage> setup_stages() { return kStages; }

std::unique_ptr<World> build_world(const cases::Case& c, const cases::Model& m, const Options& o, std::span<const SetUpStage> stages) {
  auto w = std::make_unique<World>(m);
  w->options = o;
  w->team.set_size(o.threads);
  w->out_of_cache = m.blocks.size() >= o.out_of_cache_from;
  w->failure = failure_options(c.failure, c.contact);
  w->has_base = c.base.has_value();
  w->drop_debris_damping = !c.damping.debris;
  for (const SetUpStage& stage : stages) stage.run(*w, c);
  return w;
}

std::unique_ptr<World> build_world(const cases::Case& c, const cases::Model& m, const Options& o) { return build_world(c, m, o, kStages); }

}  // namespace voussoir::solver
