// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/grid.h"
#include "geometry/separation.h"
#include "geometry/solids/facing.h"

/// Which faces of drawn stones were meant to touch, and the plane that fits both of them. Internal to geometry/solids/fit/.
namespace voussoir::geometry {

/// A convex piece of a drawn stone with what the fit asks of it.
struct FitBody {
  ConvexBody body;
  std::vector<FlatFace> faces;
  Box3 box;
  std::int32_t stone = 0;
  double limit = 0.0;  // m, how far a face may move
  double snap = 0.0;   // m, contacts narrower than this are ignored
};

/// Sums over an area: with them, planes that fit several areas.
struct Moments {
  double area = 0.0;  // m2
  Vec3 first;         // m3
  Mat3 second = Mat3::zero();
  void add(std::span<const Vec3> polygon);  // convex
  void add(const Moments& other);
};

/// The plane with the least squares of distances, its normal to the side of `towards`; `towards` itself is the normal if the areas have no
/// breadth. \pre area > 0
HalfSpace fitted_plane(const Moments& m, Vec3 towards);

/// A face of body a that looks at a face of body b, or at the base (b = −1).
struct FitContact {
  std::int32_t a = -1, b = -1;            // bodies
  std::int32_t face_a = -1, face_b = -1;  // of them
  double area = 0.0;                      // m2, of the common area
  double low = 0.0, high = 0.0;           // m, least and greatest gap; negative: overlap
  std::vector<Vec3> on_a, on_b;           // corners of the common area on either face
  HalfSpace plane;                        // outward of a
  bool exact = false;                     // the faces lie in one plane already, which is `plane`
};

/// Contacts of two bodies, no more than one of each face of a with each of b, all of one separating plane. Faces look at each other where
/// their normals are opposite within 30 degrees, their overlap is within the sum of their limits, their gap within half of it, and their
/// common area is broader than the snap, and no small part of both faces unless they fit within a quarter of that sum.
/// \param depth  m, of the overlap of the bodies; 0 or less: they are apart
std::vector<FitContact> contacts_of(std::span<const FitBody> bodies, std::int32_t a, std::int32_t b, double depth);

/// Contacts of a body with the base.
std::vector<FitContact> base_contacts_of(std::span<const FitBody> bodies, std::int32_t a, double base_z);

/// Chooses the plane of each contact. Contacts that hang together by common faces get one plane where it passes all of them within half of
/// their limits and within three times their largest gap or overlap; else each pair of bodies has its own. Exact ones keep theirs where
/// all of a group are exact. \param
/// base_z  plane of contacts with the base
void choose_planes(std::span<const FitBody> bodies, std::span<FitContact> contacts, std::optional<double> base_z);

}  // namespace voussoir::geometry
