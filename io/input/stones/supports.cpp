// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/supports.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "cases/case.h"
#include "io/input/stones/raw_stones.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

using cases::Stone;
using cases::StonesSpec;
using Kind = cases::StoneSupports::Kind;

double lowest(const Stone& s) {
  double z = std::numeric_limits<double>::infinity();
  for (const cases::StonePiece& p : s.pieces) z = std::min(z, geometry::bounds(p.shape).low.z);
  return z;
}

bool is_called(const Stone& s, const std::string& name) {
  return s.name == name || std::find(s.groups.begin(), s.groups.end(), name) != s.groups.end();
}

void fix_where(StonesSpec& spec, const std::function<bool(const Stone&)>& is_support) {
  for (Stone& s : spec.stones) s.fixed = is_support(s);
}

void fix_on_ground(StonesSpec& spec) {
  double ground = std::numeric_limits<double>::infinity();
  for (const Stone& s : spec.stones) ground = std::min(ground, lowest(s));
  fix_where(spec, [&](const Stone& s) { return lowest(s) <= ground + std::max(spec.snap, 1e-6); });
}

void fix_named(StonesSpec& spec, const std::string& key) {
  const auto& names = spec.supports.names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::none_of(spec.stones.begin(), spec.stones.end(), [&](const Stone& s) { return is_called(s, names[i]); }))
      throw cases::InputError(key + ".supports[" + std::to_string(i) + "]",
                              quoted_word(names[i]) + " is no stone or group of " + quoted_word(spec.file));
  }
  fix_where(spec, [&](const Stone& s) { return std::any_of(names.begin(), names.end(), [&](const auto& n) { return is_called(s, n); }); });
}

bool has_fixed(const StonesSpec& spec) {
  return std::any_of(spec.stones.begin(), spec.stones.end(), [](const Stone& s) { return s.fixed; });
}

}  // namespace

void choose_supports(cases::Case& c) {
  for (std::size_t i = 0; i < c.stones.size(); ++i) {
    StonesSpec& spec = c.stones[i];
    switch (spec.supports.kind) {
      case Kind::ground:
        fix_on_ground(spec);
        break;
      case Kind::none:
        fix_where(spec, [](const Stone&) { return false; });
        break;
      case Kind::below:
        fix_where(spec, [&](const Stone& s) { return lowest(s) < spec.supports.level; });
        break;
      case Kind::named:
        fix_named(spec, "stones[" + std::to_string(i) + "]");
        break;
      case Kind::automatic:
        break;  // the marks in the file
    }
  }
  const bool held = c.base || std::any_of(c.blocks.begin(), c.blocks.end(), [](const cases::BlockSpec& b) { return b.fixed; }) ||
                    std::any_of(c.stones.begin(), c.stones.end(), has_fixed);
  for (StonesSpec& spec : c.stones) {
    if (spec.supports.kind != Kind::automatic) continue;
    const bool marked = has_fixed(spec);
    if (!held) fix_on_ground(spec);
    const auto fixed =
        static_cast<std::size_t>(std::count_if(spec.stones.begin(), spec.stones.end(), [](const Stone& s) { return s.fixed; }));
    if (marked) spec.notes.push_back("fixed: " + counted(fixed, "stone") + " that the file marks as supports");
    if (!held)
      spec.notes.push_back("fixed: " + counted(fixed, "stone") + " on the ground, since nothing else holds the model (stones.supports)");
  }
}

}  // namespace voussoir::io
