// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// CDMG/CSMIP V2 (corrected) and USC V2, one block a channel: a head of text and numbers, then acceleration, velocity and displacement, each
// behind a line "3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC. (UNITS: CM/SEC/SEC)", and "/&". The head is read by keywords,
// independent of line numbers.
namespace voussoir::io {
namespace {

constexpr Columns kCsmipColumns{8, 10};        // for files that state none
constexpr std::size_t kLongestCsmipHead = 80;  // lines

struct CsmipHead {
  std::vector<std::string> lines;
  std::string component;       // from "CHAN n:", else from "COMP"
  bool has_comp = false;       // a file of USC, which has no CHAN and may lack "/&"
  std::optional<double> peak;  // m/s2
};

bool is_data_line(std::string_view line) { return holds(line, "POINTS OF") && holds(line, "DATA EQUALLY SPACED AT"); }

/// Reads "CHAN 1: 90 DEG" or, in files of USC, "COMP N00E", up to the first two blanks after it.
void read_head_line(std::string_view line, CsmipHead& h) {
  const std::size_t colon = line.find(':');
  if (h.component.empty() && begins(line, "COMP ")) {
    const std::string_view rest = trimmed(line.substr(4));
    h.component = rest.substr(0, rest.find("  "));
    h.has_comp = true;
  }
  if ((h.component.empty() || h.has_comp) && begins(line, "CHAN ") && colon != std::string_view::npos) {
    h.has_comp = false;
    const std::string_view rest = trimmed(line.substr(colon + 1));
    h.component = rest.substr(0, rest.find("  "));
  }
  if (begins(line, "PEAK ACCELERATION")) {
    const auto peak = number_after(line, "PEAK ACCELERATION");
    const std::size_t unit = upper(line).find("CM");
    if (peak && unit != std::string::npos) h.peak = std::abs(*peak) * 0.01;
  }
  h.lines.emplace_back(trimmed(line));
}

/// Reads the head of a channel up to its first line of data, which is returned.
std::string read_head(MotionText& text, std::string_view first, CsmipHead& h) {
  std::string line(first);
  while (!is_data_line(line)) {
    if (h.lines.size() == kLongestCsmipHead) {
      text.fail("no line 'n POINTS OF ACCEL DATA EQUALLY SPACED AT s SEC. (UNITS: ...)' in the first " + std::to_string(kLongestCsmipHead) +
                " lines of the channel");
    }
    read_head_line(line, h);
    line = text.need("the line 'n POINTS OF ACCEL DATA EQUALLY SPACED AT s SEC. (UNITS: ...)'");
  }
  return line;
}

/// The unit from "... (UNITS: CM/SEC/SEC)", "... IN UNITS CM/SEC/SEC", "... IN UNITS OF CM/SEC/SEC" or "... .005 sec, in cm/sec2.
/// (8f10.6)".
std::string_view unit_name(const std::string& line) {
  for (const char* key : {"UNITS:", "UNITS OF ", "UNITS ", " IN "}) {
    const std::size_t found = upper(line).find(key);
    if (found == std::string::npos) continue;
    std::string_view rest = trimmed(std::string_view(line).substr(found + std::string_view(key).size()));
    rest = rest.substr(0, rest.find_first_of(" ),"));
    if (rest.ends_with('.')) rest.remove_suffix(1);
    return rest;
  }
  return {};
}

std::vector<double> read_series(MotionText& text, const std::string& line, Channel& c) {
  const Place at = text.here();
  const std::uint64_t count = stated_count(at, "the number of points", number_after(line, ""));
  const Columns columns = columns_in(line).value_or(kCsmipColumns);
  if (!holds(line, "POINTS OF ACC")) {
    skip_columns(text, count, columns, "the values of velocity or displacement");
    return {};
  }
  c.motion.dt = stated_step(at, "EQUALLY SPACED AT", number_after(line, "EQUALLY SPACED AT"));
  return read_columns(text, count, columns, stated_unit(at, unit_name(line)));
}

/// Reads one channel. \param next  set to the first line of the next channel, if no "/&" separates the two
Channel read_channel(MotionText& text, std::string_view first, std::optional<std::string>& next) {
  CsmipHead h;
  Channel c;
  std::string line = read_head(text, first, h);
  while (!trimmed(line).starts_with("/&")) {
    if (!is_data_line(line)) text.fail(shown(line) + " after the values; wanted 'n POINTS OF ... DATA EQUALLY SPACED AT s SEC.', or '/&'");
    const bool had = !c.motion.acceleration.empty();
    auto series = read_series(text, line, c);
    if (had && !series.empty()) text.fail("a second acceleration of one channel; wanted '/&' before the next channel");
    if (!had) c.motion.acceleration = std::move(series);
    const bool may_end = h.has_comp && !c.motion.acceleration.empty();
    const std::optional<std::string_view> after = may_end ? text.next_filled() : text.need("'/&', the end of the channel");
    if (!after) break;
    line = *after;
    if (may_end && begins(line, "CORRECTED ACCELEROGRAM")) {
      next = line;
      break;
    }
  }
  if (h.component.empty()) text.fail("the head of the channel has no line 'CHAN n: direction' or 'COMP direction'");
  c.component = h.component;
  if (upper(c.component) == "UP") c.axis = 'V';
  c.stated_peak = h.peak;
  const auto head_line = [&h](std::size_t number) { return number <= h.lines.size() ? h.lines[number - 1] : std::string(); };
  c.motion.name = head_line(7) + ", " + head_line(3) + ", " + c.component;
  return c;
}

}  // namespace

std::vector<Channel> read_csmip(const std::string& path) {
  MotionText text(path);
  std::vector<Channel> channels;
  std::optional<std::string> next;
  while (true) {
    const std::optional<std::string> line = next ? next : std::optional<std::string>(text.next_filled());
    if (!line) break;
    next.reset();
    Channel c = read_channel(text, *line, next);
    if (!c.motion.acceleration.empty()) channels.push_back(std::move(c));
  }
  if (channels.empty()) text.fail("the file holds no acceleration");
  return channels;
}

}  // namespace voussoir::io
