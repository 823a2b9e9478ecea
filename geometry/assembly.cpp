// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/assembly.h"

#include <numeric>
#include <vector>

#include "geometry/joints.h"
#include "geometry/message.h"
#include "geometry/touching.h"

namespace voussoir::geometry {

namespace {

void check_part(const Part& part, int subject) {
  if (part.shape == nullptr) throw ModelError(block_prefix(subject) + "has no shape", subject);
  if (!(part.segment_size > 0.0) || !std::isfinite(part.segment_size)) {
    throw ModelError(block_prefix(subject) + "segment size " + figure(part.segment_size) + " m: must be positive", subject);
  }
  validate(*part.shape, subject);
}

void add_element(const Part& part, int subject, Assembly& out, std::vector<FaceGrid>& grids) {
  const Polyhedron& shape = *part.shape;
  const auto count = static_cast<std::int32_t>(shape.faces.size());
  Element& element = out.elements.emplace_back();
  element.first_face = static_cast<std::int32_t>(out.faces.size());
  element.face_count = count;
  element.mass = mass_properties(shape);
  for (std::int32_t f = 0; f < count; ++f) {
    const FacePlane plane = face_plane(shape, f);
    out.faces.push_back(
        {plane.normal, dot(plane.normal, plane.centroid), dot(plane.normal, plane.centroid - element.mass.centroid), plane.area});
    grids.push_back(make_face_grid(shape, f, part.segment_size, subject));
  }
}

/// Sets of blocks that hold together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// Every block stands on the base or an anchored one, if only by way of others.
void check_held(std::span<const Part> parts, const std::vector<Contact>& contacts) {
  const std::size_t ground = parts.size();
  Groups groups(parts.size() + 1);
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
    if (groups.of(i) == groups.of(ground)) continue;
    const Box3 box = bounds(*parts[i].shape);
    throw ModelError(block_prefix(static_cast<int>(i)) + (touches[i] ? "is held by nothing, nor is what it touches" : "touches nothing") +
                         " (it reaches from (" + figure(box.low.x) + ", " + figure(box.low.y) + ", " + figure(box.low.z) + ") to (" +
                         figure(box.high.x) + ", " + figure(box.high.y) + ", " + figure(box.high.z) + ") m)",
                     static_cast<int>(i));
  }
}

}  // namespace

Assembly assemble(std::span<const Part> parts, std::optional<double> base_z, SegmentRule rule) {
  Assembly out;
  out.rule = rule;
  std::vector<FaceGrid> grids;
  std::vector<Box3> boxes;
  out.elements.reserve(parts.size());
  boxes.reserve(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    check_part(parts[i], static_cast<int>(i));
    add_element(parts[i], static_cast<int>(i), out, grids);
    boxes.push_back(bounds(*parts[i].shape));
  }
  const Scene scene{parts, out.elements, grids, boxes};
  const std::vector<Contact> contacts = find_contacts(scene, base_z);
  check_held(parts, contacts);
  make_joints(scene, contacts, out);
  return out;
}

}  // namespace voussoir::geometry
