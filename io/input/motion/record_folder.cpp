// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "io/input/document/case_tree.h"
#include "io/input/document/case_values.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/motion_files.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 3> kComponents{"L", "T", "V"};
constexpr std::size_t kLargestDescription = 1u << 20;  // bytes

Node parsed(const std::string& path) {
  const std::string text = read_text_file(path, kLargestDescription);
  try {
    return parse_document(text);
  } catch (const SyntaxError& e) {
    throw FileError(path, e.line(), e.what());
  }
}

/// The key dt: time between samples [s], for formats that do not state it.
double step_of(const std::string& path, long line, const Node& node) {
  const auto* number = node.as<double>();
  const auto* whole = node.as<std::int64_t>();
  const double dt = number != nullptr ? *number : whole != nullptr ? static_cast<double>(*whole) : 0.0;
  if (!(dt >= kShortestStep && dt <= kLongestStep)) throw FileError(path, line, "dt is no step; allowed: a number from 1e-6 to 10, in s");
  return dt;
}

/// The shortest decimal text that reads back as the same number.
std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end};
}

std::string csv_of(const cases::Accelerogram& a) {
  std::string text = "# " + a.name + "\nt [s], a [m/s2]\n";
  for (std::size_t i = 0; i < a.acceleration.size(); ++i) {
    char time[32];
    std::snprintf(time, sizeof time, "%.12g", static_cast<double>(i) * a.dt);
    text += time + (", " + shortest(a.acceleration[i])) + "\n";
  }
  return text;
}

}  // namespace

Record read_record_folder(const std::string& folder, const Unstated& unstated) {
  const std::string path = (fs::path(folder) / "record.toml").string();
  const Node document = parsed(path);
  Record record;
  const fs::path normal = fs::absolute(folder).lexically_normal();
  record.name = (normal.has_filename() ? normal : normal.parent_path()).filename().string();
  Unstated stated = unstated;
  std::array<std::optional<std::string>, 3> files;
  std::array<long, 3> lines{};
  for (const auto& [name, node] : *document.as<Node::Table>()) {
    const long line = node.source.line;
    if (name == "dt") {
      stated.dt = step_of(path, line, node);
      continue;
    }
    const auto* value = node.as<std::string>();
    const auto component = std::find(kComponents.begin(), kComponents.end(), name);
    if (component == kComponents.end() && name != "name" && name != "unit") {
      throw FileError(path, line, "key " + shown(name) + " is not known; allowed: L, T, V, name, unit, dt");
    }
    if (value == nullptr || value->empty()) throw FileError(path, line, name + " is no text; allowed: a string in quotes");
    if (name == "name") record.name = *value;
    if (name == "unit") stated.unit = *value;
    if (name == "unit" && !acceleration_unit(*value)) {
      throw FileError(path, line, "unit " + shown(*value) + " is not known; allowed: " + kUnitNames);
    }
    if (component == kComponents.end()) continue;
    const auto i = static_cast<std::size_t>(component - kComponents.begin());
    files[i] = *value, lines[i] = line;
  }
  if (!files[0] && !files[1] && !files[2]) throw FileError(path, "names no component; allowed: L, T, V, one of them at least");
  for (std::size_t i = 0; i < 3; ++i) {
    if (!files[i]) continue;
    try {
      record.ltv[i] = read_accelerogram((fs::path(folder) / *files[i]).string(), stated, kComponents[i][0]);
    } catch (const FileError& e) {
      throw FileError(path, lines[i], std::string(kComponents[i]) + " cannot be used: " + e.what());
    }
  }
  return record;
}

void write_record_folder(const Record& record, const std::string& folder, bool overwrite) {
  std::vector<std::pair<Output, std::string>> files;
  std::string description =
      "# Accelerations in m/s2 against time in s, by voussoir motion --write.\nname = " + toml_string(record.name) + "\n";
  for (std::size_t i = 0; i < 3; ++i) {
    if (record.ltv[i].acceleration.empty()) continue;
    const std::string file = std::string(kComponents[i]) + ".csv";
    description += std::string(kComponents[i]) + " = " + toml_string(file) + "\n";
    files.emplace_back(Output{(fs::path(folder) / file).string(), FileKind::table, "--write", overwrite}, csv_of(record.ltv[i]));
  }
  files.emplace_back(Output{(fs::path(folder) / "record.toml").string(), FileKind::record, "--write", overwrite}, description);
  std::error_code error;
  for (const auto& [output, text] : files) refuse_to_replace(output);
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, "cannot be made: " + error.message());
  for (const auto& [output, text] : files) write_output(output, text);
}

}  // namespace voussoir::io
