// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/assembly.h"

#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/message.h"
#include "geometry/parallel/ranges.h"
#include "geometry/segments/joints.h"
#include "geometry/segments/touching.h"

namespace voussoir::geometry {

namespace {

void check_part(const Part& part, int subject) {
  if (part.shape == nullptr) throw ModelError(block_prefix(subject) + "has no shape", subject);
  if (!(part.segment_size > 0.0) || !std::isfinite(part.segment_size)) {
    throw ModelError(block_prefix(subject) + "segment size " + figure(part.segment_size) + " m: must be positive", subject);
  }
  validate(*part.shape, subject);
}

/// Computes the mass, the faces and their grids of one element. \pre first_face and face_count are set
void fill_element(const Part& part, int subject, Element& element, std::vector<Face>& faces, std::vector<PlacedGrid>& grids,
                  FaceGridStore& store) {
  const Polyhedron& shape = *part.shape;
  element.mass = mass_properties(shape);
  for (std::int32_t f = 0; f < element.face_count; ++f) {
    const FacePlane plane = face_plane(shape, f);
    const auto i = static_cast<std::size_t>(element.first_face + f);
    faces[i] = {plane.normal, dot(plane.normal, plane.centroid), dot(plane.normal, plane.centroid - element.mass.centroid), plane.area};
    const NewFaceGrid grid = make_face_grid(shape, f, part.segment_size, subject);
    grids[i] = {grid.origin, &store.keep(grid)};
  }
}

/// Grids of all faces, by element.
struct FaceGrids {
  std::vector<PlacedGrid> placed;
  std::shared_ptr<std::vector<FaceGridStore>> stores;  // by range of elements, so that no thread waits for another
};

/// Fills elements and faces of `out`; returns the grids of the faces.
FaceGrids make_elements(std::span<const Part> parts, int threads, Assembly& out) {
  for_ranges(parts.size(), threads, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) check_part(parts[i], static_cast<int>(i));
  });
  std::int32_t faces = 0;
  out.elements.resize(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto count = static_cast<std::int32_t>(parts[i].shape->faces.size());
    out.elements[i].first_face = faces, out.elements[i].face_count = count;
    faces += count;
  }
  out.faces.resize(static_cast<std::size_t>(faces));
  FaceGrids grids{std::vector<PlacedGrid>(static_cast<std::size_t>(faces)),
                  std::make_shared<std::vector<FaceGridStore>>(range_count(parts.size()))};
  for_ranges(parts.size(), threads, [&](std::size_t range, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      fill_element(parts[i], static_cast<int>(i), out.elements[i], out.faces, grids.placed, (*grids.stores)[range]);
  });
  return grids;
}

/// Throws unless every block is connected by contacts to the base or to an anchored block.
void check_held(std::span<const Part> parts, const std::vector<Contact>& contacts) {
  const std::size_t ground = parts.size();
  DisjointSets groups(parts.size() + 1);
  std::vector<bool> touches(parts.size(), false);
  for (const Contact& c : contacts) {
    const auto a = static_cast<std::size_t>(c.element_a), b = c.element_b == kBase ? ground : static_cast<std::size_t>(c.element_b);
    groups.join(a, b);
    touches[a] = true;
    if (b != ground) touches[b] = true;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].anchored) groups.join(i, ground);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (groups.same(i, ground)) continue;
    const Box3 box = bounds(*parts[i].shape);
    throw ModelError(block_prefix(static_cast<int>(i)) + (touches[i] ? "is held by nothing, nor is what it touches" : "touches nothing") +
                         " (it reaches from (" + figure(box.low.x) + ", " + figure(box.low.y) + ", " + figure(box.low.z) + ") to (" +
                         figure(box.high.x) + ", " + figure(box.high.y) + ", " + figure(box.high.z) + ") m)",
                     static_cast<int>(i));
  }
}

}  // namespace

Assembly assemble(std::span<const Part> parts, std::optional<double> base_z, SegmentRule rule, int threads) {
  Assembly out;
  out.rule = rule;
  const FaceGrids grids = make_elements(parts, threads, out);
  out.axes = grids.stores;
  std::vector<Box3> boxes;
  boxes.reserve(parts.size());
  for (const Part& part : parts) boxes.push_back(bounds(*part.shape));
  const Scene scene{parts, out.elements, grids.placed, boxes, threads};
  const std::vector<Contact> contacts = find_contacts(scene, base_z);
  check_held(parts, contacts);
  make_joints(scene, contacts, out);
  return out;
}

}  // namespace voussoir::geometry
