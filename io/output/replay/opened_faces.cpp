// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/opened_faces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

using Ints = std::vector<std::int32_t>;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// One side of all joints: the elements, and their faces by number; −1: the base.
struct JointSide {
  Ints element;
  std::vector<std::int64_t> face;
};
JointSide joint_side(const Hdf5File& run, const std::string& which, const Ints& first_face, std::size_t faces) {
  JointSide side{run.read<std::int32_t>("/model/joint/element_" + which), {}};
  const auto face = run.read<std::int32_t>("/model/joint/face_" + which);
  if (face.size() != side.element.size()) throw FileError(run.path(), "/model/joint does not fit together");
  for (std::size_t j = 0; j < face.size(); ++j) {
    const std::int32_t e = side.element[j];
    const bool known = e < static_cast<std::int64_t>(first_face.size());
    const std::int64_t number = e < 0 ? -1 : known ? std::int64_t{nth(first_face, e)} + face[j] : -2;
    if (number < -1 || number >= static_cast<std::int64_t>(faces))
      throw FileError(run.path(), "/model/joint: row " + std::to_string(j) + " refers to no face");
    side.face.push_back(number);
  }
  return side;
}

/// Marks elements that are parts of the base, since a broken joint is a small part of their faces.
std::vector<bool> parts_of_base(const Hdf5File& run) {
  if (!run.exists("/model/element/tag")) return std::vector<bool>(run.read<std::int32_t>("/model/element/first_face").size(), false);
  const auto fixed = run.read<std::uint8_t>("/model/element/fixed");
  const std::vector<std::string> tags = run.read_strings("/model/element/tag");
  std::vector<bool> all(fixed.size(), false);
  for (std::size_t e = 0; e < fixed.size() && e < tags.size(); ++e) all[e] = fixed[e] != 0 && tags[e].starts_with("ground ");
  return all;
}

}  // namespace

OpenedFaces opened_faces(const Hdf5File& run, const std::vector<double>& since) {
  const auto normal = run.read<float>("/model/face/normal");
  const auto element = run.read<std::int32_t>("/model/face/element"), first_face = run.read<std::int32_t>("/model/element/first_face");
  if (normal.size() != 3 * element.size()) throw FileError(run.path(), "/model/face does not fit together");
  const std::array sides{joint_side(run, "a", first_face, element.size()), joint_side(run, "b", first_face, element.size())};
  std::vector<double> opened(element.size(), kNever);
  for (const JointSide& side : sides) {
    if (side.face.size() != since.size()) throw FileError(run.path(), "/model/joint does not fit together");
    for (std::size_t j = 0; j < since.size(); ++j) {
      if (side.face[j] < 0) continue;
      double& of_face = nth(opened, side.face[j]);
      of_face = std::min(of_face, since[j]);
    }
  }
  OpenedFaces out;
  const std::vector<bool> ground = parts_of_base(run);
  for (std::size_t f = 0; f < opened.size(); ++f) {
    if (opened[f] == kNever || nth(ground, element[f])) continue;
    out.element.push_back(element[f]);
    out.normal.insert(out.normal.end(), normal.begin() + static_cast<std::ptrdiff_t>(3 * f),
                      normal.begin() + static_cast<std::ptrdiff_t>(3 * f + 3));
    out.time.push_back(static_cast<float>(opened[f]));
  }
  return out;
}

}  // namespace voussoir::io
