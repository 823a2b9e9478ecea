// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/motion_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "cases/names.h"
#include "io/errors.h"
#include "io/text_file.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

using Files = std::array<std::optional<std::string>, 3>;

bool any_given(const Files& files) {
  return std::any_of(files.begin(), files.end(), [](const auto& f) { return f.has_value(); });
}

std::size_t component_index(char letter) { return letter == 'L' ? 0 : letter == 'T' ? 1 : 2; }

std::string path_from(const std::string& folder, const std::string& path) { return (fs::path(folder) / path).string(); }

std::array<cases::Accelerogram, 3> read_files(const Files& files, const std::string& folder, const std::optional<std::string>& unit) {
  std::array<cases::Accelerogram, 3> components;
  for (std::size_t i = 0; i < 3; ++i) {
    if (files[i]) components[i] = read_accelerogram(path_from(folder, *files[i]), unit);
  }
  return components;
}

Record named_record(const cases::Motion& m, const std::string& case_folder) {
  if (*m.record == "bam-like") return {*m.record, cases::bam_like()};
  const std::string folder = path_from(case_folder, *m.record);
  std::error_code error;
  if (!m.record->empty() && fs::is_directory(folder, error)) return read_record_folder(folder, m.unit);
  throw cases::InputError("motion.record", "\"" + *m.record + "\" is neither a record of the program nor a folder (" + folder +
                                               "); allowed: \"bam-like\", or a folder that holds record.toml");
}

void check(const cases::Motion& m) {
  const int ways = (m.record ? 1 : 0) + (any_given(m.xyz) ? 1 : 0) + (any_given(m.ltv) ? 1 : 0);
  if (ways != 1) {
    throw cases::InputError("motion", std::string(ways == 0 ? "names no ground motion" : "names the ground motion in more than one way") +
                                          "; allowed: record, or files for x, y, z, or files for L, T, V");
  }
  std::string letters = m.direction;
  std::sort(letters.begin(), letters.end());
  if (letters != "LTV") {
    throw cases::InputError("motion.direction", "\"" + m.direction + "\" is no order of L, T and V; allowed: LTV, TLV, LVT, TVL, VLT, VTL");
  }
  if (m.unit && !acceleration_unit(*m.unit)) {
    throw cases::InputError("motion.unit", "\"" + *m.unit + "\" is no unit of acceleration; allowed: " + kUnitNames);
  }
  for (const double s : m.scale) {
    if (!std::isfinite(s)) throw cases::InputError("motion.scale", "is " + cases::text(s) + "; allowed: finite numbers");
  }
}

}  // namespace

std::optional<double> acceleration_unit(std::string_view name) {
  const std::string text = upper(trimmed(name));
  const auto is_one_of = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* n) { return text == n; });
  };
  if (text == "G") return cases::kStandardGravity;
  if (is_one_of({"M/S2", "M/S^2", "M/S**2", "M/S/S", "M/SEC2", "M/SEC^2", "M/SEC/SEC"})) return 1.0;
  if (is_one_of({"CM/S2", "CM/S^2", "CM/S**2", "CM/S/S", "CM/SEC2", "CM/SEC^2", "CM/SEC/SEC", "GAL"})) return 0.01;
  return std::nullopt;
}

cases::Accelerogram read_accelerogram(const std::string& path, const std::optional<std::string>& unit) {
  const std::string ending = upper(fs::path(path).extension().string());
  // VT2 and DT2 go to the same reader: their third line says what they hold, and so does its refusal.
  if (ending == ".AT2" || ending == ".VT2" || ending == ".DT2") return read_at2(path);
  if (ending == ".CSV" || ending == ".TXT") return read_motion_csv(path, unit);
  const std::string text = read_text_file(path, kLargestMotionFile);
  LineReader lines(text);
  for (int number = 1; number <= 3; ++number) {
    const auto line = lines.next();
    if (line && number == 3 && upper(*line).find("IN UNITS OF") != std::string::npos) return read_at2(path);
  }
  throw FileError(path, "is in no format that is read; allowed: PEER AT2 (.AT2), or two columns of time and acceleration (.csv, .txt)");
}

cases::GroundMotion load_motion(const cases::Motion& motion, const std::string& case_folder) {
  check(motion);
  const bool turned = !any_given(motion.xyz);
  std::array<cases::Accelerogram, 3> read =
      motion.record ? named_record(motion, case_folder).ltv : read_files(turned ? motion.ltv : motion.xyz, case_folder, motion.unit);
  cases::GroundMotion result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = turned ? component_index(motion.direction[i]) : i;
    for (double& a : read[from].acceleration) a *= motion.scale[from];
    result.axis[i] = std::move(read[from]);
  }
  return result;
}

}  // namespace voussoir::io
