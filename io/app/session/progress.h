// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

/// Progress of a run for the user.
namespace voussoir::io {

struct ProgressState {
  double time = 0;      // s simulated; below zero while settling
  double end_time = 0;  // s
  bool settling = false;
  std::int64_t step = 0;
  std::int64_t broken = 0;            // number of broken segments
  double residual = 0;                // relative residual of the energy balance
  std::int64_t states = -1;           // of rest so far; -1: the run has none
  double factor = 0, unbalanced = 0;  // load factor, and how far from rest
  std::string headway{};              // of states of rest: how far the analysis is, and what ends it (headway.h)
};

/// Speed of the run over about the last ten seconds, with decaying memory since it changes during a collapse.
class RateEstimate {
 public:
  /// \param memory  s of wall-clock time after which the weight of a measurement is 1/e
  explicit RateEstimate(double memory = 10.0) : memory_(memory) {}
  /// \param wall  wall-clock time [s], not decreasing
  void update(double time, std::int64_t step, double wall);
  /// Steps per second of wall-clock time; 0 while unknown.
  [[nodiscard]] double steps_per_second() const noexcept { return wall_ > 0 ? steps_ / wall_ : 0.0; }
  /// Wall-clock time until `end_time` at this speed [s]; absent while unknown.
  [[nodiscard]] std::optional<double> seconds_left(double end_time) const noexcept;

 private:
  double memory_;
  bool started_ = false;
  double last_time_ = 0, last_wall_ = 0;
  std::int64_t last_step_ = 0;
  double simulated_ = 0, steps_ = 0, wall_ = 0;  // decaying sums
};

/// Formats 1234567 as 1,234,567.
std::string format_count(std::int64_t n);
/// A duration to two units: "42 s", "3 min 20 s", "2 h 05 min", "3 d 04 h". Below a second "0 s".
std::string format_duration(double seconds);
/// The line of progress without line end: "3.214 of 10 s 12,345 steps/s 2 min 10 s left 1,234 broken energy error 1.2e-06"; of states of
/// rest "12 states of rest, HEADWAY, unbalanced 3.0e-04 12,345 steps/s ...".
std::string format_progress(const ProgressState& state, double steps_per_second, std::optional<double> seconds_left);
/// The same as a JSON object, figure by figure (io/README.md, Messages).
std::string progress_json(const ProgressState& state, double steps_per_second, std::optional<double> seconds_left);

/// Writes the progress of one run to a stream: on a terminal one line that is overwritten, elsewhere a line at intervals, for programs
/// a JSON object a line.
class Progress {
 public:
  enum class Mode { terminal, log, quiet, json };

  /// The suitable mode for a file descriptor (2: standard error), by the form of all messages.
  static Mode mode_for(int descriptor, bool quiet);

  /// \param log_interval  s of wall-clock time between two lines in a log; a terminal and JSON get five lines per second
  Progress(std::ostream& out, Mode mode, double log_interval = 10.0)
      : out_(&out), mode_(mode), interval_(mode == Mode::log ? log_interval : 0.2) {}

  /// Updates the line if it is due; cheap, so it may be called often. \param wall_seconds  wall-clock time since any fixed moment [s]
  void update(const ProgressState& state, double wall_seconds);
  /// Writes the last state as a complete line. A second call has no effect.
  void finish();

 private:
  void write(bool last);

  std::ostream* out_;
  Mode mode_;
  double interval_;
  RateEstimate rate_;
  ProgressState state_;
  std::optional<double> last_line_;  // wall-clock, s
  bool pending_ = false;             // the last state is not written, or its line has no end
};

}  // namespace voussoir::io
