// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// ESM's (and AFAD's) DYNA ASCII: lines "KEY: value", the last of them USER5, then one value a line. Values of keys may be empty.
namespace voussoir::io {
namespace {

constexpr const char* kLastKey = "USER5";
constexpr Columns kOneByOne{1, 1000};

HeaderFields read_esm_header(MotionText& text) {
  HeaderFields header;
  for (;;) {
    const std::string_view line = text.need("the header's last key, USER5");
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) text.fail(shown(line) + ": wanted 'KEY: value'");
    header.add(line.substr(0, colon), line.substr(colon + 1), text.here());
    if (trimmed(line.substr(0, colon)) == kLastKey) return header;
  }
}

}  // namespace

std::vector<Channel> read_esm(const std::string& path) {
  MotionText text(path);
  const HeaderFields header = read_esm_header(text);
  const auto need = [&](const char* key) { return header.need(text.here(), key); };
  const auto type = need("DATA_TYPE");
  if (upper(type.value) != "ACCELERATION") type.at.fail("the file holds " + shown(type.value) + ", wanted ACCELERATION");
  const auto units = need("UNITS"), interval = need("SAMPLING_INTERVAL_S"), ndata = need("NDATA");
  const double unit = stated_unit(units.at, units.value);
  const double dt = stated_step(interval.at, "SAMPLING_INTERVAL_S", interval.number());
  const std::uint64_t count = stated_count(ndata.at, "NDATA", ndata.number());

  Channel c;
  c.component = header.value("STREAM");
  if (const auto peak = finite_number(header.value("PGA_CM/S^2"))) c.stated_peak = std::abs(*peak) * 0.01;
  const std::string station = header.value("NETWORK") + "." + header.value("STATION_CODE");
  c.motion = {station + ", " + header.value("EVENT_DATE_YYYYMMDD") + " " + header.value("EVENT_TIME_HHMMSS") + ", " + c.component, dt,
              read_columns(text, count, kOneByOne, unit)};
  text.expect_end("the " + std::to_string(count) + " values of the header");
  return {c};
}

}  // namespace voussoir::io
