// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// What the verification manual is made of. Where the environment variable VOUSSOIR_MANUAL names a file, tests append to it, one JSON
/// object a line: a row for each comparison, a curve where one says more, and the processor time of each test case. `scripts/verify` turns
/// the lines into tests/verification/REPORT.md. Elsewhere nothing is written.
namespace voussoir::testing {

/// A comparison with its limit. `error` is relative, absolute or the figure itself, as `kind` says.
struct ManualRow {
  std::string what;
  std::string kind;  // "relative", "absolute", "at most"
  double expected = 0.0, got = 0.0, error = 0.0, limit = 0.0;
};
void write(const ManualRow& row);

struct Series {
  std::string name, style;  // style: as matplotlib writes it, "-", "o", "--"
  std::vector<double> x, y;
};
struct Curve {
  std::string file, title, x, y;  // name of the picture without its ending; axes with units
  bool logarithmic = false;       // both axes
  std::vector<Series> series;
};
void write(const Curve& curve);

/// Notes that the running test case looks at cases/verification/NAME.toml (or a case of the catalogue).
void note_case(const std::string& name);

}  // namespace voussoir::testing
