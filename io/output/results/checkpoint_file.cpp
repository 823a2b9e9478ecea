// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/checkpoint_file.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr const char* kWhat = "voussoir checkpoint";
constexpr std::array kAxes{"x", "y", "z"};
constexpr std::array kFactors{"first_factor", "second_factor", "third_factor"};  // of the components of the record

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
  file.write_dataset("/case/origin", Hdf5Type::f64, {3}, &facts.origin, {}, {"m", "of the model, in the axes of the case"});
}

void write_motion(Hdf5File& file, const cases::GroundMotion& motion) {
  file.make_group("/motion");
  for (std::size_t i = 0; i < kFactors.size(); ++i) file.set_attribute("/motion", kFactors[i], motion.factor[i]);
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
    if (!h.rotation.empty())
      file.write_dataset(at + "/rotation", Hdf5Type::f64, {h.time.size(), 3}, h.rotation.data(), {}, {"rad", "of the support"});
    file.set_attribute(at, "open_ended", std::int64_t{h.open_ended});
  }
}

void write_stones(Hdf5File& file, const StoneTables& stones) {
  const PackedStones packed = packed_stones(stones);
  file.write_dataset("/stones/numbers", Hdf5Type::i32, {packed.numbers.size()}, packed.numbers.data(), {},
                     {"1", "see checkpoint_stones.h"});
  file.write_dataset("/stones/vertices", Hdf5Type::f64, {packed.vertices.size()}, packed.vertices.data(), {}, {"m", "three each"});
  file.write_strings("/stones/texts", packed.texts, {"1", "names and groups"});
}

/// Entries [first, first + count) of a field. \pre first is a multiple of the group size
solver::Field part_of(const solver::Field& f, std::size_t first, std::size_t count) {
  solver::Field part = f;
  const std::size_t row = f.columns * size_of(f.type);
  part.data = static_cast<std::byte*>(f.data) + (f.stride == 0 ? first * row : first / f.together * f.stride);
  part.count = count;
  return part;
}

bool is_zero(const std::byte* bytes, std::size_t n) {
  return n == 0 || (bytes[0] == std::byte{0} && std::memcmp(bytes, bytes + 1, n - 1) == 0);
}

/// Writes a field in pieces. Pieces of zeros, such as most of the history of segments, are omitted: a new file reads as zero there.
void write_field(Hdf5File& file, const std::string& name, Hdf5Type type, const solver::Field& f) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;  // bytes, approximately
  const std::size_t row = f.columns * size_of(f.type), at_a_time = (kPiece / row / f.together + 1) * f.together;
  for (std::size_t first = 0; first < f.count; first += at_a_time) {
    const solver::Field part = part_of(f, first, std::min(at_a_time, f.count - first));
    const std::vector<std::byte> values = f.stride != 0 ? packed(part) : std::vector<std::byte>{};
    const std::byte* data = f.stride != 0 ? values.data() : static_cast<const std::byte*>(part.data);
    const bool last = first + part.count == f.count;  // always written: with it HDF5 reserves the whole dataset
    if (last || !is_zero(data, part.bytes())) file.write_rows(name, type, first, part.count, data);
  }
}

void write_state(Hdf5File& file, std::span<const solver::Field> state) {
  for (const solver::Field& f : state) {
    const std::string name = std::string("/state/") + f.name;
    const Hdf5Type type = hdf5_type(f.type);
    const Shape shape = f.columns == 1 ? Shape{f.count} : Shape{f.count, f.columns};
    file.create_dataset(name, type, shape, {}, {f.unit, std::string("one entry each: ") + f.shape});
    write_field(file, name, type, f);
  }
}

/// Upper bound on the size of the file in bytes.
std::uint64_t room_for(const CheckpointFacts& facts, std::span<const solver::Field> state) {
  constexpr std::uint64_t kStructure = 256 << 10, kOfDataset = 2048;  // overhead of HDF5
  std::uint64_t bytes = kStructure + facts.case_toml.size();
  for (const solver::Field& f : state) bytes += f.bytes() + kOfDataset;
  for (const cases::Accelerogram& a : facts.motion.axis) bytes += a.acceleration.size() * sizeof(double);
  for (const cases::SupportHistory& h : facts.supports) bytes += (h.time.size() * 4 + h.rotation.size() * 3) * sizeof(double) + kOfDataset;
  return bytes;
}

/// Reads checkpoints. Memory is allocated only up to the size of the file, whatever the datasets claim.
class Reader {
 public:
  /// \param bytes  size of the file
  Reader(const Hdf5File& file, std::uint64_t bytes) : file_(file), left_(bytes) {}

