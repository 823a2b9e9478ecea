// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/motion_options.h"

#include <CLI/CLI.hpp>
#include <map>

#include "io/commands/number_range.h"

namespace voussoir::io {
namespace {

/// The keys of [motion] of the same names.
void add_treatment(CLI::App& command, cases::MotionTreatment& t) {
  command.add_option("--from", t.from, "s: begin there, and call it time zero")->check(number_range(0.0, 1e9));
  command.add_option("--to", t.to, "s, of the record: end there")->check(number_range(1e-9, 1e9));
  const std::map<std::string, cases::Baseline> baselines{{"none", cases::Baseline::none},
                                                         {"mean", cases::Baseline::mean},
                                                         {"linear", cases::Baseline::linear},
                                                         {"parabolic", cases::Baseline::parabolic}};
  command.add_option("--baseline", t.baseline, "take off what is left of the baseline: none, mean, linear or parabolic")
      ->transform(CLI::CheckedTransformer(baselines));
  command
      .add_option_function<double>(
          "--taper", [&t](const double& seconds) { t.taper.fill(seconds); }, "s: half a cosine at both ends")
      ->check(number_range(0.0, 1e9));
}

}  // namespace

void add_motion_options(CLI::App& command, std::vector<std::string>& files, MotionOptions& o) {
  command
      .add_option("FILE", files,
                  "files of any format that is read (FILE#COMPONENT: one of several), folders with a record.toml, bam-like, or "
                  "bam-like#N: realisation N of its family")
      ->required();
  command.add_option("--spectra", o.spectra, "write response spectra to this CSV file");
  command.add_option("--damping", o.damping, "damping ratios of the spectra (default 0.02)");
  command.add_option("--until", o.until, "use the first seconds only");
  command.add_option("--unit", o.unit, "g, m/s2 or cm/s2, where a format does not say");
  command.add_option("--dt", o.dt, "s between samples, where a format does not say (one column)");
  add_treatment(command, o.treatment);
  command.add_flag("--combine", o.combine, "spectra of the two horizontal components together, too: geometric mean, RotD50, RotD100");
  command
      .add_option(
          "--intensity", o.periods,
          "print the measures of motion.intensity, too, of both horizontal components together: PGA, PGV, and Sa at these periods, s")
      ->check(number_range(0.01, 20.0))
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--target", o.target,
                     "compare with a spectrum, and print the factor that fits: a file of period [s] and acceleration, or Eurocode 8 as "
                     "ec8:TYPE:GROUND:AG (ec8:1:B:0.3g)");
  command.add_option("--fit", o.fit, "two periods between which it is compared, s (default 0.05 1)")->allow_extra_args(false);
  command.add_option("--write", o.write, "write the record as CSV files into this folder");
  command.add_flag("--overwrite", o.overwrite, "replace existing files");
  command.footer("example: voussoir motion bam-like --spectra spectra.csv");
}

}  // namespace voussoir::io
