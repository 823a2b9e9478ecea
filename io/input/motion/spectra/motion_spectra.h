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
  std::optional<double> stated_peak;  // m/s2, of the file's header
  char axis = 0;                      // 'L', 'T', 'V' where it is known
  std::size_t source = 0;             // number of the argument that it came with
};

/// Two horizontal components of one place.
struct HorizontalPair {
  std::string record;
  std::size_t first = 0, second = 0;  // numbers of the components
};

/// L and T of each argument that has both; else the only two components that there are.
/// \throw cases::InputError at the option that asks for them, if there are no such two, or their steps differ.
std::vector<HorizontalPair> horizontal_pairs(const std::vector<Component>& components, const std::string& option);

/// What is written and compared.
struct Spectra {
  const std::vector<Component>& components;
  std::vector<HorizontalPair> pairs;             // empty: nothing is combined
  std::vector<double> damping;                   // of critical
  std::optional<TargetSpectrum> target;          // to compare with
  std::array<double, 2> fit_periods{0.05, 1.0};  // s, over which it is compared
};

/// A CSV table: for each component and damping, relative displacement, pseudo-velocity and pseudo-acceleration at 271 frequencies from 0.1
/// to 50 Hz, 100 a decade; then the same of each pair (components "geomean", "RotD50", "RotD100"), and of the target within its range.
/// \throw FileError
void write_spectra(const Spectra& s, const std::string& path);

/// A line for each component, pair and damping: the factor that brings its pseudo-accelerations nearest to the target's (fit, at 101
/// periods in equal ratios), what is then left, and where it then lies lowest.
/// \throw cases::InputError at "--fit" where the target does not reach over the periods, or where a component has no motion.
void print_fits(const Spectra& s, std::ostream& out);

}  // namespace voussoir::io
