// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/lanes.h"

/// Eq. 5: a bond fails in tension above f_t, not at it. These places in kernels/ compare a stress with a tensile
/// strength, and no others:
///
///   decides, by tension_fails
///     laws/segment_law.h   advance_segment   breaks the bond
///     laws/softening.h     wear_by_opening   wears the bond (13b), or breaks it where it is brittle in tension; f_t follows the wear
///   must not miss it, by tension_fails
///     chunk_law.h          bonded            several segments at a time: hands a chunk in which one fails to advance_segment
///   proves that it is not reached, with a distance for round-off; what fails the proof goes to the segments
///     whole_sides.cpp      inside            of sides in which nothing has happened, by the limits that set_limits derives from f_t
///     certificate.h        certified         of other whole sides, and of those that fail the bound above
///     steady_sides.h       stay_steady       of damaged sides in which nothing changes, by the distance that approach (.cpp) has left
///
/// tests/kernels/tension_test.cpp pulls one side at all of them. What reads f_t for other ends: solver/setup/laws/softening.cpp (the energy
/// below the limit), solver/setup/side_kinds.cpp (which sides are alike), solver/limit/contacts.cpp and
/// io/input/case_file/case_table_joint_laws.cpp (whether there is any).
namespace voussoir::kernels {

/// \param sigma, limit  Pa: numbers, or several of them
template <typename Stress, typename Limit>
VOUSSOIR_INLINE auto tension_fails(const Stress& sigma, const Limit& limit) noexcept {
  return sigma > limit;
}

}  // namespace voussoir::kernels
