// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/text_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"

namespace voussoir::io {
namespace fs = std::filesystem;

std::string read_text_file(const std::string& path, std::size_t largest) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw FileError(path, "no such file");
  if (fs::is_directory(status)) throw FileError(path, "is a folder, wanted a file");
  if (!fs::is_regular_file(status)) throw FileError(path, "is not a regular file");  // a pipe would block, a device never ends
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw FileError(path, error.message());
  if (size > largest) {
    throw FileError(path, "has " + std::to_string(size) + " bytes; allowed: at most " + std::to_string(largest));
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in || !in.read(text.data(), static_cast<std::streamsize>(text.size()))) throw FileError(path, "cannot be read");
  note_input(path);
  return text;
}

LineReader::LineReader(std::string_view text) : rest_(text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (rest_.substr(0, kMark.size()) == kMark) rest_.remove_prefix(kMark.size());
}

std::optional<std::string_view> LineReader::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line_ended_ = end < rest_.size();
  const std::string_view line = rest_.substr(0, end);
  const std::size_t feed = rest_.find_first_not_of('\r', end);
  const bool with_feed = feed != std::string_view::npos && rest_[feed] == '\n';
  rest_.remove_prefix(with_feed ? feed + 1 : std::min(end + 1, rest_.size()));
  ++line_;
  return line;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return out;
}

std::optional<double> finite_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string out = "'";
  for (const char c : text.substr(0, kLongest)) out += c >= ' ' && c <= '~' ? c : '?';
  return out + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace voussoir::io
