// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/chance.h"

#include <array>

#include "geometry/message.h"

namespace voussoir::io {

bool has_chance(const Measures& m) { return m.first_fallen_time >= 0.0; }

std::span<const std::string_view> figures_of_chance() {
  using namespace std::string_view_literals;
  static constexpr std::array kAll{"fallen_mass_fraction"sv,
                                   "debris_area"sv,
                                   "debris_reach"sv,
                                   "debris_reach_95"sv,
                                   "free_volume"sv,
                                   "least_free_volume"sv,
                                   "peak_drift"sv,
                                   "residual_drift"sv,
                                   "peak_in_plane_drift"sv,
                                   "peak_drift_time"sv,
                                   "peak_gable_drift"sv,
                                   "peak_storey_drift"sv,
                                   "peak_seat_slip"sv,
                                   "seat_slip"sv,
                                   "lost_seats"sv,
                                   "penetration"sv,
                                   "base_penetration"sv,
                                   "peak_penetration"sv,
                                   "peak_base_penetration"sv,
                                   "peak_penetration_time"sv,
                                   "peak_penetration_pair"sv,
                                   "deep_pairs"sv,
                                   "most_deep_pairs"sv,
                                   "touching_pairs"sv,
                                   "compression"sv,
                                   "first_compression"sv,
                                   "peak_base_shear"sv,
                                   "peak_speed"sv,
                                   "points"sv,
                                   "walls"sv};
  return kAll;
}

std::string words_of_chance(const Measures& m) {
  return geometry::printed("Parts fall from %.2f s on, so the run is chaotic", m.first_fallen_time) +
         ": the last digit of an input changes figures with *, and those of single walls, by some per cent up to their own size. In the "
         "models tried, the first crack, the damage grade, collapse and what falls first, with their times, and the segments opened by "
         "tension or shear held within some per cent. Runs with scatter.variation = 1e-9 and other seeds show the spread.";
}

}  // namespace voussoir::io
