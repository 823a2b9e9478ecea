// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/limit_words.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "io/output/assess/limit_parts.h"
#include "solver/limit/kinematics/mechanism.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kTurns = 0.02;         // of its speed: a part slides if rotation moves its farthest point by no more than this
constexpr std::size_t kNames = 3;       // number of element names in a line
constexpr std::size_t kMostLines = 12;  // of parts, of seams

using geometry::printed;

double tilt(double multiplier) { return std::atan(multiplier) * 180.0 / std::numbers::pi; }

std::vector<std::int32_t> elements_of(const solver::MechanismPart& part, const solver::LimitContacts& c) {
  std::vector<std::int32_t> all;
  for (const std::int32_t b : part.bodies) {
    const auto& elements = nth(c.bodies, b).elements;
    all.insert(all.end(), elements.begin(), elements.end());
  }
  std::ranges::sort(all);
  return all;
}

/// Elements in words: "front wall, 412 elements", "b3, b4, b5 and 2 more".
std::string what(const std::vector<std::int32_t>& elements, const cases::Model& model) {
  std::map<std::string, std::size_t> tags;
  for (const std::int32_t e : elements) ++tags[nth(model.blocks, e).tag];
  if (tags.size() < elements.size()) {
    const auto most = std::ranges::max_element(tags, {}, [](const auto& t) { return t.second; });
    return most->first + (tags.size() > 1 ? " and others, " : ", ") + std::to_string(elements.size()) + " elements";
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(kNames, elements.size()); ++i) text += (i == 0 ? "" : ", ") + nth(model.blocks, elements[i]).tag;
  return elements.size() > kNames ? text + " and " + std::to_string(elements.size() - kNames) + " more" : text;
}

std::string vector(Vec3 v) {
  const auto flat = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  return printed("(%.3f, %.3f, %.3f)", flat(v.x), flat(v.y), flat(v.z));
}

/// The point of a part's axis of rotation nearest to its centre of mass.
Vec3 axis_point(const solver::MechanismPart& p) {
  const Vec3 w = p.motion.w;
  return p.centre + cross(w, p.motion.v) / dot(w, w);
}

double reach(const solver::MechanismPart& part, const cases::Model& model, const solver::LimitContacts& c) {
  double most = 0.0;
  for (const std::int32_t e : elements_of(part, c))
    for (const Vec3 v : nth(model.blocks, e).shape.vertices) most = std::max(most, norm(v - part.centre));
  return most;
}

bool turns(const solver::MechanismPart& part, const cases::Model& model, const solver::LimitContacts& c) {
  return norm(part.motion.w) * reach(part, model, c) > kTurns * norm(part.motion.v);
}

std::string motion(const solver::MechanismPart& part, const cases::Model& model, const solver::LimitContacts& c) {
  if (!turns(part, model, c)) return "slides along " + vector(part.motion.v / norm(part.motion.v));
  const Vec3 w = part.motion.w, along = w / norm(w);
  const double screw = std::abs(dot(part.motion.v, along));
  return "turns about " + vector(along) + " through " + vector(model.origin + axis_point(part)) +
         (screw > kTurns * norm(part.motion.v) ? ", and moves along it" : "");
}

std::string name_of(std::int32_t part) { return part < 0 ? "ground" : "part " + std::to_string(part + 1); }

std::string seam_words(const solver::MechanismSeam& s) {
  const char* how = s.hinge && s.slide < 0.1 * s.open ? "hinge" : s.open < 0.1 * s.slide ? "sliding" : "opening and sliding";
  return printed("%s and %s: %s, %d joints, opens at %.3f, slides at %.3f", name_of(s.a).c_str(), name_of(s.b).c_str(), how, s.joints,
                 s.open, s.slide);
}

void print_state(std::string& out, const char* rule, const solver::LimitState& s, const cases::Model& model,
                 const solver::LimitContacts& c) {
  const solver::Mechanism m = solver::mechanism_of(c, s);
  double all = m.standing;
  for (const solver::MechanismPart& p : m.parts) all += p.mass;
  out += printed("\nmechanism, %s: %zu parts move, %.1f %% of the mass stands\n", rule, m.parts.size(), 100.0 * m.standing / all);
  const std::string moving = moving_parts(s, model, c);
  out += moving + (moving.empty() ? "" : "\n");
  for (std::size_t k = 0; k < std::min(kMostLines, m.parts.size()); ++k) {
    const solver::MechanismPart& p = m.parts[k];
    out +=
        printed("part %-4zu %5.1f %%  ", k + 1, 100.0 * p.mass / all) + what(elements_of(p, c), model) + ": " + motion(p, model, c) + "\n";
  }
  if (m.parts.size() > kMostLines) out += printed("          and %zu smaller ones\n", m.parts.size() - kMostLines);
  for (std::size_t k = 0; k < std::min(kMostLines, m.seams.size()); ++k) out += "  " + seam_words(m.seams[k]) + "\n";
  if (m.seams.size() > kMostLines) out += printed("  and %zu more\n", m.seams.size() - kMostLines);
}

