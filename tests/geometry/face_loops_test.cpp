// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/face_loops.h"

#include <doctest/doctest.h>

#include <utility>

using namespace voussoir::geometry;

TEST_CASE("copies of the faces of a polyhedron share their loops until one of them is written to") {
  FaceLoops first{{0, 1, 2}, {2, 1, 3}};
  FaceLoops second = first;
  CHECK(&std::as_const(first)[0] == &std::as_const(second)[0]);
  second[1] = {5, 6, 7};
  CHECK(&std::as_const(first)[0] != &std::as_const(second)[0]);
  CHECK(std::as_const(first)[1] == FaceLoops::Loop{2, 1, 3});
  CHECK(std::as_const(second)[1] == FaceLoops::Loop{5, 6, 7});
  CHECK_FALSE(first == second);
  second[1] = {2, 1, 3};
  CHECK(first == second);

  FaceLoops third = first;
  third.push_back({7, 8, 9});
  third.insert(third.begin(), FaceLoops::Loop{4, 4, 4});
  CHECK(first.size() == 2);
  REQUIRE(third.size() == 4);
  CHECK(std::as_const(third)[0] == FaceLoops::Loop{4, 4, 4});
  CHECK(std::as_const(third).back() == FaceLoops::Loop{7, 8, 9});
}

TEST_CASE("faces of no polyhedron are none, and equal") {
  const FaceLoops none;
  CHECK(none.empty());
  CHECK(none == FaceLoops{});
  FaceLoops some = none;
  some.push_back({0, 1, 2});
  CHECK(none.empty());
  CHECK(some.size() == 1);
}
