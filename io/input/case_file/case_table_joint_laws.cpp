// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/tables/joint_laws.h"
#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/usual_ranges.h"

namespace voussoir::io {
namespace {

using namespace cases;

/// The keys of an optional law, in the order of the reference, and what they ask of each other and of the bond.
struct OptionalKeys {
  std::vector<Key<JointLaw>> keys;
  void (*check)(const JointLaw& s, const RuleCheck& check);
};

void check_softening(const JointLaw& s, const RuleCheck& check) {
  if (s.fracture_energy_tension > 0.0 && s.tension <= 0.0)
    check.fault("fracture_energy_tension", "does not go with tension = 0; allowed: 0, or with a tension above 0 Pa");
  if (s.fracture_energy_shear > 0.0 && s.cohesion <= 0.0)
    check.fault("fracture_energy_shear", "does not go with cohesion = 0; allowed: 0, or with a cohesion above 0 Pa");
  const bool softens = s.fracture_energy_tension > 0.0 || s.fracture_energy_shear > 0.0;
  // A resolved case gives every key: the default says nothing.
  if (s.softening != SofteningCurve::exponential && !softens)
    check.fault("softening", "needs fracture_energy_tension or fracture_energy_shear (J/m2, > 0)");
  if (s.dilatancy > 0.0 && s.fracture_energy_shear <= 0.0)
    check.fault("dilatancy", "needs fracture_energy_shear (J/m2, > 0), over which it dies");
  if (s.dilatancy > s.friction)
    check.fault("dilatancy", "is more than friction = " + value_text(s.friction) + " degrees; allowed: 0 to friction");
}

OptionalKeys softening_keys() {
  using S = JointLaw;
  return {{value<S>("fracture_energy_tension", &S::fracture_energy_tension, "J/m2", at_least(0.0).usually(usual::kFracture),
                    "mode I, elastic part included: more than f_t^2 / (2 k_n); 0: brittle in tension"),
           value<S>("fracture_energy_shear", &S::fracture_energy_shear, "J/m2", at_least(0.0).usually(usual::kFracture),
                    "mode II, of the cohesion alone, elastic part included: more than c^2 / (2 k_s); 0: by failure.post_shear"),
           choice<S, SofteningCurve S::*, SofteningCurve>(
               "softening", &S::softening, "", {{"exponential", SofteningCurve::exponential}, {"linear", SofteningCurve::linear}},
               "how f_t and c fall over what opens or slides"),
           value<S>("residual_friction", &S::residual_friction, "degrees", from_below(0.0, 90.0).usually(usual::kFriction),
                    "angle of friction of this joint when its bond is gone, until its faces have slid by half a segment; none: [contact]"),
           value<S>("dilatancy", &S::dilatancy, "degrees", from_below(0.0, 90.0).usually(usual::kDilatancy),
                    "angle by which the first slip under pressure opens the joint, no more than friction; dies with cohesion, needs "
                    "fracture_energy_shear")},
          check_softening};
}

void check_stiffness(const JointLaw& s, const RuleCheck& check) {
  if (!s.normal_stiffness && !s.shear_stiffness) return;
  if (!s.normal_stiffness) check.fault("normal_stiffness", "is missing: a joint with a shear_stiffness needs both (Pa/m, > 0)");
  if (!s.shear_stiffness) check.fault("shear_stiffness", "is missing: a joint with a normal_stiffness needs both (Pa/m, > 0)");
  if (s.thickness > 0.0) check.fault("thickness", "does not go with normal_stiffness; a joint has mortar with a thickness, or a stiffness");
}

OptionalKeys stiffness_keys() {
  using S = JointLaw;
  return {{value<S>("normal_stiffness", &S::normal_stiffness, "Pa/m", above(0.0).usually(usual::kJointStiffness),
                    "of the joint alone, in series with its blocks (and with one block on the base); in place of thickness; none: rigid"),
           value<S>("shear_stiffness", &S::shear_stiffness, "Pa/m", above(0.0).usually(usual::kJointStiffness),
                    "the same along the joint; both stand, or none")},
          check_stiffness};
}

void check_closure(const JointLaw& s, const RuleCheck& check) {
  if (!s.maximum_closure) return;
  if (!s.normal_stiffness) check.fault("maximum_closure", "needs normal_stiffness (Pa/m, > 0), that of the joint without pressure");
  if (s.tension > 0.0 || s.cohesion > 0.0)
    check.fault("maximum_closure", "is of a dry joint, without a bond; allowed with tension = 0 and cohesion = 0 alone");
}

OptionalKeys closing_keys() {
  using S = JointLaw;
  return {
      {value<S>(
          "maximum_closure", &S::maximum_closure, "m", above(0.0).usually(usual::kClosure),
          "largest closure of a dry joint (Bandis' hyperbola): its stiffness grows from normal_stiffness, without pressure; friction is "
          "residual_friction or that of [contact]; none: one stiffness")},
      check_closure};
}

const std::vector<OptionalKeys>& optional_keys() {
  static const std::vector<OptionalKeys> kLaws = {softening_keys(), stiffness_keys(), closing_keys()};
  return kLaws;
}

std::vector<Key<JointLaw>> bond_keys() {
  using S = JointLaw;
  return {required(value<S>("tension", &S::tension, "Pa", at_least(0.0).usually(usual::kStrength), "tensile strength f_t")),
          required(value<S>("cohesion", &S::cohesion, "Pa", at_least(0.0).usually(usual::kStrength), "cohesion c")),
          required(value<S>("friction", &S::friction, "degrees", from_below(0.0, 90.0).usually(usual::kFriction),
                            "angle of friction phi of the bond (Eq. 6); once it is broken: [contact]")),
          required(value<S>("compression", &S::compression, "Pa", above(0.0).usually(usual::kCompression),
                            "compressive strength f_m of the bond; of contacts: contact.compression")),
          value<S>("cap", &S::cap, "", at_least(0.0).usually(usual::kCap), "C_s of the compression cap"),
          value<S>("thickness", &S::thickness, "m", at_least(0.0).usually(usual::kMortar), "of the mortar; 0: no mortar, Eq. 2"),
          value<S>("young", &S::young, "Pa", at_least(0.0).usually(usual::kMortarYoung), "Young's modulus of the mortar"),
          value<S>("poisson", &S::poisson, "", from_below(0.0, 0.5).usually(usual::kPoisson), "Poisson's ratio of the mortar")};
}

void check_mortar(const JointLaw& s, const RuleCheck& check) {
  if (s.thickness <= 0.0 && s.young > 0.0) check.doubt("young", "has no effect without the thickness of the mortar (m), or stones.gap");
  if (s.thickness <= 0.0) return;
  if (!check.given("young")) check.fault("young", "is missing: mortar with a thickness needs Young's modulus (Pa, > 0)");
  if (!check.given("poisson")) check.fault("poisson", "is missing: mortar with a thickness needs Poisson's ratio (in [0, 0.5))");
  if (check.given("young") && s.young <= 0.0) check.fault("young", "must be > 0 for mortar with a thickness");
}

}  // namespace

Table<JointLaw> joint_law_table() {
  std::vector<Key<JointLaw>> keys = bond_keys();
  for (const OptionalKeys& law : optional_keys()) keys.insert(keys.end(), law.keys.begin(), law.keys.end());
  return {"strength of a joint (Eqs. 5-7) and its mortar (Eq. 3)", std::move(keys), [](const JointLaw& s, const RuleCheck& check) {
            for (const OptionalKeys& law : optional_keys()) law.check(s, check);
            check_mortar(s, check);
          }};
}

}  // namespace voussoir::io
