// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "cases/motion.h"
#include "cases/tables/motion.h"

/// Treatment of a record before use: cut to a window, baseline corrected, tapered, in this order.
namespace voussoir::io {

/// Cuts, corrects and tapers every component that has samples. The default treatment changes no bit.
/// - from, to: the samples nearest to these times are the first and the last that are kept; the first becomes t = 0.
/// - baseline, least squares over the kept samples: `mean` subtracts the mean acceleration, `linear` a straight line, `parabolic` the
/// parabola c0 + c1 t + c2 t² whose removal leaves the smallest mean square of the velocity, integrated from rest (Berg and Housner 1961).
/// - taper: half a cosine, 0.5 (1 - cos(pi t / taper)), from zero at the first sample, and likewise to zero at the last one.
/// \param prefix  of the keys in messages: "motion." or "--"
/// \throw InputError at prefix + "from", "to", "taper" or "baseline": a window outside the motion or that leaves a component fewer than two
/// samples, tapers longer than the window, a baseline of fewer than four samples.
void treat(std::array<cases::Accelerogram, 3>& components, const cases::MotionTreatment& treatment, const std::string& prefix);

/// The treatment in words: "from 27 to 47 s, baseline parabolic, tapered over 0.5 and 0.5 s"; empty: as recorded.
std::string described(const cases::MotionTreatment& treatment);

/// "none", "mean", "linear", "parabolic".
const char* name(cases::Baseline baseline) noexcept;

}  // namespace voussoir::io
