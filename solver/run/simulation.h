// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/motion.h"
#include "solver/equilibrium/path.h"
#include "solver/equilibrium/relaxation.h"
#include "solver/run/cuts.h"
#include "solver/run/damage.h"
#include "solver/run/forces.h"
#include "solver/run/ledger.h"
#include "solver/run/load_program.h"
#include "solver/run/over_elements.h"
#include "solver/run/recorder.h"
#include "solver/team/team_size.h"
#include "solver/world/stages.h"
#include "solver/world/world.h"

/// One run: the world, its clock, and the step.
namespace voussoir::solver {

enum class Phase : std::uint8_t { settling, shaking };

/// Output required from a step.
struct Due {
  bool sample = false;  // histories and forces: displacements and mid-step velocities
  bool ledger = false;  // an energy row
};

class Simulation {
 public:
  /// Builds the world, which settles first if the case requires it. Case and model must outlive the simulation.
  /// \throw cases::InputError
  Simulation(const cases::Case& c, const cases::Model& m, const cases::GroundMotion& motion, const Options& o);
  ~Simulation();

  /// Advances by one step of dt. Stages in order: supports, search, forces, damage, loads, kick, samples, drift, ledger.
  /// \throw NumericalError if the state has a NaN, or a speed too high for a house
  void step(Due due);

  [[nodiscard]] double time() const { return time_of(step_); }  // s; < 0 while settling
  [[nodiscard]] std::int64_t steps() const { return step_; }    // in this phase
  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] double dt() const { return world_->dt; }
  /// Steps of a cycle of multi-rate stepping, else 1. Samples, rows of energies and frames belong to first steps of cycles.
  [[nodiscard]] std::int64_t cycle() const { return world_->multirate.wanted; }
  [[nodiscard]] const World& world() const { return *world_; }
  [[nodiscard]] World& world() { return *world_; }
  /// Sets the largest number of threads for the next steps. No bit depends on it.
  void set_threads(int threads);
  [[nodiscard]] int threads() const { return pace_.most(); }
  [[nodiscard]] const TeamSize& pace() const { return pace_; }

  /// The load program of a quasi-static analysis; without effect in a time history.
  [[nodiscard]] const LoadProgram& program() const { return program_; }
  [[nodiscard]] LoadProgram& program() { return program_; }

