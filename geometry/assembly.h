// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/polyhedron.h"
#include "geometry/segments/segment_rule.h"
#include "geometry/segments/segment_store.h"

/// Faces, segments and joints of an assembly of convex blocks (paper 2.1, Fig. 1c; choices of the method: kernels/THEORY.md).
namespace voussoir::geometry {

/// Element index that stands for the base, the fixed half-space below z = base_z.
inline constexpr std::int32_t kBase = -1;

/// Axes of a plane frame, global. `normal` = axis_s × axis_t, the outward normal of the master's face.
struct FrameAxes {
  Vec3 axis_s, axis_t, normal;
};

/// A plane frame in the reference configuration.
struct Frame {
  Vec3 centre;  // m
  Vec3 axis_s, axis_t, normal;
};

/// A frame whose axes it shares with others: an Assembly has millions, of few directions.
struct SharedFrame {
  Vec3 centre;                      // m
  const FrameAxes* axes = nullptr;  // valid as long as Assembly::axes

  [[nodiscard]] Frame frame() const noexcept { return {centre, axes->axis_s, axes->axis_t, axes->normal}; }
};

/// All segments that two faces share from the start. `element_b` may be kBase (then side_b is empty, face_b = −1).
/// The frame belongs to face_a; its centre is the area centroid of the segments of side_a, so that Σ s dA = Σ t dA = 0 over side_a.
struct Joint : SharedFrame {
  std::int32_t element_a = 0, face_a = 0;
  std::int32_t element_b = 0, face_b = 0;
  double area = 0.0;    // m2, of the overlap
  bool merged = false;  // the points of both sides coincide: side_a represents both, side_b is empty
  SegmentList side_a;   // segments mastered by face_a
  SegmentList side_b;   // segments mastered by face_b, (s, t) in the same frame; empty when merged or against the base
};

/// Segments of one face that are in no joint. Same convention for the frame (normal outward of the element).
/// Under SegmentRule::rim and corners the free part of a face is cut into convex polygons, each with its area and points that keep a
/// hundredth of the segment size inside its edges: neighbouring faces of a standing wall are flush, so round-off would decide whether a
/// point on an edge is in contact.
struct FreePatch : SharedFrame {
  std::int32_t element = 0, face = 0;
  SegmentList segments;
};

/// A plane face of an element.
struct Face {
  Vec3 normal;            // outward, unit
  double offset = 0.0;    // m, normal · x = offset on the plane (global axes)
  double distance = 0.0;  // m, ℓ: from the element's centroid to the plane (Eqs. 1-3, 9, 10, 19)
  double area = 0.0;      // m2
};

struct Element {
  std::int32_t first_face = 0, face_count = 0;  // range in Assembly::faces
  MassProperties mass;                          // for unit density
};

struct Assembly {
  std::vector<Element> elements;
  std::vector<Face> faces;    // by element, in the polyhedron's face order
  std::vector<Joint> joints;  // sorted by (element_a, face_a, element_b, face_b); element_a < element_b, base joints: element_b = kBase
  std::vector<FreePatch> patches;                // by (element, face), ascending
  std::shared_ptr<const SegmentStore> segments;  // owner of the segments of joints and patches, which stay valid as long as the store lives
  std::shared_ptr<const void> axes;              // owner of the axes of joints and patches, likewise
  SegmentRule rule = SegmentRule::centres;
};

struct Part {
  const Polyhedron* shape = nullptr;
  double segment_size = 0.0;  // m, > 0
  bool anchored = false;      // fixed or allowed to float: needs no support
  bool ground = false;  // a part of the base: has no points of its own, and no joints with the base or other ground; after all that is none
};

/// Validates every shape, refuses overlaps, finds the faces that touch and cuts them into segments.
///
/// Under SegmentRule::centres a face has a grid of n = max(1, round(edge/size)) cells a direction over its bounding rectangle; a joint
/// takes cell ∩ overlap as a segment, pieces under 1 % of a cell go to their largest neighbour in the same joint, the rest of a cell is
/// free (dropped where under 1 % of the cell).
///
/// Faces touch where their outward normals are opposite (1e-6), their planes closer than 1e-6 m and their overlap larger than 1e-8 m2; a
/// face with the normal −z at base_z touches the base all over. Segments are listed row by row in the grid of the face that masters them;
/// (s, t) are multiples of 2^-40 m, so that equal patches are equal bit by bit.
///
/// Under SegmentRule::rim the points of a joint are those of append_rim_points (geometry/segments/rim_points.h) over the overlap, with the
/// smaller segment size of the two elements, and every joint between two elements is merged. Under SegmentRule::corners likewise, with the
/// points of append_corner_points.
///
/// Joints with ground have only the points of the other element, as joints with the base have, and are merged; faces of ground have no
/// patches.
///
/// \param base_z  height of the base plane [m]; absent: no base.
/// \param threads  number of threads; the assembly has the same bits for any number
/// \throw ModelError naming: a bad shape (see validate) or segment size, two blocks that overlap by more than 1e-6 m, a block below the
/// base, a block that no chain of joints connects to the base or to an anchored block. what() starts with "block <index>: ".
/// \throw std::logic_error if the segments of a side do not sum to the overlap (1e-9 relative): a fault of this layer.
Assembly assemble(std::span<const Part> parts, std::optional<double> base_z, SegmentRule rule = SegmentRule::centres, int threads = 1);

}  // namespace voussoir::geometry
