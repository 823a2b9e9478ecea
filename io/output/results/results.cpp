// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/results.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "cases/model.h"
#include "cases/ties/ties.h"
#include "io/input/files/errors.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/measures_file.h"

namespace voussoir::io {
namespace {

// Greatest share of the run so far that a kill may cost. A day of running then gives some 140 parts besides those at checkpoints: every
// part makes run.h5 more expensive to write (2 ms) and to read, and a reader opens all parts of a dataset.
constexpr double kShare = 0.05;

std::string hexadecimal(std::uint64_t n) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(n));
  return text.data();
}

}  // namespace

ResultsWriter::ResultsWriter(std::string folder, const cases::Model& model, std::string case_toml,
                             std::span<const std::string> history_names, Provenance provenance, const ResultsOptions& options)
    : folder_(std::move(folder)),
      case_toml_(std::move(case_toml)),
      elements_(model.blocks.size()),
      histories_(history_names.size()),
      ties_(cases::own_ties(model)),
      groups_(cases::tie_groups(model).size()),
      loads_(model.load_history.size()),
      schema_(row_schema(history_names, model.blocks.size(), options.cuts, ties_.size(), groups_.size(), model.load_history.size())),
      provenance_(std::move(provenance)),
      options_(options) {
  for (std::size_t t = 0; t < kRowTables; ++t) buffers_[t] = RowBuffer(schema_[t]);
  if (options_.earlier)
    continue_earlier();
  else if (std::filesystem::exists(folder_ + "/run.h5") || std::filesystem::exists(folder_ + "/" + part_name(0)))
    throw FileError(folder_, "holds the results of another run");
  std::error_code error;
  std::filesystem::create_directory(folder_ + "/parts", error);
  if (error) throw FileError(folder_ + "/parts", "cannot make the folder: " + error.message());
  write_run(false, &model);
  // Only now run.h5 no longer refers to the dropped parts.
  remove_parts(folder_, parts_);
  std::filesystem::create_directory(folder_ + "/parts", error);
}

ResultsWriter::~ResultsWriter() {
  try {
    if (!finished_) flush();
    if (!stale_) remove_replaced();
  } catch (...) {  // no caller to report to
  }
}

void ResultsWriter::continue_earlier() {
  parts_ = keep_parts(folder_, schema_, *options_.earlier);
  for (std::size_t t = 0; t < kRowTables; ++t) buffers_[t].continue_after(last_time(folder_, static_cast<RowTable>(t), parts_));
  for (const Part& p : parts_) {
    bytes_on_disk_ += row_bytes(schema_, p);
    next_part_ = std::max(next_part_, part_number(p.file.substr(p.file.find('/') + 1)).value_or(0) + 1);
  }
}

void ResultsWriter::history(double time, std::span<const solver::HistorySample> samples) {
  if (samples.size() != histories_) throw std::logic_error("a row of histories has another number of samples than there are names");
  RowBuffer& to = table(RowTable::history);
  if (!to.begin(time)) return;
  std::size_t column = 1;
  for (const solver::HistorySample& s : samples) {
    to.put(column++, s.displacement);
    to.put(column++, s.velocity);
    to.put(column++, s.rotation);
  }
  if (!ties_.empty()) put_ties(to, column);
  if (!groups_.empty()) put_groups(to, column);
  if (!loads_.empty()) put_loads(to, column);
  write_if_due();
}

void ResultsWriter::ties(double, std::span<const solver::TieSample> samples) {
  if (samples.size() != ties_.size()) throw std::logic_error("a row of ties has another number of samples than the model");
  std::ranges::copy(samples, ties_.begin());
}

void ResultsWriter::tie_groups(double, std::span<const solver::TieGroupSample> samples) {
  if (samples.size() != groups_.size()) throw std::logic_error("a row of decks and meshes has another number of samples than the model");
  std::ranges::copy(samples, groups_.begin());
}

void ResultsWriter::loads(double, std::span<const solver::LoadSample> samples) {
  if (samples.size() != loads_.size()) throw std::logic_error("a row of loads has another number of samples than the case");
  std::ranges::copy(samples, loads_.begin());
}

void ResultsWriter::put_ties(RowBuffer& to, std::size_t& column) {
  for (const auto value : {&solver::TieSample::force, &solver::TieSample::elongation, &solver::TieSample::plastic}) {
    for (const solver::TieSample& s : ties_) to.put(column, s.*value);
    ++column;
  }
  for (const solver::TieSample& s : ties_) to.put(column, static_cast<std::uint8_t>(s.broken));
  ++column;
}

