// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "io/output/results/results.h"

/// A synthetic run of two cubes whose every number follows from its row, so that any prefix can be checked.
namespace voussoir::io::test {

/// A folder that goes with its owner.
class TempFolder {
 public:
  TempFolder() {
    // In memory where possible: the tests sync hundreds of files.
    const std::filesystem::path memory = "/dev/shm";
    std::string name = ((std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path()) / "voussoir-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  ~TempFolder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

inline geometry::Polyhedron box(Vec3 a, Vec3 b) {
  return {{{a.x, a.y, a.z},
           {b.x, a.y, a.z},
           {b.x, b.y, a.z},
           {a.x, b.y, a.z},
           {a.x, a.y, b.z},
           {b.x, a.y, b.z},
           {b.x, b.y, b.z},
           {a.x, b.y, b.z}},
          {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
}

/// Two cubes of 0.1 m side by side, glued along x; the first stands in a wall, the second is a block of its own.
inline cases::Model two_cubes() {
  cases::Model m;
  m.materials = {{"adobe", {1800.0, 9.8e7, 0.25}}};
  m.laws = {{"dry", {}}, {"normal", {1.27e5, 3.04e4, 32.0, 4.9e5, 9.0, 0.01, 9.8e7, 0.25}}};
  for (int i = 0; i < 2; ++i) {
    cases::Block b;
    (i == 0 ? b.tag : b.name) = i == 0 ? "front wall" : "slider";
    b.shape = box({0.1 * i, 0, 0}, {0.1 * i + 0.1, 0.1, 0.1});
    b.fixed = i == 1;
    m.blocks.push_back(b);
    geometry::Element e;
    e.first_face = 6 * i;
    e.face_count = 6;
    e.mass.volume = 1e-3;
    e.mass.centroid = {0.05 + 0.1 * i, 0.05, 0.05};
    e.mass.principal = {1e-5 / 6, 1e-5 / 6, 1e-5 / 6};
    m.assembly.elements.push_back(e);
    for (int f = 0; f < 6; ++f) {
      const double sign = f % 2 == 0 ? -1 : 1;
      m.assembly.faces.push_back({{f / 2 == 0 ? sign : 0, f / 2 == 1 ? sign : 0, f / 2 == 2 ? sign : 0}, 0.0, 0.05, 0.01});
    }
  }
  geometry::Joint j;
  j.element_a = 0, j.face_a = 1, j.element_b = 1, j.face_b = 0;
  j.area = 0.01;
  j.centre = {0.1, 0.05, 0.05};
  static const geometry::FrameAxes kAxes{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  j.axes = &kAxes;
  m.assembly.joints.push_back(j);
  m.joint_law = {1};
  return m;
}

inline const std::vector<std::string> kNames{"top", "corner 2, 50 % %s"};
inline const std::string kCase = "title = \"two cubes\"\n";

/// The last number of the first cube's quaternion; that of the next row is the first one.
inline float turn_of(std::uint64_t row) { return row % 2 == 0 ? 0.6F : 0.8F; }
inline double time_of(std::uint64_t row) { return -0.01 + 0.001 * static_cast<double>(row); }

/// Row `i` of every table; two cracks a row.
inline void record(solver::Recorder& r, std::uint64_t i) {
  const double t = time_of(i), x = static_cast<double>(i);
  r.history(t, std::array<solver::HistorySample, 2>{{{{x, 1, 2}, {3, x, 5}, {6, 7, x}}, {{-x, 0, 0}, {0, -x, 0}, {0, 0, -x}}}});
  r.energy({t, x, 2 * x, 3 * x, 4 * x, 5 * x, 6 * x, 7 * x, 8 * x, 9 * x, 1e-6 * x});
  r.forces({t, {x, 10, 20}, {30, x, 50}});
  const auto n = static_cast<std::int64_t>(i);
  r.damage({t, 1000 - n, n, 2 * n, 3 * n, 4 * n, {5 * n, 6 * n, 7 * n}});
  const auto k = static_cast<std::int32_t>(i);
  const solver::CrackRow crack{t,    0, k % 2, -1, {x, 0, 1}, {0, 0, 1}, 0.5 * x, solver::FailureMode::tension, solver::FailureMode::shear,
                               t - 1};
  r.cracks(std::array{crack, crack});
  const auto f = static_cast<float>(i);
  const std::array<float, 6> displacement{f, 1, 2, 3, 4, -f};
  const std::array<float, 8> quaternion{turn_of(i + 1), 0, 0, turn_of(i), 0, 1, 0, 0};
  const std::array<float, 2> broken{f, 0.5F};
  r.frame({t, displacement, quaternion, broken});
}

/// Checks every number of a run.h5 and that all tables agree; returns the rows.
inline std::uint64_t check_rows(const std::string& run) {
  const Hdf5File file = Hdf5File::open(run);
  const std::vector<double> time = file.read<double>("/history/time");
  const std::uint64_t n = time.size();
  const auto top = file.read<double>("/history/top/displacement"), corner = file.read<double>("/history/corner 2, 50 % %s/rotation");
  const auto kinetic = file.read<double>("/energy/kinetic"), residual = file.read<double>("/energy/residual");
  const auto shear = file.read<double>("/forces/base_shear");
  const auto bonded = file.read<std::int64_t>("/damage/bonded"), compression = file.read<std::int64_t>("/damage/compression");
  const auto from = file.read<std::int32_t>("/cracks/element_a"), other = file.read<std::int32_t>("/cracks/element_b");
  const auto mode = file.read<std::uint8_t>("/cracks/mode"), first_mode = file.read<std::uint8_t>("/cracks/first_mode");
  const auto crack_time = file.read<double>("/cracks/time"), first_time = file.read<double>("/cracks/first_time");
  const auto moved = file.read<float>("/frames/displacement"), quaternion = file.read<float>("/frames/quaternion");
  REQUIRE(corner.size() == 3 * n);
  // A part may end within a time: later tables lag by one row, never lead.
  const std::uint64_t frames = moved.size() / 6;
  REQUIRE(frames <= n);
  REQUIRE(n <= frames + 1);
  REQUIRE(from.size() <= 2 * n);
  REQUIRE(from.size() >= 2 * frames);
  bool same = true;
  for (std::uint64_t i = 0; i < n; ++i) same = same && time[i] == time_of(i) && top[3 * i] == double(i) && corner[3 * i + 2] == -double(i);
  for (std::uint64_t i = 0; i < frames; ++i) {
    const auto x = static_cast<double>(i);
    same = same && kinetic[i] == x && residual[i] == 1e-6 * x && shear[3 * i] == x && shear[3 * i + 2] == 20;
    same = same && bonded[i] == 1000 - std::int64_t(i) && compression[i] == 4 * std::int64_t(i);
    same = same && moved[6 * i] == float(i) && moved[6 * i + 5] == -float(i) && quaternion[8 * i + 3] == turn_of(i);
  }
  for (std::uint64_t i = 0; i < from.size(); ++i)
    same = same && from[i] == std::int32_t(i / 2 % 2) && other[i] == -1 && mode[i] == 1 && first_mode[i] == 2 &&
           crack_time[i] == time_of(i / 2) && first_time[i] == time_of(i / 2) - 1;
  CHECK(same);
  return n;
}

inline ResultsOptions by_hand() {
  ResultsOptions o;
  o.interval = 1e9;
  return o;
}

/// Files of a folder, its subfolders' with their paths.
inline std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.insert(std::filesystem::relative(entry.path(), folder).string());
  return names;
}

}  // namespace voussoir::io::test
