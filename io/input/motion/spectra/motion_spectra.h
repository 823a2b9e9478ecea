// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cases/motion.h"
#include "io/input/motion/spectra/spectra.h"

/// The response spectra that `voussoir motion` writes and compares.
namespace voussoir::io {

/// One component of a record or a file.
struct Component {
  std::string record, name;
  cases::Accelerogram motion;
  std::optional<double> stated_peak;  // m/s2, from the file's header
  char axis = 0;                      // 'L', 'T', 'V' if known
  std::size_t source = 0;             // index of the argument from which it was read
};

/// Two horizontal components of one station.
struct HorizontalPair {
  std::string record;
  std::size_t first = 0, second = 0;  // indices of the components
};

/// Pairs of L and T of each argument that has both; else of the only two components.
/// \throw cases::InputError at the option that needs pairs, if there are none, or their steps differ.
std::vector<HorizontalPair> horizontal_pairs(const std::vector<Component>& components, const std::string& option);

/// Input of write_spectra and print_fits.
struct Spectra {
  const std::vector<Component>& components;
  std::vector<HorizontalPair> pairs;             // empty: no combined spectra
  std::vector<double> damping;                   // of critical
  std::optional<TargetSpectrum> target;          // for the comparison
  std::array<double, 2> fit_periods{0.05, 1.0};  // s, range of the comparison
};

/// A CSV table: for each component and damping, relative displacement, pseudo-velocity and pseudo-acceleration at 271 frequencies from 0.1
/// to 50 Hz, 100 a decade; then the same columns for each pair (components "geomean", "RotD50", "RotD100"), and for the target within its
/// range.
std::string spectra_csv(const Spectra& s);

/// Prints a line for each component, pair and damping: the factor that best fits its pseudo-accelerations to the target (fit, at 101
/// periods in equal ratios), the remaining misfit, and the least ratio to the target with its period.
/// \throw cases::InputError at "--fit" where the target does not cover the periods, or where a component has no motion.
void print_fits(const Spectra& s, std::ostream& out);

}  // namespace voussoir::io