void ResultsWriter::put_groups(RowBuffer& to, std::size_t& column) {
  for (const auto value : {&solver::TieGroupSample::force, &solver::TieGroupSample::elongation, &solver::TieGroupSample::utilisation}) {
    for (const solver::TieGroupSample& s : groups_) to.put(column, s.*value);
    ++column;
  }
  for (const auto value : {&solver::TieGroupSample::yielded, &solver::TieGroupSample::broken}) {
    for (const solver::TieGroupSample& s : groups_) to.put(column, s.*value);
    ++column;
  }
}

void ResultsWriter::put_loads(RowBuffer& to, std::size_t column) {
  for (const solver::LoadSample& s : loads_) to.put(column, s.force);
  for (const solver::LoadSample& s : loads_) to.put(column + 1, s.displacement);
}

void ResultsWriter::energy(const solver::EnergyRow& row) {
  RowBuffer& to = table(RowTable::energy);
  if (!to.begin(row.time)) return;
  std::size_t column = 1;
  for (const double value :
       {row.kinetic, row.strain, row.contact, row.gravity, row.input, row.dashpot, row.friction, row.fracture, row.damping, row.residual})
    to.put(column++, value);
  write_if_due();
}

void ResultsWriter::forces(const solver::ForcesRow& row) {
  RowBuffer& to = table(RowTable::forces);
  if (!to.begin(row.time)) return;
  to.put(1, row.base_shear);
  to.put(2, row.base_moment);
  write_if_due();
}

void ResultsWriter::cuts(double time, std::span<const solver::CutSample> samples) {
  if (samples.size() != options_.cuts.size()) throw std::logic_error("a row of cuts has another number of samples than there are names");
  RowBuffer& to = table(RowTable::cuts);
  if (!to.begin(time)) return;
  std::size_t column = 1;
  for (const solver::CutSample& s : samples) {
    to.put(column++, s.force);
    to.put(column++, s.moment);
  }
  write_if_due();
}

void ResultsWriter::damage(const solver::DamageRow& row) {
  RowBuffer& to = table(RowTable::damage);
  if (!to.begin(row.time)) return;
  std::size_t column = 1;
  for (const std::int64_t value :
       {row.bonded, row.slipped, row.tension, row.shear, row.compression, row.first.tension, row.first.shear, row.first.compression})
    to.put(column++, value);
  write_if_due();
}

void ResultsWriter::cracks(std::span<const solver::CrackRow> rows) {
  RowBuffer& to = table(RowTable::cracks);
  for (const solver::CrackRow& row : rows) {
    to.begin(row.time, true);
    to.put(1, row.joint);
    to.put(2, row.element_a);
    to.put(3, row.element_b);
    to.put(4, row.position);
    to.put(5, row.normal);
    to.put(6, row.area);
    to.put(7, row.mode);
    to.put(8, row.first_mode);
    to.put(9, row.first_time);
  }
  if (!rows.empty()) write_if_due();
}

void ResultsWriter::frame(const solver::FrameView& frame) {
  if (frame.displacement.size() != 3 * elements_ || frame.quaternion.size() != 4 * elements_ || frame.broken.size() != elements_)
    throw std::logic_error("a frame has another number of elements than the model");
  RowBuffer& to = table(RowTable::frames);
  if (!to.begin(frame.time)) return;
  to.put(1, frame.displacement.data(), frame.displacement.size_bytes());
  to.put(2, frame.quaternion.data(), frame.quaternion.size_bytes());
  to.put(3, frame.broken.data(), frame.broken.size_bytes());
  write_if_due();
}

void ResultsWriter::assessment(const solver::AssessmentRow& row) {
  RowBuffer& to = table(RowTable::assessment);
  if (!to.begin(row.time)) return;
  std::size_t column = 1;
  for (const double value :
       {row.factor, row.displacement, row.drift, row.moved, row.base_shear, row.support_moved, row.over, row.unbalanced})
    to.put(column++, value);
  write_if_due();
}

void ResultsWriter::drive(const solver::Drive& d) {
  drive_ = d;
  stale_ = true;
}

void ResultsWriter::control(std::int32_t element) {
  control_ = element;
  stale_ = true;
}

void ResultsWriter::summary(const solver::Summary& s) {
  summary_ = s;
  stale_ = true;
}

void ResultsWriter::state_hash(std::uint64_t hash) {
  state_hash_ = hash;
  stale_ = true;
}

void ResultsWriter::failure(std::string why) {
  failure_ = std::move(why);
  stale_ = true;
}

void ResultsWriter::measure() {
  flush();
  const Hdf5File run = Hdf5File::open(folder_ + "/run.h5");
  measures_ = io::measure(run);
  capacity_ = capacity_of(run);
  stale_ = true;
}

