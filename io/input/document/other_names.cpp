// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/document/other_names.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace voussoir::io {
namespace {

struct OtherName {
  std::string_view name, key;  // the name in lower case, without underscores
};

/// Where a name stands for several keys, the first one that the table of the case knows is suggested.
constexpr std::array kNames{
    OtherName{"e", "young"},
    OtherName{"modulus", "young"},
    OtherName{"emodulus", "young"},
    OtherName{"elasticmodulus", "young"},
    OtherName{"elasticity", "young"},
    OtherName{"stiffness", "normal_stiffness"},
    OtherName{"kn", "normal_stiffness"},
    OtherName{"ks", "shear_stiffness"},
    OtherName{"nu", "poisson"},
    OtherName{"rho", "density"},
    OtherName{"unitweight", "density"},
    OtherName{"weight", "density"},
    OtherName{"gamma", "density"},
    OtherName{"c", "cohesion"},
    OtherName{"fv0", "cohesion"},
    OtherName{"shearstrength", "cohesion"},
    OtherName{"ft", "tension"},
    OtherName{"tensile", "tension"},
    OtherName{"tensilestrength", "tension"},
    OtherName{"fc", "compression"},
    OtherName{"fm", "compression"},
    OtherName{"compressive", "compression"},
    OtherName{"compressivestrength", "compression"},
    OtherName{"phi", "friction"},
    OtherName{"mu", "friction"},
    OtherName{"angle", "friction"},
    OtherName{"magnitude", "force"},
    OtherName{"direction", "force"},
    OtherName{"value", "force"},
    OtherName{"vector", "force"},
    OtherName{"size", "inner_size"},
    OtherName{"plan", "inner_size"},
    OtherName{"length", "inner_size"},
    OtherName{"position", "at"},
    OtherName{"point", "at"},
    OtherName{"location", "at"},
    OtherName{"place", "at"},
    OtherName{"thickness", "bearing_wall"},
    OtherName{"wallthickness", "bearing_wall"},
    OtherName{"levels", "heights"},
    OtherName{"diameter", "area"},
    OtherName{"section", "area"},
    OtherName{"fy", "yield"},
    OtherName{"prestress", "pretension"},
    OtherName{"ultimatestrain", "elongation"},
    OtherName{"dt", "step"},
    OtherName{"timestep", "step"},
    OtherName{"end", "duration"},
    OtherName{"pga", "intensity"},
    OtherName{"file", "record"},
    OtherName{"factor", "scale"},
    OtherName{"type", "kind"},
    OtherName{"method", "solver"},
    OtherName{"xi", "ratio"},
    OtherName{"zeta", "ratio"},
};

}  // namespace

std::string meant_key(std::string_view name, const std::vector<std::string>& allowed) {
  std::string small;
  for (const char c : name) {
    if (c != '_' && c != '-' && c != ' ') small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (const OtherName& other : kNames) {
    if (other.name == small && std::ranges::find(allowed, other.key) != allowed.end()) return std::string(other.key);
  }
  return "";
}

}  // namespace voussoir::io
