// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/checkpoint_file.h"

#include <array>
#include <cinttypes>
#include <cstdio>

#include "io/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr const char* kWhat = "voussoir checkpoint";
constexpr std::array kAxes{"x", "y", "z"};

Hdf5Type hdf5_type(solver::FieldType t) {
  using enum solver::FieldType;
  return t == f64 ? Hdf5Type::f64 : t == i64 ? Hdf5Type::i64 : t == i32 ? Hdf5Type::i32 : Hdf5Type::u8;
}

std::string hex(std::uint64_t value) {
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, value);
  return text.data();
}

std::string numbered(const char* group, std::size_t i) { return std::string(group) + "/" + std::to_string(i); }

void write_facts(Hdf5File& file, const CheckpointFacts& facts) {
  file.set_attribute("/", "format", std::string(kWhat));
  file.set_attribute("/", "physics_version", solver::kPhysicsVersion);
  file.set_attribute("/", "program", facts.program);
  file.set_attribute("/", "model_hash", hex(facts.model_hash));
  file.set_attribute("/", "kernels", std::string(facts.reference_kernels ? "reference" : "fast"));
  file.set_attribute("/", "step", facts.step);
  file.set_attribute("/", "time", facts.time);
  for (std::size_t t = 0; t < kRowTables; ++t) {
    file.set_attribute("/", std::string("rows_") + table_name(static_cast<RowTable>(t)), static_cast<std::int64_t>(facts.rows[t]));
  }
  file.write_strings("/case/toml", {&facts.case_toml, 1}, {"1", "the resolved case"});
}

void write_motion(Hdf5File& file, const cases::GroundMotion& motion) {
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    const cases::Accelerogram& a = motion.axis[i];
    const std::string name = std::string("/motion/") + kAxes[i];
    file.write_dataset(name, Hdf5Type::f64, {a.acceleration.size()}, a.acceleration.data(), {}, {"m/s2", "acceleration of the base"});
    file.set_attribute(name, "dt", a.dt);
    file.set_attribute(name, "name", a.name);
  }
}

void write_supports(Hdf5File& file, const std::vector<cases::SupportHistory>& supports) {
  file.make_group("/support");
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const cases::SupportHistory& h = supports[i];
    const std::string at = numbered("/support", i);
    file.write_dataset(at + "/time", Hdf5Type::f64, {h.time.size()}, h.time.data(), {}, {"s", "of the samples"});
    file.write_dataset(at + "/displacement", Hdf5Type::f64, {h.time.size(), 3}, h.displacement.data(), {}, {"m", "of the support"});
    file.set_attribute(at, "open_ended", std::int64_t{h.open_ended});
  }
}

void write_state(Hdf5File& file, std::span<const solver::Field> state) {
  for (const solver::Field& f : state) {
    const Shape shape = f.columns == 1 ? Shape{f.count} : Shape{f.count, f.columns};
    file.write_dataset(std::string("/state/") + f.name, hdf5_type(f.type), shape, f.data, {},
                       {f.unit, std::string("one entry each: ") + f.shape});
  }
}

/// Reads what the writers above wrote. Room is made only for what the file really holds.
class Reader {
 public:
  Reader(const Hdf5File& file, std::size_t bytes) : file_(file), bytes_(bytes) {}

  [[nodiscard]] CheckpointFacts facts() const {
    CheckpointFacts f;
    const std::string kernels = file_.attribute_text("/", "kernels");
    if (kernels != "fast" && kernels != "reference") fault("attribute kernels is neither fast nor reference");
    f.reference_kernels = kernels == "reference";
    f.program = file_.attribute_text("/", "program");
    const std::string hash = file_.attribute_text("/", "model_hash");
    if (std::sscanf(hash.c_str(), "%" SCNx64, &f.model_hash) != 1) fault("attribute model_hash is no hash");
    f.step = file_.attribute_double("/", "step");
    f.time = file_.attribute_double("/", "time");
    for (std::size_t t = 0; t < kRowTables; ++t)
      f.rows[t] = static_cast<std::uint64_t>(file_.attribute_int("/", std::string("rows_") + table_name(static_cast<RowTable>(t))));
    if (file_.stored_bytes("/case/toml") > bytes_) fault("/case/toml claims more than the file has");
    const std::vector<std::string> toml = file_.read_strings("/case/toml");
    if (toml.size() != 1) fault("/case/toml is not one text");
    f.case_toml = toml[0];
    f.motion = motion();
    f.supports = supports();
    return f;
  }

