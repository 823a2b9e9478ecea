// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/motion_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cases/case.h"
#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/input/motion/treatment.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

using Files = std::array<std::optional<std::string>, 3>;

constexpr std::array<char, 3> kLtv{'L', 'T', 'V'};

bool any_given(const Files& files) {
  return std::any_of(files.begin(), files.end(), [](const auto& f) { return f.has_value(); });
}

std::string path_from(const std::string& folder, const std::string& path) { return (fs::path(folder) / path).string(); }

Unstated unstated_of(const cases::Motion& m) { return {m.unit, m.dt}; }

/// Reads the component files of a motion.
/// \param axes  component taken from files[i] if it has several, as in read_accelerogram
/// \param keys  of the files, in motion
std::array<cases::Accelerogram, 3> read_files(const Files& files, const std::array<char, 3>& axes, std::string_view keys,
                                              const std::string& folder, const Unstated& unstated) {
  std::array<cases::Accelerogram, 3> components;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!files[i]) continue;
    try {
      components[i] = read_accelerogram(path_from(folder, *files[i]), unstated, axes[i]);
    } catch (const FileError& e) {
      throw NamedFileError(e, std::string("motion.") + keys[i]);
    }
  }
  return components;
}

constexpr std::size_t kMostNames = 1000;  // of files among which a similar one is looked for

Record named_record(const cases::Motion& m, const std::string& case_folder) {
  if (is_built_in_record(*m.record)) return built_in_record(*m.record, "motion.record");
  const std::string folder = path_from(case_folder, *m.record);
  std::error_code error;
  try {
    if (!m.record->empty() && fs::is_directory(folder, error)) return read_record_folder(folder, unstated_of(m));
    if (!m.record->empty() && fs::exists(folder, error)) return read_record_file(folder, unstated_of(m));
  } catch (const FileError& e) {
    throw NamedFileError(e, "motion.record");
  }
  std::vector<std::string> names{"bam-like"};
  const std::string before = m.record->substr(0, m.record->rfind('/') + 1);
  for (const fs::directory_entry& file : fs::directory_iterator(fs::path(folder).parent_path(), error))
    if (names.size() < kMostNames) names.push_back(before + file.path().filename().string());
  std::ranges::sort(names);
  throw cases::InputError("motion.record", "\"" + *m.record + "\" is neither a record of the program nor a folder or file (" + folder +
                                               "); " + cases::did_you_mean(*m.record, names) + "allowed: " + built_in_records() +
                                               ", a folder that holds record.toml, or a file that holds L, T and V");
}

void check_intensity(const cases::MotionIntensity& of) {
  if (!(of.level > 0.0) || !std::isfinite(of.level))
    throw cases::InputError("motion.intensity.level", "is " + cases::text(of.level) + "; allowed: > 0");
  if (of.measure == cases::IntensityMeasure::sa && !(of.period && *of.period > 0.0))
    throw cases::InputError("motion.intensity.period", "is missing; Sa needs a period above 0 s");
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
  if (m.dt && !(*m.dt >= kShortestStep && *m.dt <= kLongestStep)) {
    throw cases::InputError("motion.dt", "is " + cases::text(*m.dt) + " s; allowed: from 1e-6 to 10 s");
  }
  for (const double s : m.scale) {
    if (!std::isfinite(s)) throw cases::InputError("motion.scale", "is " + cases::text(s) + "; allowed: finite numbers");
  }
  if (m.intensity) check_intensity(*m.intensity);
}

/// Scales a component. \throw InputError at the key if results are not finite
void multiply(cases::Accelerogram& component, double factor, const char* key) {
  for (double& a : component.acceleration) {
    a *= factor;
    if (!std::isfinite(a)) throw cases::InputError(key, "makes accelerations that are no finite numbers");
  }
}

}  // namespace

Record read_record_file(const std::string& path, const Unstated& unstated) {
  Record record{fs::path(path).filename().string(), {}};
  std::vector<Channel> channels = read_motion_file(path, unstated);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto marked = [&](const Channel& c) { return c.axis == kLtv[i]; };
    if (std::count_if(channels.begin(), channels.end(), marked) != 1) {
      throw FileError(path, std::string("does not mark one of its components as ") + kLtv[i] + ", as a record must; it holds " +
                                component_list(channels) + ", which the keys L, T and V can name, as in \"" + record.name + "#1\"");
    }
    record.ltv[i] = std::find_if(channels.begin(), channels.end(), marked)->motion;
  }
  return record;
}

std::optional<double> acceleration_unit(std::string_view name) {
  std::string text = upper(trimmed(name));
  if (text.ends_with('.')) text.pop_back();
  // "m/s²" and "m·s⁻²", in UTF-8 and in Latin-1; longer encodings of a sign first
  using Sign = std::pair<std::string_view, std::string_view>;
  for (const auto& [sign, plain] : {Sign{"\xC2\xB2", "2"}, Sign{"\xB2", "2"}, Sign{"\xC2\xB7", ""}, Sign{"\xE2\x81\xBB", "-"}}) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at)) text.replace(at, sign.size(), plain);
  }
  std::erase(text, ' ');
  const auto is_one_of = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* n) { return text == n; });
  };
  if (text == "G") return cases::kStandardGravity;
  if (is_one_of({"M/S2", "M/S^2", "M/S**2", "M/S/S", "M/SEC2", "M/SEC^2", "M/SEC/SEC", "MS-2", "MS^-2"})) return 1.0;
  if (is_one_of({"CM/S2", "CM/S^2", "CM/S**2", "CM/S/S", "CM/SEC2", "CM/SEC^2", "CM/SEC/SEC", "CMS-2", "CMS^-2", "GAL"})) return 0.01;
  if (is_one_of({"MM/S2", "MM/S^2", "MM/S/S"})) return 0.001;
  return std::nullopt;
}

std::size_t component_along(const cases::Motion& motion, std::size_t axis) {
  return any_given(motion.xyz) ? axis : std::string_view("LTV").find(motion.direction[axis]);
}

cases::GroundMotion load_motion(const cases::Motion& motion, const std::string& case_folder) {
  check(motion);
  const bool turned = !any_given(motion.xyz);
  std::array<cases::Accelerogram, 3> read = motion.record ? named_record(motion, case_folder).ltv
                                            : turned      ? read_files(motion.ltv, kLtv, "LTV", case_folder, unstated_of(motion))
                                                          : read_files(motion.xyz, {}, "xyz", case_folder, unstated_of(motion));
  treat(read, motion.treatment, "motion.");
  cases::GroundMotion result;
  for (std::size_t i = 0; i < 3; ++i) multiply(read[i], motion.scale[i], "motion.scale");
  if (motion.intensity) {
    result.factor = factors_to_reach(*motion.intensity, read[0], read[1]);
    for (std::size_t i = 0; i < 3; ++i) multiply(read[i], result.factor[i], "motion.intensity");
  }
  for (std::size_t i = 0; i < 3; ++i) result.axis[i] = std::move(read[component_along(motion, i)]);
  return result;
}

cases::GroundMotion ground_motion(const cases::Case& c) {
  return c.motion && !is_assessment(c.analysis) ? load_motion(*c.motion, c.folder) : cases::GroundMotion{};
}

}  // namespace voussoir::io
