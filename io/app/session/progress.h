// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

/// How far a run has come, for people who wait for it.
namespace voussoir::io {

struct ProgressState {
  double time = 0;      // s simulated; below zero while settling
  double end_time = 0;  // s
  bool settling = false;
  std::int64_t step = 0;
  std::int64_t broken = 0;  // segments
  double residual = 0;      // of the energy balance, a ratio
};

/// Speed of the run over the last ten seconds or so. It changes during a collapse, so the past is forgotten.
class RateEstimate {
 public:
  /// \param memory  wall-clock seconds after which a measurement counts 1/e
  explicit RateEstimate(double memory = 10.0) : memory_(memory) {}
  /// \param wall  wall-clock, s, not falling
  void update(double time, std::int64_t step, double wall);
  /// Steps a second of wall-clock; 0 while unknown.
  [[nodiscard]] double steps_per_second() const noexcept { return wall_ > 0 ? steps_ / wall_ : 0.0; }
  /// Wall-clock until `end_time` at this speed, s; absent while unknown.
  [[nodiscard]] std::optional<double> seconds_left(double end_time) const noexcept;

 private:
  double memory_;
  bool started_ = false;
  double last_time_ = 0, last_wall_ = 0;
  std::int64_t last_step_ = 0;
  double simulated_ = 0, steps_ = 0, wall_ = 0;  // decaying sums
};

/// 1234567 as 1,234,567.
std::string format_count(std::int64_t n);
/// A duration to two units: "42 s", "3 min 20 s", "2 h 05 min", "3 d 04 h". Below a second "0 s".
std::string format_duration(double seconds);
/// The line without its end: "3.214 of 10 s  12,345 steps/s  2 min 10 s left  1,234 broken  residual 1.2e-06".
std::string format_progress(const ProgressState& state, double steps_per_second, std::optional<double> seconds_left);

/// Writes the progress of one run to a stream: on a terminal one line that is written over, elsewhere a line every so often.
class Progress {
 public:
  enum class Mode { terminal, log, quiet };

  /// What suits a file descriptor (2: standard error).
  static Mode mode_for(int descriptor, bool quiet);

  /// \param log_interval  s of wall-clock between two lines in a log; a terminal gets five a second
  Progress(std::ostream& out, Mode mode, double log_interval = 10.0)
      : out_(&out), mode_(mode), interval_(mode == Mode::log ? log_interval : 0.2) {}

  /// Cheap: to be called as often as convenient. \param wall_seconds  wall-clock since any fixed moment, s
  void update(const ProgressState& state, double wall_seconds);
  /// Leaves the last state given as a complete line. A second call does nothing.
  void finish();

 private:
  void write(bool last);

  std::ostream* out_;
  Mode mode_;
  double interval_;
  RateEstimate rate_;
  ProgressState state_;
  std::optional<double> last_line_;  // wall-clock, s
  bool pending_ = false;             // the last state is not written, or its line not ended
};

}  // namespace voussoir::io