  [[nodiscard]] solver::SavedState state() const {
    solver::SavedState state;
    for (const std::string& name : file_.children("/state")) state[name] = field("/state/" + name);
    return state;
  }

 private:
  [[noreturn]] void fault(const std::string& what) const { throw DamagedFile(file_.path(), what); }

  [[nodiscard]] static solver::FieldType field_type(Hdf5Type t) {
    using enum solver::FieldType;
    return t == Hdf5Type::f64 ? f64 : t == Hdf5Type::i64 ? i64 : t == Hdf5Type::i32 ? i32 : u8;
  }

  [[nodiscard]] solver::SavedField field(const std::string& name) const {
    const Shape shape = file_.shape(name);
    const Hdf5Type type = file_.type(name);
    if (shape.empty() || shape.size() > 2 || type == Hdf5Type::f32 || type == Hdf5Type::i8) fault(name + " is no field");
    solver::SavedField f{field_type(type), shape[0], shape.size() == 2 ? shape[1] : 1, {}};
    const std::uint64_t stored = file_.stored_bytes(name), row = f.columns * size_of(type);
    if (f.columns > bytes_ || stored > bytes_ || f.count > bytes_ || stored != f.count * row) fault(name + " has not the bytes it claims");
    f.bytes.resize(stored);
    file_.read_rows(name, type, 0, f.count, f.bytes.data());
    return f;
  }

  [[nodiscard]] std::vector<double> numbers(const std::string& name, std::uint64_t columns) const {
    const solver::SavedField f = field(name);
    if (f.type != solver::FieldType::f64 || f.columns != columns) fault(name + " is no list of numbers");
    return file_.read<double>(name);
  }

  [[nodiscard]] cases::GroundMotion motion() const {
    cases::GroundMotion m;
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const std::string name = std::string("/motion/") + kAxes[i];
      m.axis[i] = {file_.attribute_text(name, "name"), file_.attribute_double(name, "dt"), numbers(name, 1)};
    }
    return m;
  }

  [[nodiscard]] std::vector<cases::SupportHistory> supports() const {
    std::vector<cases::SupportHistory> all(file_.children("/support").size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string at = numbered("/support", i);
      all[i].time = numbers(at + "/time", 1);
      const std::vector<double> flat = numbers(at + "/displacement", 3);
      if (flat.size() != 3 * all[i].time.size()) fault(at + "/displacement has another number of samples than its time");
      for (std::size_t k = 0; k < flat.size(); k += 3) all[i].displacement.push_back({flat[k], flat[k + 1], flat[k + 2]});
      all[i].open_ended = file_.attribute_int(at, "open_ended") != 0;
    }
    return all;
  }

  const Hdf5File& file_;
  std::size_t bytes_;  // of the file: nothing in it can be larger
};

}  // namespace

void write_checkpoint(const std::string& path, const CheckpointFacts& facts, std::span<const solver::Field> state) {
  Hdf5File file = Hdf5File::create_in_memory(path);
  write_facts(file, facts);
  write_motion(file, facts.motion);
  write_supports(file, facts.supports);
  write_state(file, state);
  write_sealed(path, kWhat, kCheckpointSchema, file.image());
}

Checkpoint parse_sealed_checkpoint(const std::string& name, std::span<const std::byte> hdf5) {
  const Hdf5File file = Hdf5File::open_in_memory(name, hdf5);
  if (!file.has_attribute("/", "format") || file.attribute_text("/", "format") != kWhat)
    throw DamagedFile(name, std::string("is no ") + kWhat);
  const std::int64_t physics = file.attribute_int("/", "physics_version");
  if (physics != solver::kPhysicsVersion) {
    throw FileError(name, "was computed by version " + std::to_string(physics) + " of the physics; this program has version " +
                              std::to_string(solver::kPhysicsVersion) + ": go on with the program that began it, or run the case anew");
  }
  const Reader reader(file, hdf5.size());
  return {reader.facts(), reader.state()};
}

Checkpoint parse_checkpoint(const std::string& name, std::span<const std::byte> bytes) {
  return parse_sealed_checkpoint(name, unsealed(name, kWhat, kCheckpointSchema, bytes));
}

Checkpoint read_checkpoint(const std::string& path) { return parse_checkpoint(path, read_bytes(path)); }

}  // namespace voussoir::io
