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
#include "io/output/measures/building/building.h"
#include "io/output/replay/placed_elements.h"

/// The mechanism of a collapse: bodies of many elements that move as one, and the lines about which they rotate (io/MEASURES.md).
namespace voussoir::io {

/// Joint width [m] below which two elements move as one (io/MEASURES.md, Extent of cracks); a closed joint counts as narrower.
inline constexpr double kMovesAsOne = 1e-3;
/// Share of all mass below which a group that moves as one is loose material and no body.
inline constexpr double kLeastBody = 0.01;

/// State of one body in one frame.
struct Body {
  std::uint8_t id = 0;     // from 1; kept in the next frame by the body with most of this body's mass
  std::int32_t wall = -1;  // wall with most of its mass; −1: the roof, or no wall
  bool gable = false;      // most of its mass is of gables
  bool on_ground = false;  // moves as one with the base
  double mass = 0;         // kg
  Vec3 centre;             // in the reference configuration, m
  Vec3 displacement;       // m, of its centre of mass
  Vec3 rotation;           // rad, mean of its elements; accurate up to about 0.5 rad
  Box box = Box::empty();  // bounding box of its elements in the reference configuration, along the axes of its wall
};

/// A line about which two bodies rotate against each other, or along which they slide.
struct Hinge {
  Vec3 from, to;  // m, in the reference configuration
  /// Elements whose motion the ends of the line follow: of the first and of the second body, at the joints nearest to each end.
  std::array<std::int32_t, 2> at_from{}, at_to{};
  bool slides = false;  // the bodies slide along the plane that contains the line
};

struct BodiesInFrame {
  std::vector<std::uint8_t> id;  // by element; 0: loose, or fixed
  std::vector<Body> bodies;      // by id
  std::vector<Hinge> hinges;
};

/// Finds bodies frame by frame, in order of time.
class BodyFinder {
 public:
  /// \throw FileError
  BodyFinder(const Hdf5File& run, const Building& building, std::vector<Pose> start);

  /// Sets the bodies from a time [s] on, whatever joints are open. \param part  as in CollapseParts (io/output/replay/collapse_parts.h)
  void take(std::vector<std::int32_t> part, double from) { part_ = std::move(part), part_from_ = from; }

  /// Bodies in one frame. \param time  of the poses [s]
  BodiesInFrame find(double time, const std::vector<Pose>& poses);

 private:
  struct Joint {
    double time;                  // s, of opening; infinity: never
    std::int32_t a, b;            // elements; b = −1: the base
    Vec3 centre, from_a, from_b;  // m; from the elements' centroids; for the base, from the origin
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
  std::vector<std::int32_t> part_;     // by element, from part_from_ on; empty: not set
  double part_from_ = 0;               // s
  std::vector<std::uint8_t> last_id_;  // by element, in the frame before
};

/// Name and motion of a body: "front wall, upper half, turns out". Left and right are as seen from outside.
std::string body_name(const Body& body, const Building& building);

}  // namespace voussoir::io
