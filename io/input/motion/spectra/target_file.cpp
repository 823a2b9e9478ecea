// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/target_file.h"

#include <filesystem>
#include <vector>

#include "cases/input_error.h"
#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/read_motion.h"

namespace voussoir::io {
namespace {

using Parts = std::vector<std::string>;

// As of motion.intensity.level.
constexpr double kLeastAcceleration = 1e-5, kMostAcceleration = 2e5;  // m/s2
constexpr double kLongestPeriod = 1000.0;                             // s

bool is_possible(double acceleration) { return acceleration >= kLeastAcceleration && acceleration <= kMostAcceleration; }

Parts parts_of(std::string_view text, std::string_view dividers) {
  Parts parts;
  while (true) {
    const std::size_t end = text.find_first_of(dividers);
    const std::string_view part = trimmed(text.substr(0, end));
    if (!part.empty() || dividers != " \t") parts.emplace_back(part);
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

constexpr const char* kWords =
    "ec8:TYPE:GROUND:AG as in ec8:1:B:0.3g, TYPE 1 or 2, GROUND A to E, AG in g or, without a unit, in m/s2, "
    "from 1e-5 to 2e5 m/s2";

/// The spectrum, or what is wrong with its words.
std::string parse(const std::string& name, Eurocode8& e) {
  const Parts parts = parts_of(name, ":");
  if (parts.size() != 4 || parts[0] != "ec8") return "wanted four parts";
  if (parts[1] != "1" && parts[1] != "2") return "no type " + shown(parts[1]);
  e.type = parts[1] == "1" ? 1 : 2;
  const std::string ground = upper(parts[2]);
  if (ground.size() != 1 || ground[0] < 'A' || ground[0] > 'E') return "no ground " + shown(parts[2]);
  e.ground = ground[0];
  const bool in_g = parts[3].ends_with('g');
  const auto ag = finite_number(std::string_view(parts[3]).substr(0, parts[3].size() - (in_g ? 1 : 0)));
  e.ag = ag.value_or(0.0) * (in_g ? cases::kStandardGravity : 1.0);
  return is_possible(e.ag) ? "" : "no acceleration " + shown(parts[3]);
}

/// The text in brackets: "g" of "Sa [g]"; empty without brackets.
std::string bracketed(const std::string& field) {
  const std::size_t open = field.find_first_of("[("), close = field.find_first_of("])");
  return open == std::string::npos || close == std::string::npos || close < open ? "" : field.substr(open + 1, close - open - 1);
}

Parts columns_of(const std::string& path, long line, std::string_view content) {
  const std::size_t mark = content.find_first_of(",;");
  Parts parts = parts_of(content, mark == std::string_view::npos ? std::string_view(" \t") : content.substr(mark, 1));
  if (parts.size() != 2)
    throw FileError(path, line, "has " + std::to_string(parts.size()) + " columns; wanted two: period [s], spectral acceleration");
  return parts;
}

class TargetReader {
 public:
  explicit TargetReader(const std::string& path) : path_(path) {}

  void line(long number, const Parts& parts) {
    const auto period = finite_number(parts[0]), value = finite_number(parts[1]);
    if (target_.period.empty() && !header_ && !period) return header(number, parts);
    if (!period || !(*period >= 0.0 && *period <= kLongestPeriod))
      fail(number, "period " + shown(parts[0]) + " is no number; allowed: 0 to 1000 s");
    if (!value || !(*value > 0.0)) fail(number, "acceleration " + shown(parts[1]) + " is no number above 0");
    if (!target_.period.empty() && !(*period > target_.period.back())) fail(number, "period " + shown(parts[0]) + " does not rise");
    target_.period.push_back(*period);
    target_.acceleration.push_back(*value);
    lines_.push_back(number);
  }

  TargetSpectrum finished(const std::optional<std::string>& unit) {
    if (target_.period.size() < 2)
      throw FileError(path_, "holds " + std::to_string(target_.period.size()) + " rows of numbers; allowed: 2 or more");
    if (!factor_ && unit) factor_ = acceleration_unit(*unit);
    if (!factor_) throw FileError(path_, "the unit of acceleration is not stated; give the file a header line 'T [s], Sa [g]', or --unit");
    for (std::size_t i = 0; i < target_.acceleration.size(); ++i) {
      double& a = target_.acceleration[i];
      a *= *factor_;
      if (!is_possible(a)) fail(lines_[i], "an acceleration of " + cases::text(a) + " m/s2; allowed: 1e-5 to 2e5 m/s2");
    }
    target_.name = std::filesystem::path(path_).filename().string();
    return std::move(target_);
  }

 private:
  void header(long number, const Parts& parts) {
    header_ = true;
    const std::string of_period = bracketed(parts[0]), of_value = bracketed(parts[1]);
    if (!of_period.empty() && of_period != "s") fail(number, "unit of the period is " + shown(of_period) + "; allowed: s");
    if (of_value.empty()) return;
    factor_ = acceleration_unit(of_value);
    if (!factor_) fail(number, "unit of acceleration is " + shown(of_value) + "; allowed: g, m/s2, cm/s2");
  }
  [[noreturn]] void fail(long number, const std::string& what) const { throw FileError(path_, number, what); }

  std::string path_;
  TargetSpectrum target_;
  std::vector<long> lines_;  // of the values
  std::optional<double> factor_;
  bool header_ = false;
};

}  // namespace

bool is_eurocode8(const std::string& words) { return words.starts_with("ec8:"); }

std::string eurocode8_fault(const std::string& words) {
  Eurocode8 e;
  const std::string problem = parse(words, e);
  return problem.empty() ? "" : shown(words) + ": " + problem + "; allowed: " + kWords;
}

Eurocode8 eurocode8_of(const std::string& words) {
  Eurocode8 e;
  parse(words, e);
  return e;
}

TargetSpectrum read_target(const std::string& name, const std::optional<std::string>& unit, const std::string& option) {
  std::error_code error;
  Eurocode8 e;
  const bool is_code = is_eurocode8(name);
  const std::string problem = is_code ? parse(name, e) : !std::filesystem::exists(name, error) ? "no such file" : "";
  if (!problem.empty())
    throw cases::InputError(option, shown(name) + ": " + problem + "; allowed: " + kWords + "; or a file of period [s] and acceleration");
  if (is_code) return {name, e, {}, {}};
  const std::string text = read_foreign_text(name, kLargestMotionFile);
  LineReader lines(text);
  TargetReader reader(name);
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (!content.empty() && content.front() != '#') reader.line(lines.line(), columns_of(name, lines.line(), content));
  }
  return reader.finished(unit);
}

}  // namespace voussoir::io