constexpr double kBears = 1e-6;  // N, relative to the weight of all bodies: a tie that bears less bears nothing

/// The ties that bear: "2 of 4 bear: west rod 25.00 kN, it yields; east rod 3.10 kN".
std::string tie_words(const solver::LimitState& s, const cases::Model& model, const solver::LimitResult& r) {
  std::vector<std::string> rods;
  std::size_t bars = 0, all_bars = 0;
  for (std::size_t k = 0; k < r.contacts.ties.size(); ++k) {
    const cases::TieBar& bar = nth(model.ties, r.contacts.ties[k].number);
    const bool bears = std::abs(s.ties[k]) > kBears * r.weight;
    if (bar.mesh >= 0) ++all_bars, bars += bears ? 1 : 0;
    if (bar.mesh < 0 && bears)
      rods.push_back(bar.name + printed(" %.2f kN", 1e-3 * s.ties[k]) +
                     (std::abs(s.ties[k]) > (1.0 - 1e-6) * bar.yield ? ", it yields" : ""));
  }
  std::string out = std::to_string(rods.size() + bars) + " of " + std::to_string(s.ties.size()) + " bear";
  for (std::size_t k = 0; k < std::min(kMostLines, rods.size()); ++k) out += (k == 0 ? ": " : "; ") + rods[k];
  if (rods.size() > kMostLines) out += printed("; and %zu more", rods.size() - kMostLines);
  if (all_bars > 0) out += (rods.empty() ? ": " : "; ") + printed("%zu of %zu bars of decks and meshes", bars, all_bars);
  return out;
}

/// Of each separate tie its force and how fast it gets longer, and of decks and meshes how many bars bear.
void put_ties(Json& out, const solver::LimitState& s, const cases::Model& model, const solver::LimitResult& r) {
  std::size_t bars = 0;
  out["ties"] = Json::array();
  for (std::size_t k = 0; k < s.ties.size(); ++k) {
    const solver::LimitTie& tie = r.contacts.ties[k];
    const cases::TieBar& bar = nth(model.ties, tie.number);
    if (bar.mesh >= 0) {
      bars += std::abs(s.ties[k]) > kBears * r.weight ? 1 : 0;
      continue;
    }
    out["ties"].push_back({{"name", bar.name}, {"force", s.ties[k]}, {"lengthens", solver::stretching(tie, r.contacts, s.motion)}});
  }
  out["mesh_bars"] = bars;
}

Json json_of(Vec3 v) { return {v.x, v.y, v.z}; }

Json proof_json(const solver::LimitProof& p) {
  return {{"holds", p.holds},
          {"lower", p.lower},
          {"upper", p.upper},
          {"unbalanced", p.forces.unbalanced},
          {"tension", p.forces.tension},
          {"over_friction", p.forces.over_friction},
          {"off_joint", p.forces.off_joint},
          {"over_yield", p.forces.over_yield},
          {"stretch", p.motion.stretch},
          {"overlap", p.motion.overlap},
          {"off_normal", p.motion.off_normal},
          {"lost_power", p.lost_power}};
}

Json state_json(const solver::LimitState& s, const cases::Model& model, const solver::LimitResult& r) {
  const solver::LimitContacts& c = r.contacts;
  const solver::Mechanism m = solver::mechanism_of(c, s);
  Json out{{"multiplier", s.multiplier},   {"tilt", r.is_tilt ? Json(tilt(s.multiplier)) : Json()},
           {"programmes", s.programmes},   {"last_change", s.last_change},
           {"proof", proof_json(s.proof)}, {"standing_mass", m.standing},
           {"parts", Json::array()},       {"seams", Json::array()}};
  for (const solver::MechanismPart& p : m.parts) {
    const std::vector<std::int32_t> elements = elements_of(p, c);
    out["parts"].push_back({{"mass", p.mass},
                            {"centre", json_of(model.origin + p.centre)},
                            {"velocity", json_of(p.motion.v)},
                            {"rotation", json_of(p.motion.w)},
                            {"what", what(elements, model)},
                            {"motion", motion(p, model, c)},
                            {"elements", elements}});
  }
  for (const solver::MechanismSeam& seam : m.seams)
    out["seams"].push_back({{"a", seam.a + 1},
                            {"b", seam.b + 1},
                            {"joints", seam.joints},
                            {"opens", seam.open},
                            {"slides", seam.slide},
                            {"hinge", seam.hinge}});
  if (!s.ties.empty()) put_ties(out, s, model, r);
  return out;
}

