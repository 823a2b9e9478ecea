// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "io/input/files/hdf5_file.h"
#include "io/output/measures/measures_file.h"
#include "io/output/results/results.h"

/// Attributes that a run tells of itself: its summary, and how a quasi-static analysis loads.
namespace voussoir::io {

void write_summary(Hdf5File& file, const solver::Summary& s) {
  const std::string at = "/summary";
  file.set_attribute(at, "collapsed", std::int64_t{s.collapsed});
  file.set_attribute(at, "settled", std::int64_t{s.settled});
  file.set_attribute(at, "fallen_mass_fraction", s.fallen_mass_fraction);
  file.set_attribute(at, "first_crack_time", s.first_crack_time);
  file.set_attribute(at, "tension", s.tension);
  file.set_attribute(at, "shear", s.shear);
  file.set_attribute(at, "compression", s.compression);
  file.set_attribute(at, "slipped", s.slipped);
  file.set_attribute(at, "first_tension", s.first.tension);
  file.set_attribute(at, "first_shear", s.first.shear);
  file.set_attribute(at, "first_compression", s.first.compression);
  file.set_attribute(at, "settling_tension", s.settling.tension);
  file.set_attribute(at, "settling_shear", s.settling.shear);
  file.set_attribute(at, "settling_compression", s.settling.compression);
  file.set_attribute(at, "settling_slipped", s.settling.slipped);
  file.set_attribute(at, "peak_base_shear", s.peak_base_shear);
  file.set_attribute(at, "peak_speed", s.peak_speed);
  file.set_attribute(at, "worst_residual", s.worst_residual);
  file.set_attribute(at, "end_time", s.end_time);
  file.set_attribute(at, "units",
                     "first_crack_time (of the shaking; below 0: none), end_time: s; tension, shear, compression, slipped, first_tension, "
                     "first_shear, first_compression, settling_tension, settling_shear, settling_compression, settling_slipped: segment "
                     "sides; "
                     "peak_base_shear: N; peak_speed: m/s; " +
                         figure_units() + "; the others: 1");
}

void write_drive(Hdf5File& file, const solver::Drive& d, std::optional<std::int32_t> control) {
  const std::string at = "/assessment";
  file.make_group(at);
  file.set_attribute(at, "frequency", d.frequency);
  file.set_attribute(at, "damping", d.damping);
  file.set_attribute(at, "pace", d.pace);
  file.set_attribute(at, "compliance", d.compliance);
  file.set_attribute(at, "stiffness", d.stiffness);
  file.set_attribute(at, "fastest", d.fastest);
  file.set_attribute(at, "weight", d.weight);
  file.set_attribute(at, "speed", d.speed);
  file.set_attribute(at, "quiet", d.quiet);
  if (control) file.set_attribute(at, "control", static_cast<std::int64_t>(*control));
  file.set_attribute(
      at, "units",
      std::string("frequency: Hz, the first with all joints closed; damping: 1/s; pace: s; compliance: m at a load factor of "
                  "1; stiffness: load factor per m; fastest: m/s, of the moving end; weight: N, of all forces at a load factor of 1; "
                  "speed: of the histories "
                  "of supports, 1; quiet: J, less than this a structure has that follows its supports; control: element that is the "
                  "control point"));
}

}  // namespace voussoir::io