  /// Of an analysis whose rows are states of rest; off in any other.
  [[nodiscard]] const Relaxation& relaxation() const { return relaxation_; }
  void restore_masses() { relaxation_.restore(*world_); }  // see Relaxation::restore
  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] Path& path() { return path_; }
  /// Takes the state of rest of the last step, which had a sample, as a point of the path.
  void accept_rest();

  /// Whether, while settling, gravity is complete and (nearly) nothing moves. Determined only by a step with a ledger row.
  [[nodiscard]] bool at_rest() const;
  /// Whether the time limit of settling has passed.
  [[nodiscard]] bool settled_too_long() const;
  /// Ends settling: velocities, clock and ledger restart from zero, with the case's own damping.
  void start_shaking();

  // Results of the last step.
  [[nodiscard]] const EnergyRow& energy() const { return ledger_.last(); }
  [[nodiscard]] double worst_residual() const { return ledger_.worst_residual(); }
  [[nodiscard]] const std::vector<HistorySample>& history() const { return samples_; }
  [[nodiscard]] const std::vector<LoadSample>& loads() const { return load_samples_; }  // by [[load]]
  [[nodiscard]] const ForcesRow& forces() const { return forces_; }
  /// Forces through cuts in the last step with a ledger row during the shaking, in the order of Output::cuts.
  [[nodiscard]] const std::vector<CutSample>& cuts() const { return cut_samples_; }
  [[nodiscard]] const Damage& damage() const { return damage_; }
  /// Cracks since the caller last cleared the list.
  [[nodiscard]] std::vector<CrackRow>& cracks() { return cracks_; }
  [[nodiscard]] double peak_speed() const { return peak_speed_; }
  /// Ends the path of a relaxation in which an element moves at 200 m/s or more: what falls has no state of rest.
  /// \throw NumericalError if an element does so otherwise, or its speed is not finite
  void check_speeds() { (void)fastest_square(); }
  /// Wall-clock times by stage since the simulation was built; others add theirs (output).
  [[nodiscard]] StageTimes& stage_times() { return times_; }
  [[nodiscard]] const StageTimes& stage_times() const { return times_; }
  /// Switches the timing of the parts of the stage of forces on or off; it costs some hundredths of a step.
  void time_parts(bool on) {
    forces_stage_.split = on;
    forces_stage_.tasks.time_tasks(on);
  }
  /// Time of forces on one thread alone [s].
  [[nodiscard]] double alone_time() const { return forces_stage_.alone; }
  [[nodiscard]] const JointTasks& joint_tasks() const { return forces_stage_.tasks; }
  [[nodiscard]] const ForceTimes& part_times() const { return forces_stage_.parts; }
  /// Name for messages of the fastest element (or of one with NaN): the first to examine after a numerical failure.
  [[nodiscard]] std::string fastest_element() const;

 private:
  friend struct FieldTable;
  void advance(Due due);
  [[nodiscard]] double time_of(std::int64_t step) const;
  void place_supports();
  void move_supports_on();
  void apply_loads();
  void relax();
  [[nodiscard]] double support_time(double ahead) const;
  void measure_base_forces();
  void take_samples();
  void note_velocities();
  void kick();
  void drift();
  void kick_and_drift();
  template <class Work>
  double over_due_elements(Work work);
  void note_move(double moved);
  double fastest_square();  // of the largest speed [m2/s2]; after give_up: 0
  void give_up();           // of elements that are too fast, as check_speeds() says
  /// Parameters of the moves of elements of one level (multirate.h).
  struct Move {
    kernels::BodyForces forces;
    kernels::TravelView travel;
  };
  [[nodiscard]] bool damps_rotation() const;
  [[nodiscard]] kernels::BodyForces body_forces(int level) const;
  [[nodiscard]] double gravity_share(double t) const;  // applied share of gravity, and of the pretension of ties
  [[nodiscard]] Vec3 gravity_at(double t) const;
  [[nodiscard]] Vec3 ground_at(double t) const;
  [[nodiscard]] Vec3 damped_ground(double t) const;  // see BodyForces
  void set_damping(double alpha);

  const cases::Case& case_;
  cases::GroundMotion motion_;
  cases::GroundVelocity ground_velocity_;
  std::unique_ptr<World> world_;
  LoadProgram program_;
  Relaxation relaxation_;
  Path path_;
  Lead lead_;
  Phase phase_ = Phase::shaking;
  std::int64_t step_ = 0;
  Vec3 full_gravity_;            // m/s2, tilted
  double ramp_ = 0.0;            // s
  double settle_limit_ = 0.0;    // s, after the ramp
  double settling_alpha_ = 0.0;  // 1/s
  Array<double> case_alpha_;
  ForceStage forces_stage_;
  // A range of elements taken from another thread is some five hundred cache lines of traffic both ways: much patience.
  TaskShares update_shares_{1.0};
  std::vector<Most> most_;
  TeamSize pace_;
  double moved_ = 0.0;  // m, largest displacement of the elements due for a search; 0: none in this cycle
  StageTimes times_{};
  Damage damage_;
  Ledger ledger_;
  std::vector<CrackRow> cracks_;
  std::vector<std::int32_t> followed_;  // elements, for Recorder::history
  std::vector<Vec3> start_;             // m, displacements of the followed elements at time zero
  std::vector<Quaternion> turned_;      // orientations of the followed elements at time zero
  std::vector<Vec3> velocity_before_;   // m/s, velocities of the followed elements at the half step before
  std::vector<Vec3> load_before_;       // N, N m of each load at the last step (force, moment pairs)
  std::vector<Vec3> load_start_;        // m, places_of_loads() at time zero
  std::vector<HistorySample> samples_;
  std::vector<LoadSample> load_samples_;
  ForcesRow forces_;
  Cuts cuts_;
  std::vector<CutSample> cut_samples_;
  double peak_speed_ = 0.0;  // m/s
};

}  // namespace voussoir::solver