double ResultsWriter::wall_clock() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void ResultsWriter::write_if_due() {
  if (finished_) throw std::logic_error("a row of results comes after the end of the run");
  std::size_t bytes = 0;
  for (const RowBuffer& b : buffers_) bytes += b.bytes();
  const auto now = Clock::now();
  const double since = std::chrono::duration<double>(now - last_write_).count();
  const double so_far = std::chrono::duration<double>(now - start_).count();
  if (since >= std::max(options_.interval, kShare * so_far) ||
      static_cast<double>(bytes) >= std::max(static_cast<double>(options_.bytes), kShare * static_cast<double>(bytes_on_disk_)))
    flush();
}

void ResultsWriter::write_buffers() {
  std::size_t bytes = 0;
  for (const RowBuffer& b : buffers_) bytes += b.bytes();
  if (bytes == 0) return;
  parts_.push_back(write_part(folder_, part_name(next_part_), schema_, buffers_));
  ++next_part_;
  for (RowBuffer& b : buffers_) b.clear();
  bytes_on_disk_ += bytes;
  stale_ = true;
}

void ResultsWriter::flush() {
  last_write_ = Clock::now();  // also after a failure, so that the next row does not try again at once
  write_buffers();
  if (stale_) {
    write_run(false);
    remove_replaced();
  }
  stale_ = false;
  merge_if_many();
}

void ResultsWriter::remove_replaced() noexcept {
  std::error_code ignored;
  for (const Part& p : replaced_) std::filesystem::remove(folder_ + "/" + p.file, ignored);
  replaced_.clear();
}

// Where this fails, for lack of room say, the run goes on with the parts as they are.
void ResultsWriter::merge_if_many() {
  if (parts_.size() <= std::max(options_.most_parts, merge_above_)) return;
  merge_above_ = parts_.size() + options_.most_parts / 2;  // next time, if not this time
  const std::optional<PartRange> range = parts_to_merge(schema_, parts_, options_.merge_limit);
  if (!range) return;
  const auto begin = parts_.begin() + static_cast<std::ptrdiff_t>(range->first), end = begin + static_cast<std::ptrdiff_t>(range->count);
  const std::vector<Part> before = parts_;
  std::vector<Part> old(begin, end);
  Part merged;
  try {
    merged = merge_parts(folder_, part_name(next_part_), schema_, old);
    ++next_part_;
    *begin = merged;
    parts_.erase(begin + 1, end);
    write_run(false);
    replaced_ = std::move(old);
    merge_above_ = 0;
  } catch (const FileError&) {
    if (merged.file.empty()) return;
    parts_ = before;
    replaced_ = {merged};  // once a run.h5 without it is there
    stale_ = true;
  }
}

bool ResultsWriter::finish() {
  write_buffers();
  provenance_.ended = utc_now();
  finished_ = true;
  write_run(false);
  remove_replaced();
  if (!options_.merge || bytes_on_disk_ > options_.merge_limit) return false;
  try {
    write_run(true);
  } catch (const FileError& e) {
    if (e.path().starts_with(folder_ + "/parts/")) throw;  // not a lack of space: rows can no longer be read
    return false;
  }
  // A kill before this line leaves parts without references.
  remove_parts(folder_, {});
  return true;
}

void ResultsWriter::write_facts(Hdf5File& file, bool merged, const cases::Model* model) const {
  file.set_attribute("/", "parts", static_cast<std::int64_t>(merged ? 0 : parts_.size()));
  file.make_group("/case");
  file.set_attribute("/case", "toml", case_toml_);
  write_provenance(file, provenance_, wall_clock());
  file.make_group("/summary");
  file.set_attribute("/summary", "finished", std::int64_t{finished_});
  if (state_hash_) file.set_attribute("/summary", "state_hash", hexadecimal(*state_hash_));
  if (failure_) file.set_attribute("/summary", "failure", *failure_);
  if (summary_) write_summary(file, *summary_);
  if (drive_) write_drive(file, *drive_, control_);
  if (measures_) write_measures(file, *measures_);
  if (capacity_) write_capacity(file, *capacity_);
  model != nullptr ? write_model(file, *model) : file.copy_group(*last_run_, "/model");
  write_datasets(file, options_.motion);
}

/// \param model  of the first run.h5; nullptr: that of the last one
void ResultsWriter::write_run(bool merged, const cases::Model* model) {
  write_file(folder_ + "/run.h5", [&](Hdf5File& file) {
    write_facts(file, merged, model);
    merged ? copy_rows(file, folder_, schema_, parts_) : link_rows(file, schema_, parts_);
  });
  last_run_ = Hdf5File::open(folder_ + "/run.h5");
}

RowCounts ResultsWriter::rows() const noexcept {
  RowCounts sum = rows_of(parts_);
  for (std::size_t t = 0; t < kRowTables; ++t) sum[t] += buffers_[t].rows();
  return sum;
}

}  // namespace voussoir::io
