// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/control_point.h"

#include <doctest/doctest.h>

#include "cases/case.h"
#include "cases/model.h"

using namespace voussoir;

// The control point of an analysis by the name of a part.

namespace {

cases::Case blocks() {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e9, 0.2};
  c.base = cases::Base{};
  const char* names[] = {"left", "right", "sill"};
  for (int i = 0; i < 3; ++i) {
    cases::BlockSpec b;
    b.name = names[i], b.material = "stone", b.fixed = i == 2;
    b.box = {{Vec3{1.0 * i, 0.0, 0.0}, Vec3{1.0 * i + 1.0, 0.5, 0.5}}};
    if (i < 2) b.part = "front wall";
    c.blocks.push_back(b);
  }
  return c;
}

}  // namespace

TEST_CASE("control: a name stands for a block, or for all elements of a part") {
  const cases::Model m = cases::build_model(blocks());
  CHECK(cases::elements_called(m, "right") == std::vector<std::int32_t>{1});
  CHECK(cases::elements_called(m, "front wall") == std::vector<std::int32_t>{0, 1});
  CHECK(cases::elements_called(m, "rear wall").empty());
}

TEST_CASE("control: an unknown name, or one of what is fixed, is refused with the names that there are") {
  cases::Case c = blocks();
  const cases::Model m = cases::build_model(c);
  const auto named = [&](const std::string& name) {
    c.analysis.control_name = name;
    cases::check_control(c, m);
  };
  CHECK_NOTHROW(named(""));
  CHECK_NOTHROW(named("left"));
  CHECK_NOTHROW(named("front wall"));
  CHECK_THROWS_WITH_AS(named("front wal"),
                       "analysis.control: = \"front wal\" is the name of no part; did you mean \"front wall\"? known: front wall",
                       cases::InputError);
  CHECK_THROWS_WITH_AS(named("sill"), "analysis.control: = \"sill\" is fixed: it shows no displacement", cases::InputError);
}
