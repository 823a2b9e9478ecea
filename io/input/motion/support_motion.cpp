// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/support_motion.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "cases/model.h"
#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/motion_text.h"

namespace voussoir::io {

namespace {

constexpr std::size_t kLargestFile = 64u << 20;  // bytes

/// The four numbers of a row, or nothing.
std::optional<std::array<double, 4>> row_of(std::string_view line) {
  std::array<double, 4> row{};
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::size_t comma = line.find(',');
    const auto number = finite_number(trimmed(line.substr(0, comma)));
    if (!number || (comma == std::string_view::npos) != (i == 3)) return std::nullopt;
    row[i] = *number;
    if (i < 3) line.remove_prefix(comma + 1);
  }
  return row;
}

/// Whether the line is a header, with no number in any field; a damaged row is no header.
bool is_header(std::string_view line) {
  for (;;) {
    const std::size_t comma = line.find(',');
    if (finite_number(trimmed(line.substr(0, comma)))) return false;
    if (comma == std::string_view::npos) return true;
    line.remove_prefix(comma + 1);
  }
}

/// Checks the units that the columns of a header state, if any; time is the first. \param unit  of x, y, z
void check_units(const std::string& path, long line, std::string_view header, std::string_view unit) {
  for (std::size_t column = 0;; ++column) {
    const std::size_t comma = header.find(',');
    const std::string_view name = trimmed(header.substr(0, comma)), stated = bracketed(name), wanted = column == 0 ? "s" : unit;
    if (!stated.empty() && stated != wanted)
      throw FileError(path, line, "unit of column " + shown(name) + " is " + shown(stated) + "; allowed: " + std::string(wanted));
    if (column == 0 && !name.empty() && std::string_view("xyzXYZ").find(name.front()) != std::string_view::npos)
      throw FileError(path, line, "column " + shown(name) + " comes first; wanted: t [s], x, y, z [" + std::string(unit) + "]");
    if (comma == std::string_view::npos) return;
    header.remove_prefix(comma + 1);
  }
}

/// Reads the file of a history. \param unit  of x, y, z: "m", for a load "N"
void read_history(const std::string& path, std::string_view unit, cases::SupportHistory& history) {
  const std::string wanted = "wanted: t [s], x, y, z [" + std::string(unit) + "]";
  const std::string text = read_foreign_text(path, kLargestFile);
  LineReader lines(text);
  bool header_allowed = true;
  while (const auto next = lines.next()) {
    const std::string_view line = trimmed(*next);
    if (line.empty() || line.front() == '#') continue;
    const auto row = row_of(line);
    if (!row && header_allowed && is_header(line)) {
      check_units(path, lines.line(), line, unit);
      header_allowed = false;
      continue;
    }
    header_allowed = false;
    if (!row) throw FileError(path, lines.line(), shown(line) + " is no row of four finite numbers; " + wanted);
    if (!history.time.empty() && (*row)[0] <= history.time.back()) {
      throw FileError(path, lines.line(), "time " + std::to_string((*row)[0]) + " s does not rise");
    }
    history.time.push_back((*row)[0]);
    history.displacement.push_back({(*row)[1], (*row)[2], (*row)[3]});
  }
  if (history.time.size() < 2) throw FileError(path, "holds fewer than two rows; " + wanted);
}

}  // namespace

void load_support_motions(cases::Model& model, const std::string& folder) {
  for (std::size_t i = 0; i < model.support_motions.size(); ++i) {
    cases::SupportHistory& h = model.support_motions[i];
    if (h.file.empty()) continue;
    const bool of_load = std::ranges::find(model.load_history, static_cast<std::int32_t>(i)) != model.load_history.end();
    const std::filesystem::path path(h.file);
    try {
      read_history(path.is_absolute() || folder.empty() ? h.file : (std::filesystem::path(folder) / path).string(), of_load ? "N" : "m", h);
    } catch (const FileError& e) {
      throw NamedFileError(e, h.key);
    }
  }
}

}  // namespace voussoir::io
