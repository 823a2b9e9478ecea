// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "geometry/message.h"
#include "io/input/messages/messages.h"

namespace voussoir::io {
namespace {

using geometry::printed;

}  // namespace

void RateEstimate::update(double time, std::int64_t step, double wall) {
  if (started_ && wall > last_wall_) {
    const double keep = std::exp(-(wall - last_wall_) / memory_);
    simulated_ = simulated_ * keep + (time - last_time_);
    steps_ = steps_ * keep + static_cast<double>(step - last_step_);
    wall_ = wall_ * keep + (wall - last_wall_);
  }
  if (started_ && wall <= last_wall_) return;  // without time between, progress counts at the next update
  started_ = true;
  last_time_ = time;
  last_step_ = step;
  last_wall_ = wall;
}

std::optional<double> RateEstimate::seconds_left(double end_time) const noexcept {
  if (wall_ <= 0 || simulated_ <= 0) return std::nullopt;
  return std::max(0.0, end_time - last_time_) * wall_ / simulated_;
}

std::string format_count(std::int64_t n) {
  std::string text = std::to_string(n);
  const int first = n < 0 ? 1 : 0;
  for (int i = static_cast<int>(text.size()) - 3; i > first; i -= 3) text.insert(static_cast<std::size_t>(i), 1, ',');
  return text;
}

std::string format_duration(double seconds) {
  if (!std::isfinite(seconds) || seconds > 1e10) return "ages";
  const auto s = static_cast<long long>(std::max(0.0, seconds) + 0.5);
  if (s < 60) return printed("%lld s", s);
  if (s < 3600) return printed("%lld min %02lld s", s / 60, s % 60);
  const long long minutes = (s + 30) / 60;
  if (minutes < 24 * 60) return printed("%lld h %02lld min", minutes / 60, minutes % 60);
  const long long hours = (minutes + 30) / 60;
  return printed("%lld d %02lld h", hours / 24, hours % 24);
}

std::string format_progress(const ProgressState& state, double steps_per_second, std::optional<double> seconds_left) {
  std::string line = state.settling ? printed("settling, %.3f s", state.time) : printed("%.3f of %g s", state.time, state.end_time);
  const bool at_rest = state.states >= 0;  // nobody knows how many more there will be
  if (at_rest)
    line = printed("%lld states of rest, ", static_cast<long long>(state.states)) +
           (state.headway.empty() ? printed("load factor %.4f", state.factor) : state.headway) +
           printed(", unbalanced %.1e", state.unbalanced);
  const auto speed = static_cast<std::int64_t>(std::llround(std::min(steps_per_second, 1e15)));
  line += "  " + (steps_per_second < 10 ? printed("%.2g", steps_per_second) : format_count(speed)) + " steps/s";
  if (!at_rest) line += "  " + (seconds_left ? format_duration(*seconds_left) + " left" : std::string("time left unknown"));
  line += "  " + format_count(state.broken) + " broken";
  return line + printed("  energy error %.1e", state.residual);
}

std::string progress_json(const ProgressState& state, double steps_per_second, std::optional<double> seconds_left) {
  using Json = nlohmann::ordered_json;
  const bool at_rest = state.states >= 0;
  Json out{{"kind", "progress"},
           {"time", state.time},
           {"end", state.settling || at_rest ? Json(nullptr) : Json(state.end_time)},
           {"settling", state.settling},
           {"step", state.step},
           {"steps_per_second", steps_per_second},
           {"seconds_left", seconds_left && !at_rest ? Json(*seconds_left) : Json(nullptr)},
           {"broken", state.broken},
           {"residual", state.residual},
           {"states", at_rest ? Json(state.states) : Json(nullptr)}};
  if (at_rest) out["factor"] = state.factor, out["unbalanced"] = state.unbalanced;
  out["text"] = format_progress(state, steps_per_second, seconds_left);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Progress::Mode Progress::mode_for(int descriptor, bool quiet) {
  if (quiet) return Mode::quiet;
  if (says_json()) return Mode::json;
  return ::isatty(descriptor) == 1 ? Mode::terminal : Mode::log;
}

void Progress::update(const ProgressState& state, double wall_seconds) {
  if (mode_ == Mode::quiet) return;
  rate_.update(state.time, state.step, wall_seconds);
  state_ = state;
  pending_ = true;
  if (!last_line_) last_line_ = wall_seconds;  // the first line waits until a speed is known
  if (wall_seconds - *last_line_ < interval_) return;
  last_line_ = wall_seconds;
  write(false);
}

void Progress::finish() {
  if (pending_) write(true);
  pending_ = false;
}

void Progress::write(bool last) {
  const bool terminal = mode_ == Mode::terminal;
  const auto format = mode_ == Mode::json ? progress_json : format_progress;
  const std::string line = format(state_, rate_.steps_per_second(), rate_.seconds_left(state_.end_time));
  // Return to the first column without wrapping, and erase the rest of a longer line.
  if (terminal)
    *out_ << "\r\x1b[?7l" << line << "\x1b[K\x1b[?7h" << (last ? "\n" : "");
  else
    *out_ << line << '\n';
  out_->flush();
  pending_ = terminal && !last;
}

}  // namespace voussoir::io
