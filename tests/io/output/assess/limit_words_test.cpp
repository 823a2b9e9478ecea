// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/limit_words.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/limit/programme/linear_programme.h"

// What `voussoir limit` prints of the two bounds of a multiplier.

namespace voussoir::io {

TEST_CASE("limit: where its bounds differ, the text says that last digits of the multiplier are not proven" *
          doctest::skip(!solver::has_linear_programmes())) {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e9, 0.2};
  c.base = cases::Base{};
  c.contact.friction = 70.0;
  cases::BlockSpec wall;
  wall.name = "wall", wall.material = "stone", wall.box = {{Vec3{0.0, 0.0, 0.0}, Vec3{0.4, 0.3, 1.0}}};
  c.blocks.push_back(wall);
  const cases::Model model = cases::build_model(c);
  LimitQuestion asked;
  asked.options.live.direction = {1.0, 0.0, 0.0}, asked.options.coulomb = false;
  solver::LimitResult found = solver::limit_analysis(c, model, asked.options);
  CHECK_FALSE(found.associated.proof.wide);
  CHECK(limit_text(asked, model, found).find("not proven") == std::string::npos);

  solver::LimitProof& proof = found.associated.proof;
  proof.upper = 1.00005 * proof.lower, proof.wide = true;
  CHECK(limit_text(asked, model, found).find("not proven") != std::string::npos);
  const auto said = nlohmann::json::parse(limit_json(asked, model, found));
  CHECK(said["associated"]["proof"]["upper"].get<double>() == proof.upper);
  CHECK(said["associated"]["proof"]["lower"].get<double>() == proof.lower);
}

}  // namespace voussoir::io
