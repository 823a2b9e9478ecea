// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "cases/motion.h"
#include "io/input/motion/synthetic/bam_like.h"
#include "io/input/motion/synthetic/wavelets.h"

// One record, tuned by gradient descent on the distance to the targets in catalogue/bam-like.md, outside the program, with the seeds chosen
// among some fifty. The table contains amplitudes and the shapes of three pulses, and no samples of a real record.
namespace voussoir::io {
namespace {

struct Recipe {
  const char* name;
  std::uint64_t seed;
  Wavelet pulse;
  WaveletAmplitudes short_wavelets;
};

constexpr std::array<Recipe, 3> kRecipes{{
    {"bam-like L",
     19,
     {2.697, 1 / 2.8, 2.75, 2.7, 0.3},
     {{1.19, 0.83, 0.90, 1.15, 0.97, 0.97, 0.76, 1.52, 1.14, 0.58},
      {0.047, 0.046, 0.054, 0.151, 0.293, 0.229, 0.161, 0.113, 0.073, 0.064},
      {0.121, 0.120, 0.128, 1.076, 0.958, 0.675, 0.896, 0.545, 0.217, 0.159}}},
    {"bam-like T",
     59,
     {1.299, 1 / 1.7, 4.40, 2.0, 1.0},
     {{0.82, 0.81, 0.97, 0.80, 1.36, 1.23, 0.67, 1.25, 1.16, 0.92},
      {0.035, 0.035, 0.036, 0.094, 0.464, 0.705, 0.663, 0.159, 0.100, 0.089},
      {0.103, 0.107, 0.280, 0.729, 0.293, 0.257, 0.179, 0.132, 0.114, 0.109}}},
    {"bam-like V",
     21,
     {1.402, 1 / 1.3, 2.50, 1.6, 0.7},
     {{0.70, 0.91, 1.22, 1.08, 0.96, 1.13, 0.92, 0.99, 1.13, 0.96},
      {0.298, 0.308, 0.318, 0.364, 0.324, 0.289, 0.228, 0.151, 0.105, 0.091},
      {0.387, 0.386, 0.928, 1.472, 0.906, 0.593, 0.386, 0.234, 0.154, 0.136}}},
}};

cases::Accelerogram synthesise(const Recipe& r) {
  cases::Accelerogram a{r.name, kWaveletStep, std::vector<double>(kWaveletSamples, 0.0)};
  add(r.pulse, a.acceleration);
  add_short_wavelets(r.short_wavelets, r.seed, a.acceleration);
  return a;
}

}  // namespace

std::array<cases::Accelerogram, 3> bam_like_1() { return {synthesise(kRecipes[0]), synthesise(kRecipes[1]), synthesise(kRecipes[2])}; }

}  // namespace voussoir::io