  [[nodiscard]] CheckpointFacts facts() {
    CheckpointFacts f;
    const std::string kernels = file_.attribute_text("/", "kernels");
    if (kernels != "fast" && kernels != "reference") fault("attribute kernels is neither fast nor reference");
    f.reference_kernels = kernels == "reference";
    f.program = file_.attribute_text("/", "program");
    const std::string hash = file_.attribute_text("/", "model_hash");
    if (std::sscanf(hash.c_str(), "%" SCNx64, &f.model_hash) != 1) fault("attribute model_hash is no hash");
    f.step = file_.attribute_double("/", "step");
    if (!std::isfinite(f.step) || f.step <= 0.0) fault("attribute step is no step");
    f.time = file_.attribute_double("/", "time");
    if (!std::isfinite(f.time)) fault("attribute time is no time");
    for (std::size_t t = 0; t < kRowTables; ++t)
      f.rows[t] = static_cast<std::uint64_t>(file_.attribute_int("/", std::string("rows_") + table_name(static_cast<RowTable>(t))));
    f.case_toml = toml();
    f.origin = origin();
    f.motion = motion();
    f.supports = supports();
    if (file_.exists("/stones")) f.stones = stones();
    return f;
  }

  [[nodiscard]] solver::SavedState state() {
    solver::SavedState state;
    for (const std::string& name : file_.children("/state")) state[name] = field("/state/" + name);
    return state;
  }

 private:
  [[noreturn]] void fault(const std::string& what) const { throw DamagedFile(file_.path(), what); }

  /// Deducts the size of a dataset from the unclaimed bytes, as every byte of the file is in at most one dataset. \throw if there are not
  /// enough
  void claim(const std::string& name, std::uint64_t bytes) {
    if (bytes > left_) fault(name + " claims more than the file has");
    left_ -= bytes;
  }

  [[nodiscard]] static solver::FieldType field_type(Hdf5Type t) {
    using enum solver::FieldType;
    return t == Hdf5Type::f64 ? f64 : t == Hdf5Type::i64 ? i64 : t == Hdf5Type::i32 ? i32 : u8;
  }

  [[nodiscard]] solver::SavedField field(const std::string& name) {
    const Hdf5Dataset d = file_.describe(name);
    if (!d.type || *d.type == Hdf5Type::f32 || d.shape.empty() || d.shape.size() > 2) fault(name + " is no field");
    claim(name, d.stored);
    if (d.stored != d.claimed) fault(name + " has not the bytes it claims");
    solver::SavedField f{field_type(*d.type), d.shape[0], d.shape.size() == 2 ? d.shape[1] : 1, std::vector<std::byte>(d.stored)};
    file_.read_rows(name, *d.type, 0, f.count, f.bytes.data());
    return f;
  }

