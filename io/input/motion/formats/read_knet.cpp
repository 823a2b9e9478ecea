// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "cases/names.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// NIED K-NET and KiK-net ASCII: seventeen lines, a key in the first 18 columns and its value behind, then integers in eight columns of 9. A
// count is a digitiser's number with an arbitrary offset; acceleration is (count - mean of all counts) * scale factor, by the network's
// description and its stated peaks. No other reader changes the baseline.
namespace voussoir::io {
namespace {

constexpr int kHeaderLines = 17;
constexpr std::size_t kKeyWidth = 18;
constexpr Columns kKnetColumns{8, 9};

HeaderFields read_knet_header(MotionText& text) {
  HeaderFields header;
  for (int i = 0; i < kHeaderLines; ++i) {
    const std::string_view line = text.need("the end of the header, which has 17 lines");
    header.add(line.substr(0, kKeyWidth), line.substr(std::min(kKeyWidth, line.size())), text.here());
  }
  return header;
}

/// The scale in m/s2 from "3920(gal)/6182761".
double scale_of(const HeaderFields::Field& field) {
  const std::string_view all = field.value;
  const std::size_t open = std::min(all.find('('), all.size()), close = std::min(all.find(")/"), all.size());
  const auto above = finite_number(trimmed(all.substr(0, open)));
  const auto below = close == all.size() ? std::nullopt : finite_number(trimmed(all.substr(close + 2)));
  if (!above || !below || close < open || !(*above > 0.0) || !(*below > 0.0)) {
    field.at.fail("Scale Factor " + shown(all) + "; wanted as in '3920(gal)/6182761'");
  }
  return stated_unit(field.at, all.substr(open + 1, close - open - 1)) * *above / *below;
}

std::optional<double> rate_of(const HeaderFields::Field& field) {
  std::string_view text = field.value;
  if (upper(text).ends_with("HZ")) text.remove_suffix(2);
  return finite_number(trimmed(text));
}

std::vector<double> centred(const Place& end, std::vector<double> counts, double scale) {
  constexpr double kLargestCount = 2147483648.0;  // range of 32 bits
  for (const double c : counts) {
    if (c != std::floor(c) || std::abs(c) > kLargestCount)
      end.fail("the values hold " + cases::text(c) + "; allowed: whole numbers of 32 bits");
  }
  const double mean = std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
  for (double& c : counts) c = (c - mean) * scale;
  if (std::any_of(counts.begin(), counts.end(), [](double a) { return !std::isfinite(a); })) end.fail("the scale factor is out of range");
  return counts;
}

}  // namespace

std::vector<Channel> read_knet(const std::string& path) {
  MotionText text(path);
  const HeaderFields header = read_knet_header(text);
  const auto need = [&](const char* key) { return header.need(text.here(), key); };
  const auto sampling = need("Sampling Freq(Hz)"), duration = need("Duration Time(s)"), factor = need("Scale Factor");
  const auto rate = rate_of(sampling), length = duration.number();
  const double dt = stated_step(sampling.at, "1 / Sampling Freq(Hz)", rate ? std::optional(1.0 / *rate) : std::nullopt);
  const std::uint64_t count =
      stated_count(duration.at, "Duration Time(s) * Sampling Freq(Hz)", length ? std::optional(std::round(*length * *rate)) : std::nullopt);
  const double scale = scale_of(factor);

  Channel c;
  c.component = header.value("Dir.");
  if (const auto peak = finite_number(header.value("Max. Acc. (gal)"))) c.stated_peak = std::abs(*peak) * 0.01;
  const std::vector<double> counts = read_columns(text, count, kKnetColumns);
  text.expect_end("the " + std::to_string(count) + " values of the header");
  c.motion = {header.value("Station Code") + ", " + header.value("Origin Time") + ", " + c.component, dt,
              centred(text.here(), counts, scale)};
  return {c};
}

}  // namespace voussoir::io
