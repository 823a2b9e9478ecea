// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/processor/processor.h"

// Compiled with the options of the rest of the program, so the compiler's macros tell its instruction set. Contains a number and no
// instructions.
namespace voussoir::io {
namespace {

constexpr Features needed() {
  Features f = 0;
#ifdef __SSE3__
  f |= 1U << kSse3;
#endif
#ifdef __SSSE3__
  f |= 1U << kSsse3;
#endif
#ifdef __GCC_HAVE_SYNC_COMPARE_AND_SWAP_16
  f |= 1U << kCx16;
#endif
#ifdef __SSE4_1__
  f |= 1U << kSse41;
#endif
#ifdef __SSE4_2__
  f |= 1U << kSse42;
#endif
#ifdef __POPCNT__
  f |= 1U << kPopcnt;
#endif
#ifdef __LAHF_SAHF__
  f |= 1U << kLahf;
#endif
#ifdef __AVX__
  f |= 1U << kAvx;
#endif
#ifdef __AVX2__
  f |= 1U << kAvx2;
#endif
#ifdef __BMI__
  f |= 1U << kBmi1;
#endif
#ifdef __BMI2__
  f |= 1U << kBmi2;
#endif
#ifdef __F16C__
  f |= 1U << kF16c;
#endif
#ifdef __FMA__
  f |= 1U << kFma;
#endif
#ifdef __LZCNT__
  f |= 1U << kLzcnt;
#endif
#ifdef __MOVBE__
  f |= 1U << kMovbe;
#endif
#ifdef __AVX512F__
  f |= 1U << kAvx512f;
#endif
#ifdef __AVX512BW__
  f |= 1U << kAvx512bw;
#endif
#ifdef __AVX512CD__
  f |= 1U << kAvx512cd;
#endif
#ifdef __AVX512DQ__
  f |= 1U << kAvx512dq;
#endif
#ifdef __AVX512VL__
  f |= 1U << kAvx512vl;
#endif
  return f;
}

}  // namespace

constinit const Features kNeededFeatures = needed();

}  // namespace voussoir::io