  /// Reads finite numbers.
  [[nodiscard]] std::vector<double> numbers(const std::string& name, std::uint64_t columns) {
    const solver::SavedField f = field(name);
    if (f.type != solver::FieldType::f64 || f.columns != columns) fault(name + " is no list of numbers");
    std::vector<double> values(f.bytes.size() / sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), f.bytes.data(), f.bytes.size());
    if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) fault(name + " holds what is no finite number");
    return values;
  }

  [[nodiscard]] StoneTables stones() {
    PackedStones packed;
    const solver::SavedField numbers_field = field("/stones/numbers");
    if (numbers_field.type != solver::FieldType::i32 || numbers_field.columns != 1) fault("/stones/numbers is no list of whole numbers");
    packed.numbers.resize(numbers_field.bytes.size() / sizeof(std::int32_t));
    if (!packed.numbers.empty()) std::memcpy(packed.numbers.data(), numbers_field.bytes.data(), numbers_field.bytes.size());
    packed.vertices = numbers("/stones/vertices", 1);
    claim("/stones/texts", file_.describe("/stones/texts").claimed);
    packed.texts = file_.read_strings("/stones/texts");
    std::optional<StoneTables> tables = unpacked_stones(packed);
    if (!tables) fault("/stones does not fit together");
    return *std::move(tables);
  }

  /// Checkpoints of programs that had none hold no origin: theirs was zero.
  [[nodiscard]] Vec3 origin() {
    if (!file_.exists("/case/origin")) return {};
    const std::vector<double> at = numbers("/case/origin", 1);
    if (at.size() != 3) fault("/case/origin is no point");
    return {at[0], at[1], at[2]};
  }

  [[nodiscard]] std::string toml() {
    claim("/case/toml", file_.describe("/case/toml").claimed);
    const std::vector<std::string> toml = file_.read_strings("/case/toml");
    if (toml.size() != 1) fault("/case/toml is not one text");
    return toml[0];
  }

  [[nodiscard]] cases::GroundMotion motion() {
    cases::GroundMotion m;
    if (file_.has_attribute("/motion", "factor")) m.factor.fill(file_.attribute_double("/motion", "factor"));  // one, in older files
    for (std::size_t i = 0; i < kFactors.size(); ++i) {
      if (file_.has_attribute("/motion", kFactors[i])) m.factor[i] = file_.attribute_double("/motion", kFactors[i]);
    }
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const std::string name = std::string("/motion/") + kAxes[i];
      m.axis[i] = {file_.attribute_text(name, "name"), file_.attribute_double(name, "dt"), numbers(name, 1)};
      const double dt = m.axis[i].dt;
      if (!std::isfinite(dt) || (dt <= 0.0 && !m.axis[i].acceleration.empty())) fault("attribute dt of " + name + " is no step");
    }
    return m;
  }

  [[nodiscard]] std::vector<cases::SupportHistory> supports() {
    std::vector<cases::SupportHistory> all(file_.children("/support").size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string at = numbered("/support", i);
      all[i].time = numbers(at + "/time", 1);
      const std::vector<double> flat = numbers(at + "/displacement", 3);
      if (flat.size() != 3 * all[i].time.size()) fault(at + "/displacement has another number of samples than its time");
      if (all[i].time.size() == 1 || std::ranges::adjacent_find(all[i].time, std::greater_equal<>()) != all[i].time.end())
        fault(at + "/time has a single sample, or does not rise");
      for (std::size_t k = 0; k < flat.size(); k += 3) all[i].displacement.push_back({flat[k], flat[k + 1], flat[k + 2]});
      if (file_.exists(at + "/rotation")) {
        const std::vector<double> turns = numbers(at + "/rotation", 3);
        if (turns.size() != flat.size()) fault(at + "/rotation has another number of samples than its time");
        for (std::size_t k = 0; k < turns.size(); k += 3) all[i].rotation.push_back({turns[k], turns[k + 1], turns[k + 2]});
      }
      all[i].open_ended = file_.attribute_int(at, "open_ended") != 0;
    }
    return all;
  }

  const Hdf5File& file_;
  std::uint64_t left_;  // bytes of the file not yet claimed
};

}  // namespace

void write_checkpoint(const std::string& path, const CheckpointFacts& facts, std::span<const solver::Field> state) {
  SealedFile sealed(path, room_for(facts, state));
  Hdf5File& file = sealed.contents();
  write_facts(file, facts);
  write_motion(file, facts.motion);
  write_supports(file, facts.supports);
  if (!facts.stones.empty()) write_stones(file, facts.stones);
  write_state(file, state);
  sealed.seal(kWhat, kCheckpointSchema);
}

namespace {

/// \param bytes  size of the file
Checkpoint parse(const Hdf5File& file, std::uint64_t bytes) {
  const std::string& name = file.path();
  if (!file.has_attribute("/", "format") || file.attribute_text("/", "format") != kWhat)
    throw DamagedFile(name, std::string("is no ") + kWhat);
  const std::int64_t physics = file.attribute_int("/", "physics_version");
  if (physics != solver::kPhysicsVersion) {
    throw FileError(name, "was computed by version " + std::to_string(physics) + " of the physics; this program has version " +
                              std::to_string(solver::kPhysicsVersion) + ": go on with the program that began it, or run the case anew");
  }
  Reader reader(file, bytes);
  CheckpointFacts facts = reader.facts();
  return {std::move(facts), reader.state()};
}

}  // namespace

Checkpoint parse_sealed_checkpoint(const std::string& name, std::span<const std::byte> hdf5) {
  return parse(Hdf5File::open_in_memory(name, hdf5), hdf5.size());
}

Checkpoint parse_checkpoint(const std::string& name, std::span<const std::byte> bytes) {
  return parse_sealed_checkpoint(name, unsealed(name, kWhat, {kOldestCheckpointSchema, kCheckpointSchema}, bytes));
}

Checkpoint read_checkpoint(const std::string& path) {
  check_seal(path, kWhat, {kOldestCheckpointSchema, kCheckpointSchema});
  return parse(Hdf5File::open(path), std::filesystem::file_size(path));
}

}  // namespace voussoir::io
