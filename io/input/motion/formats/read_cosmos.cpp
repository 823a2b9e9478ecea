// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "cases/names.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// COSMOS strong-motion format (v1.20), one block a channel: lines of text, an integer header, a real header, comments, the data and a line
// that ends them. The number of lines and the Fortran format of the numbers are stated before each part; both vary between writers.
namespace voussoir::io {
namespace {

constexpr std::size_t kAzimuth = 54, kStep = 62, kPeak = 64;  // positions in the headers, from 1; the step is in ms
constexpr double kUnknown = -999.0;

using Reals = std::vector<double>;

struct CosmosHead {
  std::string event, station, channel;  // lines 2, 5 and 9 of the text
  Reals integers, reals;
  std::string scnl;  // "BMR.BNZ.AK.--" of a comment: station, channel, network, location
};

std::string behind(std::string_view line, std::string_view key) {
  const std::size_t found = line.find(key);
  return found == std::string_view::npos ? std::string() : std::string(trimmed(line.substr(found + key.size())));
}

/// Reads the text lines after "Corrected acceleration (Format v01.20 with 13 text lines)", which has been read.
void read_text_lines(MotionText& text, std::string_view first, CosmosHead& h) {
  const std::uint64_t count = stated_count(text.here(), "the number of text lines", number_after(first, " with "));
  for (std::uint64_t number = 2; number <= count; ++number) {
    const std::string_view line = text.need("the end of the " + std::to_string(count) + " text lines");
    if (number == 2) h.event = trimmed(line);
    if (number == 5) h.station = trimmed(behind(line, "Code:"));
    if (number == 9) h.channel = trimmed(line.substr(0, line.find('(')));
  }
}

/// Reads "100 Integer-header values follow on 10 lines, Format= (10I8)" and the values.
Reals read_header_values(MotionText& text, const char* kind) {
  const std::string_view line = text.need("the line '100 " + std::string(kind) + "-header values follow'");
  if (!holds(line, upper(kind))) text.fail(shown(line) + ": wanted '100 " + kind + "-header values follow on 10 lines, Format= (...)'");
  const auto columns = columns_in(line);
  if (!columns) text.fail(shown(line) + " prints no Format; wanted as in 'Format= (10I8)'");
  return read_columns(text, stated_count(text.here(), std::string(kind) + "-header values", number_after(line, "")), *columns);
}

/// Reads " 6 Comment line(s) follow, each starting with a "|":" and the comments.
void read_comments(MotionText& text, CosmosHead& h) {
  const std::string_view line = text.need("the line 'n Comment line(s) follow'");
  const auto count = number_after(line, "");
  if (!holds(line, "COMMENT LINE") || !count || *count < 0.0) text.fail(shown(line) + ": wanted 'n Comment line(s) follow'");
  for (double i = 0.0; i < *count; ++i) {
    const std::string_view comment = text.need("the end of the comments");
    if (!trimmed(comment).starts_with('|')) text.fail(shown(comment) + ": a comment must start with '|'");
    if (const std::string found = behind(comment, "<SCNL>"); !found.empty()) h.scnl = found.substr(0, found.find(' '));
  }
}

double entry(const Reals& header, std::size_t place) { return place <= header.size() ? header[place - 1] : kUnknown; }

/// The azimuth if the header has one, else the channel's code, else its text.
std::string component_of(const CosmosHead& h) {
  constexpr double kUp = 400.0, kDown = 401.0;
  const double azimuth = entry(h.integers, kAzimuth);
  if (azimuth >= 1.0 && azimuth <= 360.0) return cases::text(azimuth) + " deg";
  if (azimuth == kUp) return "UP";
  if (azimuth == kDown) return "DOWN";
  if (const std::size_t dot = h.scnl.find('.'); dot != std::string::npos)
    return h.scnl.substr(dot + 1, h.scnl.find('.', dot + 1) - dot - 1);
  const std::size_t colon = h.channel.rfind(':');
  return std::string(trimmed(std::string_view(h.channel).substr(colon == std::string::npos ? 0 : colon + 1)));
}

/// Reads "42000 acceleration pts, approx 210 secs, units=cm/sec2(04),Format=(1E15.6)" and the values; nothing for velocity or displacement.
std::optional<Channel> read_data(MotionText& text, const CosmosHead& h) {
  const std::string line(text.need("the line 'n acceleration pts, ...'"));
  if (!holds(line, " PTS")) text.fail(shown(line) + ": wanted 'n acceleration pts, approx s secs, units=cm/sec2, Format=(...)'");
  const Place at = text.here();
  const std::uint64_t count = stated_count(at, "the number of points", number_after(line, ""));
  const std::string tail = behind(line, "ormat");
  const auto columns = columns_in(tail);
  if (!columns) at.fail(shown(line) + " prints no Format; wanted as in 'Format=(8F10.5)'");
  if (!holds(line, "ACCEL")) {
    skip_columns(text, count, *columns, "the values");
    return std::nullopt;
  }
  const std::string units = behind(line, "units=");
  const double unit = stated_unit(at, std::string_view(units).substr(0, units.find_first_of("(,")));
  const double dt =
      stated_step(at, "the step (ms / 1000, value " + std::to_string(kStep) + " of the real header)", entry(h.reals, kStep) / 1000.0);
  Channel c;
  c.component = component_of(h);
  if (c.component == "UP") c.axis = 'V';
  if (const double peak = entry(h.reals, kPeak); peak != kUnknown) c.stated_peak = std::abs(peak) * unit;
  c.motion = {h.station + ", " + h.event + ", " + c.component, dt, read_columns(text, count, *columns, 1.0)};
  for (double& a : c.motion.acceleration) {
    if (a == kUnknown) {
      text.fail("value " + std::to_string(&a - c.motion.acceleration.data() + 1) + " of the data is " + cases::text(kUnknown) +
                ", which stands for one that is not known; allowed: data without gaps");
    }
    a *= unit;
  }
  return c;
}

}  // namespace

std::vector<Channel> read_cosmos(const std::string& path) {
  MotionText text(path);
  std::vector<Channel> channels;
  while (const auto line = text.next_filled()) {
    CosmosHead h;
    if (!holds(*line, "(FORMAT V")) text.fail(shown(*line) + ": wanted the head of a channel, '... (Format v01.20 with 13 text lines)'");
    read_text_lines(text, *line, h);
    h.integers = read_header_values(text, "Integer");
    h.reals = read_header_values(text, "Real");
    read_comments(text, h);
    if (auto c = read_data(text, h)) channels.push_back(std::move(*c));
    const std::string_view end = text.need("the line that ends the data, 'End-of-data ...' or '/&'");
    if (!begins(end, "END-OF-DATA") && !end.starts_with("/&"))
      text.fail(shown(end) + " after the values; wanted 'End-of-data ...' or '/&'");
  }
  if (channels.empty()) text.fail("the file holds no acceleration");
  return channels;
}

}  // namespace voussoir::io
