// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "io/input/files/output_path.h"
#include "io/input/files/sealed_pages.h"
#include "io/input/files/text_file.h"

namespace voussoir::io {
namespace {

using namespace std::string_view_literals;

/// The text behind a byte order mark, blanks and an XML declaration.
std::string_view body_of(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF", kEnd = "?>";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  text = trimmed(text);
  if (!text.starts_with("<?xml")) return text;
  const std::size_t end = text.find(kEnd);
  return end == std::string_view::npos ? std::string_view() : trimmed(text.substr(end + kEnd.size()));
}

bool begins_with_element(std::string_view text, std::string_view name) { return body_of(text).starts_with(name); }

/// Columns of a row, divided by commas that stand in no quotes.
std::size_t columns_of(std::string_view row) {
  std::size_t columns = 1;
  bool quoted = false;
  for (const char c : row) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++columns;
  }
  return columns;
}

/// Whether the first line that is no comment holds columns: two or more, divided by commas, and no key before them ("key = value, ..."),
/// and the next line as many. A script (#!) is no table, nor is one line that ends a sentence.
bool is_table(std::string_view text) {
  if (text.find('\0') != std::string_view::npos || text.starts_with("#!")) return false;
  LineReader lines(text);
  std::size_t columns = 0;
  while (const auto line = lines.next()) {
    const std::string_view row = trimmed(*line);
    if (row.empty() || row.front() == '#') continue;
    const bool whole = row.data() + row.size() < text.data() + text.size();  // else it may go on behind the head
    if (columns > 0) return columns_of(row) == columns || !whole;
    const std::size_t comma = row.find(','), equals = row.find('=');
    if ("<{["sv.find(row.front()) != std::string_view::npos || comma == std::string_view::npos || comma > equals) return false;
    columns = columns_of(row);
  }
  return columns > 0 && !trimmed(text).ends_with('.');
}

}  // namespace

std::string name_of(FileKind kind) {
  switch (kind) {
    case FileKind::page:
      return "page (HTML)";
    case FileKind::drawing:
      return "drawing (SVG)";
    case FileKind::table:
      return "table (CSV)";
    case FileKind::picture:
      return "picture (PNG)";
    case FileKind::film:
      return "film (MP4, WebM, GIF)";
    case FileKind::shapes:
      return "file of shapes (VTU)";
    case FileKind::record:
      return "record.toml that `voussoir motion --write` wrote";
    case FileKind::xdmf:
      return "XDMF file";
    case FileKind::hdf5:
      return "HDF5 file";
    case FileKind::manual:
      return "manual page";
  }
  return "";
}

bool is_of_kind(FileKind kind, std::string_view head) {
  if (head.empty()) return true;
  switch (kind) {
    case FileKind::page:
      return upper(body_of(head).substr(0, 14)) == "<!DOCTYPE HTML";
    case FileKind::drawing:
      return begins_with_element(head, "<svg");
    case FileKind::table:
      return is_table(head);
    case FileKind::picture:
      return head.starts_with("\x89PNG");
    case FileKind::film:
      return head.substr(std::min<std::size_t>(4, head.size())).starts_with("ftyp") || head.starts_with("\x1A\x45\xDF\xA3") ||
             head.starts_with("GIF8");
    case FileKind::shapes:
      return begins_with_element(head, "<VTKFile");
    case FileKind::record:
      return head.starts_with("# Accelerations in m/s2 against time in s, by voussoir motion --write.");
    case FileKind::xdmf:
      return begins_with_element(head, "<Xdmf");
    case FileKind::hdf5:
      return head.starts_with("\x89HDF\r\n") || head.starts_with(kSealedHdf5);
    case FileKind::manual:
      return head.starts_with(".TH ") || head.starts_with(".\\\"");
  }
  return false;
}

}  // namespace voussoir::io
