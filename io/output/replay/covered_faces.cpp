// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/covered_faces.h"

#include <cstddef>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr double kWhole = 0.999;     // of a face, to allow for round-off in sums of areas
constexpr std::int32_t kDryLaw = 0;  // see cases::Model::laws

using Ints = std::vector<std::int32_t>;

/// Adds the areas of joints to the faces on one side of the joints.
void add_areas(const Hdf5File& run, const Ints& element, const Ints& face, const Ints& first_face, DryJoints dry,
               std::vector<double>& covered) {
  const auto law = run.read<std::int32_t>("/model/joint/law");
  const auto area = run.read<double>("/model/joint/area");
  if (law.size() != element.size() || area.size() != element.size() || face.size() != element.size())
    throw FileError(run.path(), "/model/joint does not fit together");
  for (std::size_t j = 0; j < element.size(); ++j) {
    if ((law[j] == kDryLaw && dry == DryJoints::open) || element[j] < 0) continue;
    const auto e = static_cast<std::size_t>(element[j]);
    const std::int64_t f = e < first_face.size() ? std::int64_t{first_face[e]} + face[j] : -1;
    if (f < 0 || static_cast<std::size_t>(f) >= covered.size())
      throw FileError(run.path(), "/model/joint: row " + std::to_string(j) + " refers to no face");
    nth(covered, f) += area[j];
  }
}

}  // namespace

std::vector<std::uint8_t> covered_face_rows(const Hdf5File& run, DryJoints dry) {
  const auto area = run.read<double>("/model/face/area");
  const auto first_face = run.read<std::int32_t>("/model/element/first_face");
  std::vector<double> covered(area.size());
  for (const char* side : {"a", "b"}) {
    const std::string at = "/model/joint/";
    add_areas(run, run.read<std::int32_t>(at + "element_" + side), run.read<std::int32_t>(at + "face_" + side), first_face, dry, covered);
  }
  std::vector<std::uint8_t> whole(area.size());
  for (std::size_t f = 0; f < area.size(); ++f) whole[f] = covered[f] >= kWhole * area[f] ? 1 : 0;
  return whole;
}

CoveredFaces covered_faces(const Hdf5File& run, DryJoints dry) {
  const auto normal = run.read<float>("/model/face/normal");
  const auto element = run.read<std::int32_t>("/model/face/element");
  const std::vector<std::uint8_t> covered = covered_face_rows(run, dry);
  if (normal.size() != 3 * covered.size() || element.size() != covered.size())
    throw FileError(run.path(), "/model/face does not fit together");
  CoveredFaces faces;
  for (std::size_t f = 0; f < covered.size(); ++f) {
    if (covered[f] == 0) continue;
    faces.element.push_back(element[f]);
    faces.normal.insert(faces.normal.end(), normal.begin() + static_cast<std::ptrdiff_t>(3 * f),
                        normal.begin() + static_cast<std::ptrdiff_t>(3 * f + 3));
  }
  return faces;
}

}  // namespace voussoir::io
