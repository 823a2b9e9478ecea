// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/assess/assess_options.h"

#include <CLI/CLI.hpp>
#include <string>

#include "io/commands/number_range.h"

namespace voussoir::io {

namespace {

void add_format(CLI::App& command, bool& json) {
  command
      .add_option_function<std::string>(
          "--format", [&json](const std::string& word) { json = word == "json"; }, "text, or json: one object")
      ->check(CLI::IsMember({"text", "json"}));
}

}  // namespace

void add_assess_options(CLI::App& command, AssessOptions& o) {
  command.add_option("DIR", o.folder, "folder of the run, finished or not")->required();
  command.add_option("--time", o.time, "s, of cracks: the frame nearest to it (default: the last)");
  command.add_option("--levels", o.levels, "heights of storeys above the base, m: Z,Z,... (default: foot and top of the walls)")
      ->delimiter(',');
  command.add_option("--maps", o.maps, "write a crack map of every wall into this folder, as SVG");
  command.add_option("--spectra", o.spectra, "write response spectra of the followed points and of the base to this CSV file");
  command.add_option("--damping", o.damping, "damping ratios of the spectra (default 0.05)")->delimiter(',')->check(CLI::Range(0.0, 0.99));
  add_format(command, o.json);
  command.add_flag("--overwrite", o.overwrite, "replace existing files");
  command.footer("example: voussoir assess results/flat20n --time 2 --maps results/flat20n/cracks");
}

void add_limit_options(CLI::App& command, LimitCommandOptions& o) {
  command.add_option("--direction", o.direction,
                     "of the live load: x, -x, y, -y, z, -z, degrees from x towards y, or X,Y,Z (default: x; of point loads -z)");
  command.add_option("--on", o.on, "NAME,...: the live load is the weight of these blocks, stones or groups alone, or --force on each")
      ->delimiter(',');
  command.add_option("--force", o.force, "N (default 1000): the live load is this force, on the blocks of --on, at --at or along --path")
      ->check(number_range(1e-9, 1e15));
  command.add_option("--at", o.at, "X,Y,Z: where the force acts; without --on on the block that holds the point, or the first behind it")
      ->delimiter(',')
      ->expected(3);
  command
      .add_option("--path", o.path,
                  "X,Y,Z,X,Y,Z,...: the force moves along this line, and acts where it meets the model; the weakest place")
      ->delimiter(',');
  command.add_option("--positions", o.positions, "places on the path, both ends among them (default 21)")->check(CLI::Range(1, 10000));
  command.add_option("--facets", o.facets, "of the friction cone (default 8; plane models need none)")->check(CLI::Range(4, 64));
  command
      .add_option_function<std::string>(
          "--cone", [&o](const std::string& word) { o.outer = word == "outer"; },
          "facets in the cone, which err to the safe side (default), or round it")
      ->check(CLI::IsMember({"inner", "outer"}));
  command.add_flag("--associated", o.associated, "associated flow alone, one programme; not Coulomb's slip, which takes 20 to 40 more");
  command.add_option("--mechanism", o.mechanism, "write the velocities of all elements to this CSV file");
  add_format(command, o.json);
  command.add_flag("--overwrite", o.overwrite, "replace an existing file of the mechanism");
  command.add_flag("--quiet", o.quiet, "no progress");
  command.footer("A case with loads that grow has these as live load.\nexample: voussoir limit flat20n --associated");
}

}  // namespace voussoir::io
