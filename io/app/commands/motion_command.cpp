// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/motion_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "cases/input_error.h"
#include "cases/names.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/commands/words/number_range.h"
#include "io/app/session/process.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/input/motion/spectra/motion_spectra.h"
#include "io/input/motion/spectra/target_file.h"
#include "io/input/motion/treatment.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

constexpr double kShortestPeriod = 1e-3, kLongestPeriod = 1e3;  // s, between which spectra are compared

/// An argument: a record of three components, or the components of a file.
struct MotionSource {
  Record record;
  std::vector<Component> of_file;
};

MotionSource read_source(const std::string& argument, const Unstated& unstated) {
  std::error_code error;
  if (is_built_in_record(argument) && !fs::exists(argument, error)) return {built_in_record(argument, ""), {}};
  if (fs::is_directory(argument, error)) return {read_record_folder(argument, unstated), {}};
  const bool exists = fs::exists(argument, error);
  if (!exists && argument.find('#') == std::string::npos) {
    throw FileError(argument, "no such file; allowed: a file, FILE#COMPONENT, a folder that holds record.toml, bam-like, or bam-like#N");
  }
  MotionSource source;
  std::vector<Channel> channels = exists ? read_motion_file(argument, unstated) : std::vector<Channel>{read_channel(argument, unstated)};
  for (Channel& c : channels) {
    const std::string name = c.component.empty() ? "-" : c.component;
    source.of_file.push_back({fs::path(argument).filename().string(), name, std::move(c.motion), c.stated_peak, c.axis, 0});
  }
  return source;
}

void cut(cases::Accelerogram& a, double until) {
  if (a.acceleration.empty()) return;
  const double samples = std::floor(until / a.dt * (1.0 + 1e-12)) + 1.0;
  if (samples < static_cast<double>(a.acceleration.size())) a.acceleration.resize(static_cast<std::size_t>(samples));
}

/// Cuts, corrects and tapers the components.
void prepare(MotionSource& s, const MotionOptions& o) {
  if (o.until) {
    for (auto& a : s.record.ltv) cut(a, *o.until);
    for (Component& c : s.of_file) cut(c.motion, *o.until);
  }
  treat(s.record.ltv, o.treatment, "--");
  for (Component& c : s.of_file) {
    std::array<cases::Accelerogram, 3> one{std::move(c.motion)};
    treat(one, o.treatment, "--");
    c.motion = std::move(one[0]);
  }
}

void check_spectra(const MotionOptions& o) {
  if (o.combine && !o.spectra && !o.target)
    throw cases::InputError("--combine", "is of spectra; allowed: with --spectra FILE.csv, or with --target");
  if (!(o.fit[0] >= kShortestPeriod && o.fit[1] > o.fit[0] && o.fit[1] <= kLongestPeriod)) {
    throw cases::InputError(
        "--fit", "from " + cases::text(o.fit[0]) + " to " + cases::text(o.fit[1]) + " s; allowed: two rising periods from 0.001 to 1000 s");
  }
}

Output spectra_of(const MotionOptions& o) { return {o.spectra.value_or(""), FileKind::table, "--spectra", o.overwrite}; }

