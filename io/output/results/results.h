// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "geometry/nth.h"
#include "io/output/measures/capacity/capacity.h"
#include "io/output/measures/measures.h"
#include "io/output/results/provenance.h"
#include "io/output/results/results_model.h"
#include "io/output/results/results_parts.h"
#include "solver/run/recorder.h"

/// Results of a run: `DIR/run.h5`, readable by any HDF5 reader at any time during the run and after a kill.
///
/// Rows are buffered; from time to time they become a file parts/NNNN.h5, and run.h5 is replaced by one that also refers to that file. A
/// file under its final name is never written to. Therefore run.h5 shows the rows up to the last part, and a kill loses only later rows.
/// Where parts are many, some of them become one: a new file, a new run.h5 that names it in their place, and only then they are removed.
namespace voussoir::io {

struct ResultsOptions {
  double interval = 10;            // s of wall-clock time between parts; grows to a twentieth of the run so far, which bounds their number
  std::size_t bytes = 32UL << 20;  // of buffered rows at which a part is written; increased to a twentieth of the bytes on disk
  bool merge = true;               // finish() copies all rows into run.h5
  std::uint64_t merge_limit = 4UL << 30;  // bytes of rows above which finish() does not merge, nor parts become one during the run
  std::size_t most_parts = 64;            // above, some become one: each costs memory, and time at every later part
  std::vector<StaticDataset> motion;      // of the base: motion_datasets
  std::vector<std::string> cuts;          // names, one for each sample of cuts(), in order
  /// Rows to continue with in the folder. Absent: a new run.
  std::optional<EarlierRows> earlier;
};

/// Writes the summary as attributes of /summary. \throw FileError
void write_summary(Hdf5File& file, const solver::Summary& s);
/// Writes how an analysis loads as attributes of /assessment. \param control  element that is the control point; none: not known
/// \throw FileError
void write_drive(Hdf5File& file, const solver::Drive& d, std::optional<std::int32_t> control);

class ResultsWriter final : public solver::Recorder {
 public:
  /// Writes run.h5 with the model and no rows, so that readers find it from the start. Each later run.h5 takes the model from the one
  /// before it: the writer keeps nothing of `model`.
  ///
  /// \param folder  of the run, existing (see RunFolder)
  /// \param case_toml  the resolved case
  /// \param history_names  one for each sample of history(), in order
  /// \throw FileError if the folder has results already (and `earlier` is absent) or is not writable
  /// \throw std::invalid_argument for a bad history name (see row_schema) or a model that does not fit together (see write_model)
  ResultsWriter(std::string folder, const cases::Model& model, std::string case_toml, std::span<const std::string> history_names,
                Provenance provenance, const ResultsOptions& options = {});
  ResultsWriter(const ResultsWriter&) = delete;
  ResultsWriter& operator=(const ResultsWriter&) = delete;
  /// Writes buffered rows and ignores errors; call flush() or finish() to get them.
  ~ResultsWriter() override;

  /// Recorder functions, each of which may write a part. A second row with the time of the last row is left out (except cracks).
  /// \throw FileError if the part or run.h5 cannot be written; parts on disk and buffered rows are kept
  /// \throw std::logic_error if time decreases, or the number of samples or the frame size does not fit the model
  void history(double time, std::span<const solver::HistorySample> samples) override;
  void ties(double time, std::span<const solver::TieSample> samples) override;
  void tie_groups(double time, std::span<const solver::TieGroupSample> samples) override;
  void loads(double time, std::span<const solver::LoadSample> samples) override;
  void energy(const solver::EnergyRow& row) override;
  void forces(const solver::ForcesRow& row) override;
  void cuts(double time, std::span<const solver::CutSample> samples) override;
  void damage(const solver::DamageRow& row) override;
  void cracks(std::span<const solver::CrackRow> rows) override;
  void frame(const solver::FrameView& frame) override;
  void assessment(const solver::AssessmentRow& row) override;
  /// Sets attributes of /assessment, written to run.h5 with the next part.
  void drive(const solver::Drive& d) override;
  void control(std::int32_t element) override;
  /// Sets the summary, written to run.h5 with the next part.
  void summary(const solver::Summary& s) override;
  /// Sets the final solver::state_hash, written to run.h5 beside the summary with the next part.
  void state_hash(std::uint64_t hash);
  /// Sets the reason why a run ended early, written to run.h5 beside the summary with the next part.
  void failure(std::string why);

  /// Computes the measures of a collapse (measures.h) from all rows so far, written to run.h5 beside the summary with the next part. For
  /// the end of a run or a stop. \throw FileError
  void measure();

  /// Results of a quasi-static analysis, set by measure().
  [[nodiscard]] const std::optional<Capacity>& capacity() const noexcept { return capacity_; }
  /// Measures, set by measure().
  [[nodiscard]] const std::optional<Measures>& measures() const noexcept { return measures_; }

  /// Writes buffered rows as a part and replaces run.h5. To be called before a checkpoint is written, so that a resumed run finds all rows
  /// up to it.
  /// \throw FileError
  void flush();
  /// Ends a run: flushes, marks run.h5 as finished, and merges all rows into it if options allow. The writer accepts no rows afterwards. A
  /// kill at any time during the call loses nothing.
  /// \return true if merged; false: the rows stay in parts, also when merging fails (e.g. for lack of space)
  /// \throw FileError if the last rows cannot be written, or earlier ones can no longer be read
  bool finish();

  /// Number of rows so far, on disk or buffered.
  [[nodiscard]] RowCounts rows() const noexcept;
  /// Number of parts on disk.
  [[nodiscard]] std::size_t parts() const noexcept { return parts_.size(); }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] RowBuffer& table(RowTable t) noexcept { return nth(buffers_, t); }
  void put_ties(RowBuffer& to, std::size_t& column);
  void put_groups(RowBuffer& to, std::size_t& column);
  void put_loads(RowBuffer& to, std::size_t column);
  [[nodiscard]] double wall_clock() const;
  void continue_earlier();
  void write_if_due();
  void write_buffers();
  void write_run(bool merged, const cases::Model* model = nullptr);
  void remove_replaced() noexcept;
  void merge_if_many();
  void write_facts(Hdf5File& file, bool merged, const cases::Model* model) const;

  std::string folder_, case_toml_;
  std::size_t elements_, histories_;
  std::vector<solver::TieSample> ties_;         // of the next row
  std::vector<solver::TieGroupSample> groups_;  // likewise
  std::vector<solver::LoadSample> loads_;       // likewise
  RowSchema schema_;
  Provenance provenance_;
  ResultsOptions options_;
  std::array<RowBuffer, kRowTables> buffers_;
  std::optional<Hdf5File> last_run_;  // run.h5, open for its model, which lasts if the file is removed
  std::vector<Part> parts_;
  std::vector<Part> replaced_;  // files that run.h5 names no more; gone after the next run.h5, so that readers of the last one can end
  std::size_t next_part_ = 0, merge_above_ = 0;
  std::optional<solver::Summary> summary_;
  std::optional<solver::Drive> drive_;
  std::optional<std::int32_t> control_;  // element
  std::optional<std::uint64_t> state_hash_;
  std::optional<std::string> failure_;
  std::optional<Measures> measures_;
  std::optional<Capacity> capacity_;
  bool stale_ = false;  // run.h5 is not up to date
  bool finished_ = false;
  std::uint64_t bytes_on_disk_ = 0;
  Clock::time_point start_ = Clock::now(), last_write_ = start_;
};

}  // namespace voussoir::io
