// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/members/seat_slip.h"

#include <cmath>
#include <map>
#include <utility>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr double kSteepest = 0.5;  // least vertical component of the normal of a joint that bears
constexpr double kGone = 1.0;      // m

bool spans(const Building& b, std::int32_t element) {
  const cases::PartKind kind = nth(b.kind, element);
  return kind == cases::PartKind::beam || kind == cases::PartKind::floor_beam;
}
bool bears(const Building& b, std::int32_t element) {
  return nth(b.wall, element) >= 0 || nth(b.kind, element) == cases::PartKind::ring_beam;
}

}  // namespace

SeatSlip::SeatSlip(const Hdf5File& run, const Building& building, const std::vector<std::string>& tags, const std::vector<Pose>& start) {
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto centre = run.read<double>("/model/joint/centre"), normal = run.read<double>("/model/joint/normal"),
             area = run.read<double>("/model/joint/area");
  if (a.size() != area.size() || b.size() != area.size() || centre.size() != 3 * area.size() || normal.size() != 3 * area.size())
    throw FileError(run.path(), "/model/joint does not fit together");
  std::map<std::pair<std::string, std::int32_t>, std::size_t> numbers;  // by timber and wall
  for (std::size_t j = 0; j < area.size(); ++j) {
    if (b[j] < 0) continue;
    const double up = normal[3 * j + 2];  // out of a: what lies above b is a where it points down
    const bool first = up < -kSteepest && spans(building, a[j]) && bears(building, b[j]),
               second = up > kSteepest && spans(building, b[j]) && bears(building, a[j]);
    if (!first && !second) continue;
    const std::string& timber = nth(tags, first ? a[j] : b[j]);
    const std::int32_t wall = nth(building.wall, first ? b[j] : a[j]);
    const auto [at, is_new] = numbers.emplace(std::pair{timber, wall}, seats_.size());
    if (is_new) seats_.push_back({timber, wall, 0.0, {}});
    Seat& seat = seats_[at->second];
    const Vec3 c{centre[3 * j], centre[3 * j + 1], centre[3 * j + 2]};
    seat.area += area[j];
    seat.beds.push_back({{j, 0.0, a[j], b[j], c, c - nth(start, a[j]).centre, c - nth(start, b[j]).centre},
                         {normal[3 * j], normal[3 * j + 1], normal[3 * j + 2]},
                         area[j]});
  }
}

std::vector<SeatSlip::Slip> SeatSlip::at(const std::vector<Pose>& poses, const std::vector<std::uint8_t>& fallen) const {
  std::vector<Slip> slips;
  for (const Seat& seat : seats_) {
    double area = 0, sum = 0;
    for (const Seat::Bed& bed : seat.beds) {
      const Vec3 apart = bed.joint.apart(poses);
      if (nth(fallen, bed.joint.a) != 0 || nth(fallen, bed.joint.b) != 0 || norm(apart) > kGone) continue;
      const Vec3 n = normalised(nth(poses, bed.joint.a).rotation * bed.normal + nth(poses, bed.joint.b).rotation * bed.normal);
      area += bed.area, sum += bed.area * norm(apart - dot(apart, n) * n);
    }
    slips.push_back({area > 0 ? sum / area : 0.0, area <= 0.5 * seat.area});
  }
  return slips;
}

}  // namespace voussoir::io
