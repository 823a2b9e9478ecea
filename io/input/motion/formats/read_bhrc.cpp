// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// BHRC (Iran) V1: blocks for L, V and T, each a head of text to the line "UNITS ARE SECONDS AND G/10", a blank line, seven lines of
// integers and seven of reals, the values in ten columns of 13, and "/&". The lines of numbers in the head are truncated at column 70 in
// known files, so they are not used; the step follows from the duration, which is NO. OF POINTS steps long.
namespace voussoir::io {
namespace {

constexpr Columns kBhrcColumns{10, 13};
constexpr int kLinesToData = 1 + 7 + 7;  // lines after the line of units
constexpr int kLongestBhrcHead = 30;     // most lines up to the units

struct BhrcHead {
  std::string station, date;
  std::string component;  // "L", "T", "V"
  std::uint64_t count = 0;
  double dt = 0.0, unit = 0.0;  // s, m/s2
};

/// The unit from "UNITS ARE SECONDS AND G/10": g/10 in m/s2.
double unit_of(const MotionText& text, std::string_view line) {
  constexpr std::string_view kAnd = " AND ";
  const std::size_t found = upper(line).find(kAnd);
  if (found == std::string::npos) text.fail(shown(line) + ": wanted 'UNITS ARE SECONDS AND G/10'");
  std::string_view name = trimmed(line.substr(found + kAnd.size()));
  const std::size_t slash = name.rfind('/');
  const auto divisor = slash == std::string_view::npos ? std::nullopt : finite_number(trimmed(name.substr(slash + 1)));
  if (divisor) name = name.substr(0, slash);
  if (divisor && *divisor < 1.0) text.fail("unit " + shown(line) + " is divided by less than 1");
  return stated_unit(text.here(), name) / divisor.value_or(1.0);
}

BhrcHead read_head(MotionText& text) {
  BhrcHead h;
  for (int i = 0; i < kLongestBhrcHead; ++i) {
    const std::string_view line = text.need("the line 'UNITS ARE SECONDS AND G/10'");
    if (begins(line, "ORIGIN TIME")) h.date = trimmed(line.substr(line.find(':') + 1));
    if (begins(line, "COMP ")) h.component = upper(trimmed(line.substr(5)).substr(0, 1));
    if (holds(line, " STATION ")) h.station = trimmed(line.substr(0, upper(line).find(" STATION ")));
    if (begins(line, "NO. OF POINTS")) {
      h.count = stated_count(text.here(), "NO. OF POINTS", number_after(line, "NO. OF POINTS"));
      const auto duration = number_after(line, "DURATION");
      h.dt = stated_step(text.here(), "DURATION / NO. OF POINTS",
                         duration ? std::optional(*duration / static_cast<double>(h.count)) : std::nullopt);
    }
    if (begins(line, "UNITS ARE")) {
      h.unit = unit_of(text, line);
      if (h.count == 0) text.fail("no line 'NO. OF POINTS = n  DURATION = s' before this one");
      if (h.component.empty()) text.fail("no line 'COMP L', 'COMP T' or 'COMP V' before this one");
      return h;
    }
  }
  text.fail("no line 'UNITS ARE SECONDS AND G/10' in the first " + std::to_string(kLongestBhrcHead) + " lines of the component");
}

Channel read_component(MotionText& text) {
  const BhrcHead h = read_head(text);
  text.skip(kLinesToData, "the values");
  Channel c;
  c.component = h.component;
  if (std::string_view("LTV").find(h.component) != std::string_view::npos) c.axis = h.component[0];
  c.motion = {h.station + ", " + h.date + ", " + h.component, h.dt, read_columns(text, h.count, kBhrcColumns, h.unit)};
  const std::string_view end = text.need("'/&', the end of the component");
  if (!end.starts_with("/&")) text.fail(shown(end) + " after the " + std::to_string(h.count) + " values of the header; wanted '/&'");
  return c;
}

}  // namespace

std::vector<Channel> read_bhrc(const std::string& path) {
  MotionText text(path);
  std::vector<Channel> channels;
  while (const auto line = text.next_filled()) {
    if (!begins(*line, "* VOL1")) text.fail(shown(*line) + ": wanted '* VOL1DS FILE', the head of a component");
    channels.push_back(read_component(text));
  }
  if (channels.empty()) text.fail("the file holds no acceleration");
  return channels;
}

}  // namespace voussoir::io
