// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/vec3.h"
#include "io/output/measures/building.h"
#include "io/output/replay/placed_elements.h"

/// The mechanism of a collapse: bodies of many elements that move as one, and the lines about which they turn (io/MEASURES.md).
namespace voussoir::io {

/// Two elements move as one while their joint is not open, or its width (io/MEASURES.md, Extent of cracks) is below this, m.
inline constexpr double kMovesAsOne = 1e-3;
/// Of all mass: what moves as one and is less than this is no body, but loose.
inline constexpr double kLeastBody = 0.01;

/// What one body does in one frame.
struct Body {
  std::uint8_t id = 0;     // from 1; the same in the next frame for the body that has most of this one's mass
  std::int32_t wall = -1;  // of which it has most mass; −1: of the roof, or of no wall
  bool on_ground = false;  // it moves as one with the base
  double mass = 0;         // kg
  Vec3 centre;             // in the reference configuration, m
  Vec3 displacement;       // of its centre of mass, m
  Vec3 rotation;           // mean of its elements, rad; right up to about one half
  Box box = Box::empty();  // of its elements in the reference configuration
};

/// A line about which two bodies turn against each other, or along which they slide.
struct Hinge {
  Vec3 from, to;  // m, in the reference configuration
  /// The elements whose motion its ends follow: of the first body and of the second, at their joints the nearest to the end.
  std::array<std::int32_t, 2> at_from{}, at_to{};
  bool slides = false;  // they slide along the plane that the line lies in
};

struct BodiesInFrame {
  std::vector<std::uint8_t> id;  // of each element; 0: loose, or fixed
  std::vector<Body> bodies;      // by id
  std::vector<Hinge> hinges;
};

/// Finds bodies frame by frame, in the order of time.
class BodyFinder {
 public:
  /// \throw FileError
  BodyFinder(const Hdf5File& run, const Building& building, std::vector<Pose> start);

  /// From a time [s] on these are the bodies, whatever is open. \param part  as in CollapseParts (io/output/replay/collapse_parts.h)
  void take(std::vector<std::int32_t> part, double from) { part_ = std::move(part), part_from_ = from; }

  /// \param time  of the poses [s]
  BodiesInFrame find(double time, const std::vector<Pose>& poses);

 private:
  struct Joint {
    double time;                  // when it came open, s; infinity: never
    std::int32_t a, b;            // elements; b = −1: the base
    Vec3 centre, from_a, from_b;  // m; from the elements' centroids, of the base from the origin
    Vec3 normal;
  };
  std::vector<std::int32_t> components(double time, const std::vector<Pose>& poses) const;
  void number(std::vector<Body>& bodies, const std::vector<std::int32_t>& component, BodiesInFrame& out);
  [[nodiscard]] std::array<std::int32_t, 2> carriers(const Vec3& end, const std::vector<const Joint*>& joints, const BodiesInFrame& found,
                                                     std::uint8_t first) const;
  [[nodiscard]] std::optional<Hinge> slide(const std::vector<const Joint*>& joints, const std::vector<Pose>& poses,
                                           const BodiesInFrame& found, std::uint8_t first) const;
  [[nodiscard]] std::vector<Hinge> hinges(double time, const std::vector<Pose>& poses, const BodiesInFrame& found) const;

  const Building& building_;
  std::vector<Pose> start_;
  std::vector<Joint> joints_;
  double all_mass_ = 0;
  std::vector<std::int32_t> part_;     // of each element, from part_from_ on; empty: none are given
  double part_from_ = 0;               // s
  std::vector<std::uint8_t> last_id_;  // of each element in the frame before
};

/// "front wall, upper half, turns out": what a body is of and what it does. Left and right are those of somebody who looks at the wall from
/// outside.
std::string body_name(const Body& body, const Building& building);

}  // namespace voussoir::io