/// Figures of a proof: static and kinematic bounds, and their residuals.
std::string associated_proof(const solver::LimitProof& p) {
  return printed("forces for %.6f, a mechanism for %.6f: gap %.1g; forces off by %.1g of a mean weight, mechanism by %.1g of its speed",
                 p.lower, p.upper, std::abs(p.upper - p.lower), p.forces.worst(), std::max(p.motion.off_normal, 0.0));
}

std::string coulomb_proof(const solver::LimitProof& p) {
  return printed("this mechanism moves from %.6f to %.6f, by the forces before; forces off by %.1g of a mean weight, mechanism by %.1g",
                 p.lower, p.upper, p.forces.worst(), std::max({p.motion.overlap, p.lost_power, 0.0}));
}

std::string loaded_block(const solver::LoadPosition& p, const cases::Model& model) {
  const auto e = static_cast<std::size_t>(p.place.element);
  return cases::describe(model.blocks[e], e);
}

/// Appends a line for each position of the load.
void print_path(std::string& out, const solver::LoadPath& path, bool coulomb, const cases::Model& model) {
  out += "place                              associated   Coulomb   acts on\n";
  for (std::size_t k = 0; k < path.positions.size(); ++k) {
    const solver::LoadPosition& p = path.positions[k];
    const Vec3 at = model.origin + (p.place.element < 0 ? p.from : p.place.at);
    const int digits = model.origin == Vec3{} ? 4 : 11;  // far off, four tell no place
    out += printed("(%9.*g, %9.*g, %9.*g)  ", digits, at.x, digits, at.y, digits, at.z);
    if (p.place.element < 0) {
      out += "meets nothing that can move\n";
    } else if (!p.found) {
      out += "nothing falls, whatever the force: " + loaded_block(p, model) + "\n";
    } else {
      const std::string second = !coulomb ? "" : p.found->coulomb_proven() ? printed("%.5f", p.found->coulomb.multiplier) : "not found";
      out += printed("%12.5f %9s   ", p.found->associated.multiplier, second.c_str()) + loaded_block(p, model) +
             (k == path.weakest ? "  <- weakest\n" : "\n");
    }
  }
  out += "\nwhere it is weakest\n";
}

Json path_json(const solver::LoadPath& path, bool coulomb, const cases::Model& model) {
  Json all = Json::array();
  for (const solver::LoadPosition& p : path.positions) {
    const bool meets = p.place.element >= 0;
    const Json second = coulomb && p.found && p.found->coulomb_proven() ? Json(p.found->coulomb.multiplier) : Json();
    all.push_back({{"at", json_of(model.origin + (meets ? p.place.at : p.from))},
                   {"block", meets ? Json(loaded_block(p, model)) : Json()},
                   {"associated", p.found ? Json(p.found->associated.multiplier) : Json()},
                   {"coulomb", second}});
  }
  return all;
}

void csv_of(std::string& out, const char* rule, const solver::LimitState& s, const cases::Model& model, const solver::LimitContacts& c) {
  const solver::Mechanism m = solver::mechanism_of(c, s);
  std::vector<std::size_t> part(model.blocks.size(), 0);
  for (std::size_t k = 0; k < m.parts.size(); ++k)
    for (const std::int32_t e : elements_of(m.parts[k], c)) nth(part, e) = k + 1;
  for (std::size_t e = 0; e < model.blocks.size(); ++e) {
    const std::int32_t body = c.body_of[e];
    Vec3 v, w;
    if (body >= 0) {
      const kernels::Twist& t = nth(s.motion, body);
      w = t.w;
      v = t.v + cross(t.w, model.assembly.elements[e].mass.centroid - nth(c.bodies, body).centre);
    }
    std::string tag = model.blocks[e].tag;
    std::ranges::replace(tag, '"', '\'');
    out += printed("%s,%zu,\"%s\",%zu,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g\n", rule, e, tag.c_str(), part[e], v.x, v.y, v.z, w.x, w.y, w.z);
  }
}

}  // namespace

std::vector<Kinematics> kinematics_of(const LimitQuestion& asked, const cases::Case& c, const cases::Model& model,
                                      const solver::LimitResult& found) {
  std::vector<Kinematics> all;
  if (!asked.kinematic) return all;
  const auto follow = [&](const char* rule, const solver::LimitState& s) {
    Kinematics k{rule, solver::kinematic_curve(c, model, found.contacts, s, asked.options.live.direction), {}};
    k.check = check_kinematics(k.curve, *asked.kinematic, norm(c.gravity.acceleration));
    all.push_back(std::move(k));
  };
  follow("associated", found.associated);
  if (asked.options.coulomb && found.coulomb_proven()) follow("Coulomb", found.coulomb);
  return all;
}

