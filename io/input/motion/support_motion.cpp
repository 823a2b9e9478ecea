// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/support_motion.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "cases/model.h"
#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/motion_text.h"

namespace voussoir::io {

namespace {

constexpr std::size_t kLargestFile = 64u << 20;  // bytes

constexpr std::size_t kMoved = 4, kTurned = 7;  // columns: t, x, y, z; and rx, ry, rz

/// The numbers of a row, all finite; nothing: it has other fields, or more than kTurned.
std::optional<std::vector<double>> row_of(std::string_view line) {
  std::vector<double> row;
  for (;;) {
    const std::size_t comma = line.find(',');
    const auto number = finite_number(trimmed(line.substr(0, comma)));
    if (!number || row.size() == kTurned) return std::nullopt;
    row.push_back(*number);
    if (comma == std::string_view::npos) return row;
    line.remove_prefix(comma + 1);
  }
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
    const std::string_view name = trimmed(header.substr(0, comma)), stated = bracketed(name);
    const std::string_view wanted = column == 0 ? "s" : column < kMoved ? unit : "rad";
    if (!stated.empty() && stated != wanted)
      throw FileError(path, line, "unit of column " + shown(name) + " is " + shown(stated) + "; allowed: " + std::string(wanted));
    if (column == 0 && !name.empty() && std::string_view("xyzXYZ").find(name.front()) != std::string_view::npos)
      throw FileError(path, line, "column " + shown(name) + " comes first; wanted: t [s], x, y, z [" + std::string(unit) + "]");
    if (comma == std::string_view::npos) return;
    header.remove_prefix(comma + 1);
  }
}

/// Adds a row to a history. \throw FileError
void add_row(const std::string& path, long line, const std::vector<double>& row, cases::SupportHistory& history) {
  if (!history.time.empty() && row[0] <= history.time.back())
    throw FileError(path, line, "time " + std::to_string(row[0]) + " s does not rise");
  if (row.size() == kTurned) {
    const Vec3 rotation{row[4], row[5], row[6]};
    if (history.time.empty() && rotation != Vec3{})
      throw FileError(path, line, "the first row turns the support; allowed: rx, ry, rz of zero, since it begins where it stands");
    history.rotation.push_back(rotation);
  }
  history.time.push_back(row[0]);
  history.displacement.push_back({row[1], row[2], row[3]});
}

/// Reads the file of a history. \param unit  of x, y, z: "m", for the force of a load "N" \param turns  whether it may turn: that of a
/// support
void read_history(const std::string& path, std::string_view unit, bool turns, cases::SupportHistory& history) {
  const std::string wanted = "wanted: t [s], x, y, z [" + std::string(unit) + "]" + (turns ? ", and where it turns rx, ry, rz [rad]" : "");
  std::size_t columns = 0;  // of all rows; 0: not known yet
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
    if (!row || (row->size() != kMoved && (row->size() != kTurned || !turns)))
      throw FileError(path, lines.line(), shown(line) + " is no row of four finite numbers" + (turns ? ", or of seven; " : "; ") + wanted);
    if (columns != 0 && row->size() != columns)
      throw FileError(path, lines.line(), shown(line) + " has another number of columns than the rows before; " + wanted);
    columns = row->size();
    add_row(path, lines.line(), *row, history);
  }
  if (history.time.size() < 2) throw FileError(path, "holds fewer than two rows; " + wanted);
}

}  // namespace

namespace {

/// Ways without a file end with the last of the files, so that all supports move in proportion.
void end_together(cases::Model& model) {
  double last = 0.0;
  std::vector<cases::SupportHistory*> ways;
  for (const cases::Block& block : model.blocks) {
    if (block.support_motion < 0) continue;
    cases::SupportHistory& h = nth(model.support_motions, block.support_motion);
    if (!h.file.empty())
      last = std::max(last, h.time.back());
    else if (!h.open_ended)
      ways.push_back(&h);
  }
  for (cases::SupportHistory* h : ways) {
    if (last > 0.0) h->time.back() = last;
  }
}

}  // namespace

void load_support_motions(cases::Model& model, const std::string& folder) {
  const auto is_of = [](const std::vector<std::int32_t>& numbers, std::size_t i) {
    return std::ranges::find(numbers, static_cast<std::int32_t>(i)) != numbers.end();
  };
  for (std::size_t i = 0; i < model.support_motions.size(); ++i) {
    cases::SupportHistory& h = model.support_motions[i];
    if (h.file.empty()) continue;
    const bool of_load = is_of(model.load_history, i);
    const std::filesystem::path path(h.file);
    try {
      read_history(path.is_absolute() || folder.empty() ? h.file : (std::filesystem::path(folder) / path).string(), of_load ? "N" : "m",
                   !of_load && !is_of(model.load_path, i), h);
    } catch (const FileError& e) {
      throw NamedFileError(e, h.key);
    }
  }
  end_together(model);
}

}  // namespace voussoir::io