void check(const std::vector<std::string>& arguments, const MotionOptions& o) {
  if (arguments.empty())
    throw cases::InputError("", "no record named; allowed: files, folders that hold record.toml, bam-like, bam-like#N");
  if (o.unit && !acceleration_unit(*o.unit)) throw cases::InputError("--unit", shown(*o.unit) + "; allowed: " + kUnitNames);
  if (o.until && !(*o.until > 0.0)) throw cases::InputError("--until", cases::text(*o.until) + " s; allowed: above 0");
  for (const double z : o.damping) {
    if (!(z >= 0.0 && z < 1.0)) throw cases::InputError("--damping", cases::text(z) + "; allowed: from 0 to below 1 (of critical)");
  }
  if (o.json && (o.target || !o.periods.empty()))
    throw cases::InputError("--format", "json has the figures of the components alone; leave out --intensity and --target");
  if (o.until && o.treatment.to) throw cases::InputError("--until", "does not go with --to; give one of them");
  if (o.dt && !(*o.dt >= kShortestStep && *o.dt <= kLongestStep))
    throw cases::InputError("--dt", cases::text(*o.dt) + " s; allowed: from 1e-6 to 10");
  check_spectra(o);
  if ((o.spectra || o.target) && o.damping.empty())
    throw cases::InputError("--damping", "no value; allowed: from 0 to below 1 (of critical)");
  std::error_code error;
  for (const std::string& argument : arguments)
    note_input(fs::exists(argument, error) ? argument : argument.substr(0, argument.rfind('#')));
  if (o.target) note_input(*o.target);
  check_output(spectra_of(o));
  if (o.write && arguments.size() != 1) {
    throw cases::InputError("--write", std::to_string(arguments.size()) + " records named; allowed: one");
  }
}

std::vector<Component> components_of(std::vector<MotionSource>& sources) {
  std::vector<Component> all;
  for (std::size_t n = 0; n < sources.size(); ++n) {
    MotionSource& s = sources[n];
    for (Component& c : s.of_file) {
      c.source = n;
      all.push_back(c);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (s.record.ltv[i].acceleration.empty()) continue;
      all.push_back({s.record.name, std::string(1, "LTV"[i]), s.record.ltv[i], std::nullopt, "LTV"[i], n});
    }
  }
  return all;
}

/// Renames sources that share a name by the arguments of the user.
void tell_apart(std::vector<MotionSource>& sources, const std::vector<std::string>& arguments) {
  const auto name_of = [](MotionSource& s) -> std::string& { return s.of_file.empty() ? s.record.name : s.of_file.front().record; };
  std::map<std::string, int> uses;
  for (MotionSource& s : sources) ++uses[name_of(s)];
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (uses[name_of(sources[i])] == 1) continue;
    sources[i].record.name = arguments[i];
    for (Component& c : sources[i].of_file) c.record = arguments[i];
  }
}

void write_record(const MotionSource& source, const std::string& argument, const MotionOptions& o) {
  if (!source.of_file.empty())
    throw cases::InputError("--write", shown(argument) + " is a single file; allowed: bam-like, bam-like#N, or a folder");
  for (const cases::Accelerogram& a : source.record.ltv) {
    if (a.acceleration.size() == 1)
      throw cases::InputError("--until", cases::text(*o.until) + " s leaves one sample; allowed: " + cases::text(a.dt) + " s or more");
  }
  write_record_folder(source.record, *o.write, o.overwrite);
}

void print_table(const std::vector<Component>& components, std::ostream& out) {
  std::size_t width = 6;
  for (const Component& c : components) width = std::max(width, c.record.size());
  const auto name_column = [width](const std::string& text) { return text + std::string(width - text.size(), ' '); };
  char line[320];
  std::snprintf(line, sizeof line, "  %-9s %8s %8s %8s %9s %8s %8s %8s %8s %8s %7s %7s %8s\n", "component", "dt", "samples", "duration",
                "PGA", "PGA", "at", "PGV", "PGD", "Arias", "D5-75", "D5-95", "stated");
  out << name_column("record") << line;
  std::snprintf(line, sizeof line, "  %-9s %8s %8s %8s %9s %8s %8s %8s %8s %8s %7s %7s %8s\n", "", "s", "", "s", "m/s2", "g", "s", "m/s",
                "m", "m/s", "s", "s", "m/s2");
  out << name_column("") << line;
  for (const Component& c : components) {
    const MotionFigures f = figures(c.motion);
    char stated[32] = "-";
    if (c.stated_peak) std::snprintf(stated, sizeof stated, "%.4f", *c.stated_peak);
    std::snprintf(line, sizeof line, "  %-9s %8.6g %8zu %8.3f %9.4f %8.5f %8.3f %8.4f %8.4f %8.4f %7.3f %7.3f %8s\n", c.name.c_str(),
                  c.motion.dt, c.motion.acceleration.size(), f.duration, f.peak_acceleration, f.peak_acceleration / cases::kStandardGravity,
                  f.peak_time, f.peak_velocity, f.peak_displacement, f.arias, f.d5_75, f.d5_95, stated);
    out << name_column(c.record) << line;
  }
}