std::string limit_text(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& r, const solver::LoadPath* path,
                       const std::vector<Kinematics>& kinematics) {
  std::string out = asked.title + "\n\n";
  const auto put = [&](const char* name, const std::string& value) { out += printed("%-25s", name) + value + "\n"; };
  put("live load", asked.live);
  if (path != nullptr) print_path(out, *path, asked.options.coulomb, model);
  put("bodies, contact points",
      std::to_string(r.contacts.bodies.size()) + ", " + std::to_string(r.contacts.points.size()) + (r.plane ? ", in a plane" : ""));
  put("friction cone", r.plane ? std::string("exact")
                               : printed("%d facets %s it: friction is too %s by up to %.2f %%", asked.options.facets,
                                         asked.options.outer ? "round" : "in", asked.options.outer ? "high" : "low", 100.0 * r.cone_error));
  if (r.contacts.bonded > 0) put("bonds", std::to_string(r.contacts.bonded) + " joints have tension or cohesion, which is not counted");
  if (r.has_loads) put("loads", "those of the case act in full and do not grow");
  const auto multiplier = [&](const solver::LimitState& s) {
    return printed("%.5f", s.multiplier) + (!r.is_tilt ? "" : printed(", as on a base tilted by %.3f degrees", tilt(s.multiplier)));
  };
  put("multiplier, associated", multiplier(r.associated) + "; no mechanism of Coulomb's friction has a higher one");
  put("proof", associated_proof(r.associated.proof));
  if (r.associated.proof.wide) put("not proven", "last digits of the associated multiplier: it lies between these two");
  const bool both = asked.options.coulomb;
  if (!r.associated.ties.empty()) put("ties", tie_words(r.associated, model, r));
  put("multiplier, Coulomb", !both                ? "not asked for (--associated)"
                             : r.coulomb_proven() ? multiplier(r.coulomb) + "; one of perhaps several, the order of blocks may give another"
                                                  : "NOT found: no forces and mechanism prove one; it is at most the associated one");
  if (both && r.coulomb_proven()) put("proof", coulomb_proof(r.coulomb.proof));
  if (both && r.coulomb_proven() && !r.coulomb.ties.empty()) put("ties", tie_words(r.coulomb, model, r));
  put("programmes", std::to_string(r.associated.programmes + r.coulomb.programmes));
  print_state(out, "associated", r.associated, model, r.contacts);
  if (both && r.coulomb_proven()) print_state(out, "Coulomb", r.coulomb, model, r.contacts);
  for (const Kinematics& k : kinematics) out += kinematic_text(k.curve, *asked.kinematic, k.check, k.rule, model.origin);
  return out;
}

std::string limit_json(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& r, const solver::LoadPath* path,
                       const std::vector<Kinematics>& kinematics) {
  Json out{{"title", asked.title},
           {"live", asked.live},
           {"direction", json_of(asked.options.live.direction)},
           {"bodies", r.contacts.bodies.size()},
           {"points", r.contacts.points.size()},
           {"plane", r.plane},
           {"facets", r.plane ? 2 : asked.options.facets},
           {"cone", r.plane               ? "exact"
                    : asked.options.outer ? "outer"
                                          : "inner"},
           {"cone_error", r.cone_error},
           {"weight", r.weight},
           {"mortar_joints", r.contacts.bonded},
           {"loads", r.has_loads},
           {"converged", !asked.options.coulomb || r.coulomb_proven()},
           {"associated", state_json(r.associated, model, r)},
           {"coulomb", asked.options.coulomb ? state_json(r.coulomb, model, r) : Json()}};
  for (const Kinematics& k : kinematics)
    out[k.rule == "Coulomb" ? "coulomb" : "associated"]["kinematic"] =
        Json::parse(kinematic_json(k.curve, *asked.kinematic, k.check, model.origin));
  if (path != nullptr) out["positions"] = path_json(*path, asked.options.coulomb, model), out["weakest"] = *path->weakest;
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string limit_csv(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& r) {
  std::string out = "flow,element,tag,part,vx,vy,vz,wx,wy,wz\n";
  csv_of(out, "associated", r.associated, model, r.contacts);
  if (asked.options.coulomb) csv_of(out, "coulomb", r.coulomb, model, r.contacts);
  return out;
}

}  // namespace voussoir::io
