// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/case_words.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "cases/input_error.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/likely_slips.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/process.h"
#include "io/input/case_file/case_paths.h"
#include "io/input/document/case_values.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/motion_files.h"
#include "io/input/stones/stones.h"

namespace voussoir::io {
namespace {

/// Makes a path of the command line absolute, since it starts at the working folder, not at the case's.
std::string from_here(const std::string& path) { return std::filesystem::absolute(path).lexically_normal().string(); }

/// Overrides for a record or files of the command line, which replace those of the case (apply_overrides).
std::vector<std::string> motion_overrides(const CaseWords& w) {
  std::vector<std::string> given;
  const auto give = [&](const std::string& key, const std::string& value) { given.push_back("motion." + key + "=" + toml_string(value)); };
  if (!w.direction.empty()) give("direction", w.direction);
  const bool in_folder = !is_built_in_record(w.record) && std::filesystem::exists(w.record);
  if (!w.record.empty()) give("record", in_folder ? from_here(w.record) : w.record);
  for (const std::string& m : w.motion) {
    const std::size_t equals = m.find('=');
    if (equals == std::string::npos || equals + 1 == m.size()) {
      throw cases::InputError("--motion", toml_string(m) + " is not AXIS=FILE; allowed axes: x, y, z, L, T, V");
    }
    give(m.substr(0, equals), from_here(m.substr(equals + 1)));
  }
  return given;
}

std::vector<std::string> overrides(const CaseWords& w) {
  std::vector<std::string> all = motion_overrides(w);
  if (!w.scale.empty()) all.push_back("motion.scale=" + w.scale);
  if (!w.duration.empty()) all.push_back("time.duration=" + w.duration);
  if (!w.dt.empty()) all.push_back("time.step=" + (w.dt == "auto" ? toml_string(w.dt) : w.dt));
  if (!w.frames.empty()) all.push_back("output.frame_interval=" + w.frames);
  all.insert(all.end(), w.set.begin(), w.set.end());
  return all;
}

/// Notes all files that the case names as inputs of the command, also those that it does not read.
void note_files_of(cases::Case value) {
  for_each_path(value, [&](std::string& path) { note_input((std::filesystem::path(value.folder) / path).string()); });
}

}  // namespace

void add_case(CLI::App& command, CaseWords& w) {
  command.add_option("CASE", w.name, "a name of the catalogue (see `voussoir cases`), or the path of a .toml file")->required();
  command.add_option("--set", w.set, "override a key of the case: a.b[0].c=value (may be repeated)");
  add_threads(command, w.threads);
}

void add_short_keys(CLI::App& command, CaseWords& w) {
  command.add_option("--direction", w.direction, "which of L, T, V goes to x, y, z: LTV, TLV, ...");
  command.add_option("--record", w.record, "name of a built-in record, a folder that holds record.toml, or a file that holds L, T and V");
  command.add_option("--motion", w.motion, "AXIS=FILE ...: files of ground motion, behind CASE: L=A.AT2 T=B.AT2 V=C.AT2, or x, y, z");
  command.add_option("--scale", w.scale, "factor on the motion, or [L, T, V]");
  command.add_option("--duration", w.duration, "of shaking, s");
  command.add_option("--dt", w.dt, "step in s, or auto: the largest stable one");
  command.add_option("--frames", w.frames, "interval of frames, s");
}

int with_case(const CaseWords& w, const std::function<int(const LoadedCase&)>& use, Fill fill) {
  now_doing("reading the case");
  LoadedCase c = load_case(w.name, overrides(w));
  for (const std::string& note : c.notes) say_note(note);
  warn_of(c.findings);
  note_files_of(c.value);
  try {
    if (fill != Fill::none) {
      now_doing("reading the stones");
      load_stones(c.value);
    }
    if (fill == Fill::all) fill_own_frequency(c.value, w.threads);
    return use(c);
  } catch (const cases::InputError& e) {
    say_errors(kInputFault, c.messages(e));
    return kInputFault;
  } catch (const NamedFileError& e) {
    say_error(kFileFault, c.messages({e.key(), std::string("cannot be used: ") + e.what()}).front());
    return kFileFault;
  }
}

}  // namespace voussoir::io