using Json = nlohmann::ordered_json;

/// One object a component, in SI units.
void print_json(const std::vector<Component>& components, std::ostream& out) {
  Json all = Json::array();
  for (const Component& c : components) {
    const MotionFigures f = figures(c.motion);
    all.push_back({{"record", c.record},
                   {"component", c.name},
                   {"dt", c.motion.dt},
                   {"samples", c.motion.acceleration.size()},
                   {"duration", f.duration},
                   {"peak_acceleration", f.peak_acceleration},
                   {"peak_time", f.peak_time},
                   {"peak_velocity", f.peak_velocity},
                   {"peak_displacement", f.peak_displacement},
                   {"arias", f.arias},
                   {"d5_75", f.d5_75},
                   {"d5_95", f.d5_95},
                   {"stated_peak", c.stated_peak ? Json(*c.stated_peak) : Json(nullptr)}});
  }
  out << all.dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
}

/// A value of two components, or why there is none.
std::string intensity_text(const cases::MotionIntensity& m, const cases::Accelerogram& a, const cases::Accelerogram& b) {
  if (m.components == cases::IntensityOf::rotd50 && a.dt != b.dt) return "other steps";
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.4g", intensity(m, a, b));
  return digits;
}

/// Prints what motion.intensity can bring to a level, for each pair of horizontal components as recorded.
void print_intensities(const std::vector<Component>& components, const std::vector<double>& periods, std::ostream& out) {
  using cases::IntensityMeasure, cases::IntensityOf;
  std::vector<cases::MotionIntensity> measures{{.measure = IntensityMeasure::pga}, {.measure = IntensityMeasure::pgv}};
  for (const double period : periods) measures.push_back({.measure = IntensityMeasure::sa, .period = period});
  out << "\nintensity, which motion.intensity brings to a level, of each horizontal component, or of both by motion.intensity.components\n";
  for (const HorizontalPair& pair : horizontal_pairs(components, "--intensity")) {
    const Component &a = components[pair.first], &b = components[pair.second];
    char line[160];
    std::snprintf(line, sizeof line, "  %-18s %11s %11s %15s %11s %11s\n", "measure", a.name.c_str(), b.name.c_str(), "geometric mean",
                  "RotD50", "larger");
    out << pair.record << ":\n" << line;
    for (const cases::MotionIntensity& m : measures) {
      const auto of_both = [&](IntensityOf components_of) {
        cases::MotionIntensity of = m;
        of.components = components_of;
        return intensity_text(of, a.motion, b.motion);
      };
      const std::string measure = intensity_name(m) + ", " + intensity_unit(m);
      std::snprintf(line, sizeof line, "  %-18s %11s %11s %15s %11s %11s\n", measure.c_str(), intensity_text(m, a.motion, {}).c_str(),
                    intensity_text(m, {}, b.motion).c_str(), of_both(IntensityOf::geometric_mean).c_str(),
                    of_both(IntensityOf::rotd50).c_str(), of_both(IntensityOf::larger).c_str());
      out << line;
    }
  }
}

/// Adds options for the keys of [motion] with the same names.
void add_treatment(CLI::App& command, cases::MotionTreatment& t) {
  command.add_option("--from", t.from, "s: begin there, and call it time zero")->check(number_range(0.0, 1e9));
  command.add_option("--to", t.to, "s, of the record: end there")->check(number_range(1e-9, 1e9));
  static const std::map<std::string, cases::Baseline> baselines{{"none", cases::Baseline::none},
                                                                {"mean", cases::Baseline::mean},
                                                                {"linear", cases::Baseline::linear},
                                                                {"parabolic", cases::Baseline::parabolic}};
  command
      .add_option_function<std::string>(
          "--baseline", [&t](const std::string& name) { t.baseline = baselines.at(name); }, "take off what is left of the baseline")
      ->check(CLI::IsMember({"none", "mean", "linear", "parabolic"}));
  command
      .add_option_function<double>(
          "--taper", [&t](const double& seconds) { t.taper.fill(seconds); }, "s: half a cosine at both ends")
      ->check(number_range(0.0, 1e9));
}

