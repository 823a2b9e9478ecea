// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "fixtures.h"
#include "geometry/assembly.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

Polyhedron brick_at(Vec3 low) { return box_at(low, {0.2, 0.1, 0.1}); }

Complaint complaint_of(const std::vector<Polyhedron>& shapes, std::optional<double> base_z = std::nullopt, bool anchored = true) {
  const std::vector<Part> parts = parts_of(shapes, 0.05, anchored);
  return complaint([&] { assemble(parts, base_z); });
}

}  // namespace

TEST_SUITE("faults") {
  TEST_CASE("a bad shape is named") {
    std::vector<Polyhedron> shapes{brick_at({0, 0, 0}), brick_at({0, 0, 0.1})};
    shapes[1].vertices[6].x += 0.01;
    const Complaint c = complaint_of(shapes);
    CHECK(c.mentions("block 1: a face is not plane"));
    CHECK(c.subject == 1);
  }

  TEST_CASE("a part without a shape, or without a segment size") {
    const Polyhedron shape = brick_at({0, 0, 0});
    const std::vector<Part> no_shape{{nullptr, 0.05, true}};
    CHECK(complaint([&] { assemble(no_shape, std::nullopt); }).mentions("block 0: has no shape"));
    for (const double bad : {0.0, -1.0, static_cast<double>(NAN)}) {
      const std::vector<Part> parts{{&shape, bad, true}};
      CHECK(complaint([&] { assemble(parts, std::nullopt); }).mentions("must be positive"));
    }
  }

  TEST_CASE("two blocks that overlap, with the depth") {
    const Complaint c = complaint_of({brick_at({5, 5, 5}), brick_at({0, 0, 0}), brick_at({0.05, 0.02, 0.09})});
    CHECK(c.mentions("block 1: overlaps block 2 by 0.01 m"));
    CHECK(c.mentions("m) about ("));
    CHECK(c.subject == 1);
    CHECK(c.other == 2);
  }

  TEST_CASE("the tolerance of an overlap is 1e-6 m") {
    CHECK(complaint_of({brick_at({0, 0, 0}), brick_at({0, 0, 0.1 - 0.9e-6})}).what.empty());
    CHECK(complaint_of({brick_at({0, 0, 0}), brick_at({0, 0, 0.1 - 1.1e-6})}).mentions("overlaps"));
    CHECK(complaint_of({brick_at({1000, 0, 0}), brick_at({1000, 0, 0.1 - 1.1e-6})}).mentions("overlaps"));
  }

  TEST_CASE("one block within another, and the same block twice") {
    CHECK(complaint_of({box_at({0, 0, 0}, {1, 1, 1}), brick_at({0.3, 0.3, 0.3})}).mentions("block 0: overlaps block 1 by 0.4 m"));
    CHECK(complaint_of({brick_at({0, 0, 0}), brick_at({0, 0, 0})}).mentions("overlaps block 1 by 0.1 m"));
  }

  TEST_CASE("blocks that only edges hold apart, or that meet edge to edge") {
    // Two bars crossed like an X, each turned onto an edge: no face normal separates them, the product of the two edges (z) does.
    const double r = 0.1 / std::sqrt(2.0);
    const Polyhedron lower = rotated(box_at({-0.5, -0.05, -0.05}, {1, 0.1, 0.1}), {1, 0, 0}, 0.25 * 3.14159265358979, {0, 0, 0});
    const Polyhedron bar = rotated(box_at({-0.05, -0.5, -0.05}, {0.1, 1, 0.1}), {0, 1, 0}, 0.25 * 3.14159265358979, {0, 0, 0});
    CHECK(complaint_of({lower, moved(bar, {0, 0, 2 * r + 0.001})}).what.empty());
    CHECK(complaint_of({lower, moved(bar, {0, 0, 2 * r})}).what.empty());
    const Complaint c = complaint_of({lower, moved(bar, {0, 0, 2 * r - 0.001})});
    CHECK(c.mentions("overlaps block 1 by 0.001 m"));
  }

  TEST_CASE("a block below the base") {
    const Complaint c = complaint_of({brick_at({0, 0, 0}), brick_at({1, 0, -0.02})}, 0.0);
    CHECK(c.mentions("block 1: reaches 0.02 m below the base"));
    CHECK(c.subject == 1);
    CHECK(complaint_of({brick_at({0, 0, -0.9e-6})}, 0.0).what.empty());
    CHECK(complaint_of({brick_at({0, 0, -1.1e-6})}, 0.0).mentions("below the base"));
    CHECK(complaint_of({brick_at({0, 0, -5})}).what.empty());
  }

  TEST_CASE("a block that touches nothing, unless it is anchored") {
    const std::vector<Polyhedron> shapes{brick_at({0, 0, 0}), brick_at({0, 0, 0.1}), brick_at({0, 0, 0.21})};
    const Complaint c = complaint_of(shapes, 0.0, false);
    CHECK(c.mentions("block 2: touches nothing"));
    CHECK(c.subject == 2);
    CHECK(complaint_of(shapes, 0.0, true).what.empty());
    CHECK(complaint_of({shapes[0], shapes[1]}, 0.0, false).what.empty());
    CHECK(complaint_of({shapes[0]}, std::nullopt, false).mentions("touches nothing"));
  }

  TEST_CASE("blocks that touch each other, and nothing that stands") {
    const std::vector<Polyhedron> shapes{brick_at({0, 0, 0}), brick_at({1, 0, 1e-5}), brick_at({1, 0, 0.10001})};
    const Complaint c = complaint_of(shapes, 0.0, false);
    CHECK(c.mentions("block 1: is held by nothing, nor is what it touches"));
    CHECK(c.subject == 1);
    std::vector<Part> parts = parts_of(shapes, 0.05, false);
    parts[2].anchored = true;
    CHECK(complaint([&] { assemble(parts, 0.0); }).what.empty());
  }

  TEST_CASE("nothing at all is no fault") { CHECK(complaint_of({}, 0.0, false).what.empty()); }
}
