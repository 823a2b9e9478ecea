// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// GeoNet (New Zealand) V2A, one block a component: 16 lines of text, 10 of numbers, then acceleration (mm/s2), velocity and displacement, n
// values each in ten columns of 8, without blanks between large values. Peak times in the heads of real files differ from index times step,
// and are not used.
namespace voussoir::io {
namespace {

constexpr Columns kGeonetColumns{10, 8};
constexpr int kTextLines = 16, kNumberLines = 10;

struct GeonetHead {
  std::string site, date;
  std::string component;  // "N28W"
  char axis = 0;
  std::uint64_t count = 0;
  double dt = 0.0, unit = 0.0;  // s, m/s2
  std::optional<double> peak;   // m/s2
};

/// Reads "Component N28W Longitudinal Accelerometer Axis".
void read_component_line(std::string_view line, GeonetHead& h) {
  const std::string_view rest = trimmed(line.substr(line.find(' ') + 1));
  h.component = rest.substr(0, rest.find(' '));
  if (holds(line, "LONGITUDINAL")) h.axis = 'L';
  if (holds(line, "TRANSVERSE")) h.axis = 'T';
  if (holds(line, "VERTICAL") && upper(h.component) == "UP") h.axis = 'V';
}

/// Reads "Acceleration: peak -9733.1 mm/s/s at 44.88 sec rms ...".
void read_acceleration_line(const MotionText& text, std::string_view line, GeonetHead& h) {
  const std::size_t at = line.find(" at ");
  const std::string_view words = trimmed(line.substr(0, at));
  const std::size_t blank = words.rfind(' ');
  h.unit = stated_unit(text.here(), blank == std::string_view::npos ? std::string_view() : words.substr(blank + 1));
  if (const auto peak = number_after(line, "peak")) h.peak = std::abs(*peak) * h.unit;
}

void read_head_line(const MotionText& text, std::string_view line, int number, GeonetHead& h) {
  if (begins(line, "SITE ")) h.site = trimmed(line.substr(5, line.find("  ", 5) - 5));
  if (number == 8) h.date = trimmed(line);
  if (begins(line, "NUMBER OF POINTS")) h.count = stated_count(text.here(), "Number of points", number_after(line, "Number of points"));
  if (holds(line, "SEC INTERVALS")) h.dt = stated_step(text.here(), "the interval", number_after(line, " at "));
  if (begins(line, "COMPONENT ")) read_component_line(line, h);
  if (begins(line, "ACCELERATION:")) read_acceleration_line(text, line, h);
}

GeonetHead read_head(MotionText& text, std::string_view first) {
  GeonetHead h;
  for (int number = 1; number <= kTextLines; ++number) {
    read_head_line(text, number == 1 ? first : text.need("the end of the head"), number, h);
  }
  if (h.count == 0) text.fail("no line 'Number of points n' in the component's 16 lines of text");
  if (h.dt == 0.0) text.fail("no line '... data at s sec intervals' in the component's 16 lines of text");
  if (h.component.empty()) text.fail("no line 'Component ...' in the component's 16 lines of text");
  if (h.unit == 0.0) text.fail("no line 'Acceleration: peak a mm/s/s at ...' in the component's 16 lines of text");
  text.skip(kNumberLines, "the values");
  return h;
}

}  // namespace

std::vector<Channel> read_geonet(const std::string& path) {
  MotionText text(path);
  std::vector<Channel> channels;
  while (const auto line = text.next_filled()) {
    if (!begins(*line, "CORRECTED ACCELEROGRAM")) text.fail(shown(*line) + ": wanted 'Corrected accelerogram', the head of a component");
    const GeonetHead h = read_head(text, *line);
    Channel c{h.component, h.axis, h.peak, {h.site + ", " + h.date + ", " + h.component, h.dt, {}}};
    c.motion.acceleration = read_columns(text, h.count, kGeonetColumns, h.unit);
    skip_columns(text, h.count, kGeonetColumns, "the values of velocity");
    skip_columns(text, h.count, kGeonetColumns, "the values of displacement");
    channels.push_back(std::move(c));
  }
  if (channels.empty()) text.fail("the file holds no acceleration");
  return channels;
}

}  // namespace voussoir::io
