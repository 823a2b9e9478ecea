// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cases/motion.h"

namespace voussoir::io {

/// The synthetic three-component records: L, T, V; 21 s at 0.005 s. Their bits are the same for every build on processors with FMA and with
/// the mathematical functions of glibc. The records meet published figures of a near-fault main shock (catalogue/bam-like.md lists targets
/// and achieved figures). They are not the recorded motion.
/// - "bam-like", also "bam-like-1": the record of the catalogue's tables; its pulse has a period of 2.8 s.
std::array<cases::Accelerogram, 3> bam_like_1();
/// - "bam-like#7": a realisation of the family, whose pulse has the published period of 2.02 s. Each realisation meets these figures with
/// different short waves. \throw InputError for a number outside 1 to kMostRealisations.
std::array<cases::Accelerogram, 3> bam_like(int realisation);
inline constexpr int kMostRealisations = 999;

}  // namespace voussoir::io
