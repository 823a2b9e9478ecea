// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/motion_spectra.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <ostream>
#include <sstream>

#include "cases/input_error.h"
#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/files/whole_file.h"
#include "io/input/motion/spectra/figures.h"

namespace voussoir::io {
namespace {

constexpr int kFrequencies = 271;
constexpr double kLowest = 0.1, kHighest = 50.0;  // Hz
constexpr int kFitPeriods = 101;

double angular(double frequency) { return 2.0 * std::numbers::pi * frequency; }

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Relative displacements [m] at some frequencies, of a component or a combination.
struct Curve {
  std::string record, name;
  std::vector<double> sd;
};

/// Curves of all components and pairs for one damping ratio.
std::vector<Curve> curves(const Spectra& s, double damping, const std::vector<double>& frequencies) {
  std::vector<Curve> all;
  for (const Component& c : s.components) {
    Curve curve{c.record, c.name, {}};
    for (const double f : frequencies) curve.sd.push_back(spectral_displacement(c.motion, f, damping));
    all.push_back(std::move(curve));
  }
  for (const HorizontalPair& p : s.pairs) {
    Curve mean{p.record, "geomean", {}}, median{p.record, "RotD50", {}}, largest{p.record, "RotD100", {}};
    for (const double f : frequencies) {
      const auto d = combined_displacement(s.components[p.first].motion, s.components[p.second].motion, f, damping);
      mean.sd.push_back(d.geometric_mean), median.sd.push_back(d.rotd50), largest.sd.push_back(d.rotd100);
    }
    for (Curve* c : {&mean, &median, &largest}) all.push_back(std::move(*c));
  }
  return all;
}

void write_row(std::ostream& out, const std::string& record, const std::string& name, double damping, double f, double sd) {
  const double w = angular(f);
  char line[160];
  std::snprintf(line, sizeof line, ",%.6g,%.6g,%.6g,%.8g,%.8g,%.8g\n", damping, f, 1.0 / f, sd, w * sd, w * w * sd);
  out << csv_field(record) << ',' << csv_field(name) << line;
}

/// Writes rows of the target within its range.
void write_target(std::ostream& out, const Spectra& s, const std::vector<double>& frequencies) {
  for (const double damping : s.damping) {
    for (const double f : frequencies) {
      const auto sa = value_at(*s.target, 1.0 / f, damping);
      if (sa) write_row(out, s.target->name, "target", damping, f, *sa / (angular(f) * angular(f)));
    }
  }
}

/// Target accelerations at the periods. \throw InputError at "--fit" outside the target's range
std::vector<double> target_values(const Spectra& s, const std::vector<double>& periods, double damping) {
  std::vector<double> values;
  for (const double period : periods) {
    const auto value = value_at(*s.target, period, damping);
    if (!value) {
      throw cases::InputError("--fit", "from " + cases::text(s.fit_periods[0]) + " to " + cases::text(s.fit_periods[1]) +
                                           " s: " + s.target->name + " has no value at " + cases::text(period) +
                                           " s; allowed: periods within its range");
    }
    values.push_back(*value);
  }
  return values;
}

void print_fit(const Curve& c, double damping, const std::vector<double>& periods, const std::vector<double>& target, std::size_t width,
               std::ostream& out) {
  std::vector<double> accelerations;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    const double w = angular(1.0 / periods[i]), sa = w * w * c.sd[i];
    if (!(sa > 0.0)) throw cases::InputError("--fit", c.record + " " + c.name + " has no motion; allowed: components that move");
    accelerations.push_back(sa);
  }
  const SpectrumFit best = fit(accelerations, target);
  char line[160];
  std::snprintf(line, sizeof line, "  %-9s %8.6g %8.4f %8.3f %8.3f %8.3f\n", c.name.c_str(), damping, best.factor, best.misfit, best.lowest,
                periods[best.lowest_at]);
  out << c.record << std::string(width - c.record.size(), ' ') << line;
}

}  // namespace

std::vector<HorizontalPair> horizontal_pairs(const std::vector<Component>& components, const std::string& option) {
  std::vector<HorizontalPair> pairs;
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i].axis != 'L') continue;
    for (std::size_t j = 0; j < components.size(); ++j) {
      if (components[j].axis == 'T' && components[j].source == components[i].source) pairs.push_back({components[i].record, i, j});
    }
  }
  if (pairs.empty() && components.size() == 2) pairs.push_back({components[0].record + " + " + components[1].record, 0, 1});
  if (pairs.empty()) {
    throw cases::InputError(option,
                            std::to_string(components.size()) +
                                " components, and nothing says which two are horizontal; allowed: records that have L and T, or two files");
  }
  for (const HorizontalPair& p : pairs) {
    const cases::Accelerogram &a = components[p.first].motion, &b = components[p.second].motion;
    if (a.dt != b.dt) {
      throw cases::InputError(option, p.record + ": steps of " + cases::text(a.dt) + " and " + cases::text(b.dt) +
                                          " s; allowed: two components of the same step");
    }
  }
  return pairs;
}

std::string spectra_csv(const Spectra& s) {
  std::vector<double> frequencies;
  for (int i = 0; i < kFrequencies; ++i) frequencies.push_back(kLowest * std::pow(kHighest / kLowest, i / (kFrequencies - 1.0)));
  std::ostringstream out;
  out << "record,component,damping,frequency [Hz],period [s],Sd [m],Sv [m/s],Sa [m/s2]\n";
  std::vector<std::vector<Curve>> of_damping;
  for (const double damping : s.damping) of_damping.push_back(curves(s, damping, frequencies));
  for (std::size_t c = 0; c < of_damping.front().size(); ++c) {
    for (std::size_t z = 0; z < s.damping.size(); ++z) {
      const Curve& curve = of_damping[z][c];
      for (std::size_t i = 0; i < frequencies.size(); ++i)
        write_row(out, curve.record, curve.name, s.damping[z], frequencies[i], curve.sd[i]);
    }
  }
  if (s.target) write_target(out, s, frequencies);
  return out.str();
}

void print_fits(const Spectra& s, std::ostream& out) {
  const std::vector<double> periods = periods_between(s.fit_periods[0], s.fit_periods[1], kFitPeriods);
  std::vector<double> frequencies;
  for (const double period : periods) frequencies.push_back(1.0 / period);
  std::size_t width = 6;
  for (const Component& c : s.components) width = std::max(width, c.record.size());
  for (const HorizontalPair& p : s.pairs) width = std::max(width, p.record.size());
  out << "\ntarget " << s.target->name << ", fitted from " << cases::text(s.fit_periods[0]) << " to " << cases::text(s.fit_periods[1])
      << " s: the factor makes the mean square of ln(factor x Sa / target) least\n";
  char line[160];
  std::snprintf(line, sizeof line, "  %-9s %8s %8s %8s %8s %8s\n", "component", "damping", "factor", "misfit", "lowest", "at [s]");
  out << "record" << std::string(width - 6, ' ') << line;
  for (const double damping : s.damping) {
    const std::vector<double> target = target_values(s, periods, damping);
    for (const Curve& c : curves(s, damping, frequencies)) print_fit(c, damping, periods, target, width, out);
  }
}

}  // namespace voussoir::io