struct MotionWords {
  std::vector<std::string> files;
  MotionOptions o;
};

}  // namespace

int motion_command(const std::vector<std::string>& arguments, const MotionOptions& o, std::ostream& out) {
  start_command();
  now_doing("reading the records");
  check(arguments, o);
  std::vector<MotionSource> sources;
  for (const std::string& argument : arguments) {
    MotionSource s = read_source(argument, {o.unit, o.dt});
    prepare(s, o);
    sources.push_back(std::move(s));
  }
  tell_apart(sources, arguments);
  const std::vector<Component> components = components_of(sources);
  Spectra spectra{components, {}, o.damping, {}, o.fit};
  if (o.combine) spectra.pairs = horizontal_pairs(components, "--combine");
  if (o.target) spectra.target = read_target(*o.target, o.unit);
  std::ostringstream fits;  // printed later, so that faults are found before anything is written
  if (!o.periods.empty()) print_intensities(components, o.periods, fits);
  if (o.target) print_fits(spectra, fits);
  if (o.write) write_record(sources[0], arguments[0], o);
  if (o.spectra) write_output(spectra_of(o), spectra_csv(spectra));
  if (o.json) {
    print_json(components, out);
    return 0;
  }
  print_table(components, out);
  if (const std::string done = described(o.treatment); !done.empty()) out << "\n" << done << "\n";
  out << fits.str();
  return 0;
}

int motion_command(const std::vector<std::string>& arguments, const MotionOptions& o) { return motion_command(arguments, o, std::cout); }

Command add_motion(CLI::App& program) {
  CLI::App* words = program.add_subcommand("motion", "peaks, durations, Arias intensity and response spectra of records");
  auto w = std::make_shared<MotionWords>();
  words
      ->add_option("FILE", w->files,
                   "files of any format that is read (FILE#COMPONENT: one of several), folders with a record.toml, bam-like, or "
                   "bam-like#N: realisation N of its family")
      ->required();
  words->add_option("--spectra", w->o.spectra, "write response spectra to this CSV file");
  words->add_option("--damping", w->o.damping, "damping ratios of the spectra (default 0.02)");
  words->add_option("--until", w->o.until, "use the first seconds only")->check(number_range(1e-9, 1e9));
  words->add_option("--unit", w->o.unit, "g, m/s2 or cm/s2, where a format does not say");
  words->add_option("--dt", w->o.dt, "s between samples, where a format does not say (one column)");
  add_treatment(*words, w->o.treatment);
  words->add_flag("--combine", w->o.combine, "spectra of the two horizontal components together, too: geometric mean, RotD50, RotD100");
  words
      ->add_option("--intensity", w->o.periods,
                   "print the measures of motion.intensity, too: PGA, PGV, and Sa at these periods, s; of each horizontal component and of "
                   "both together")
      ->check(number_range(0.01, 20.0))
      ->allow_extra_args(false)
      ->delimiter(',');
  words->add_option("--target", w->o.target,
                    "compare with a spectrum, and print the factor that fits: a file of period [s] and acceleration, or Eurocode 8 as "
                    "ec8:TYPE:GROUND:AG (ec8:1:B:0.3g)");
  words->add_option("--fit", w->o.fit, "two periods between which it is compared, s (default 0.05 1)")->allow_extra_args(false);
  words->add_option("--write", w->o.write, "write the record as CSV files into this folder");
  add_format(*words, w->o.json);
  words->add_flag("--overwrite", w->o.overwrite, "replace existing files");
  words->footer("example: voussoir motion bam-like --spectra spectra.csv");
  return {.words = words, .work = [w] { return motion_command(w->files, w->o); }};
}

}  // namespace voussoir::io
