// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>

#include "io/input/case_file/case_file.h"
#include "io/output/measures/measures.h"
#include "tests/io/results_fixture.h"

/// Runs of a small house whose frames say where its elements have gone, for tests of measures.
namespace voussoir::io::test {

inline Measures measures_of(const TempFolder& folder) { return measure(Hdf5File::open(folder.file("run.h5"))); }

/// A hut of 1.0 x 0.8 m inside and 0.4 m high, walls of 0.2 m, under a flat roof.
constexpr const char* kHut = R"(title = "a hut"
[materials.adobe]
density = 1800.0
young = 9.8e7
poisson = 0.25
[materials.wood]
density = 700.0
young = 6.3e8
poisson = 0.3
[joint_laws.normal]
tension = 1.27e5
cohesion = 3.04e4
friction = 32.0
compression = 4.9e5
[joints]
default = "normal"
[house]
inner_size = [1.0, 0.8]
height = 0.4
wood = { material = "wood", within_member = "normal", between_members = "normal" }
roof = { kind = "flat" }
[base]
z = 0.0
)";

/// A run of the hut whose frames say where its elements have gone.
class Hut {
 public:
  using Move = std::function<Vec3(std::size_t element, Vec3 centroid)>;

  explicit Hut(const std::string& text = kHut)
      : model_(cases::build_model(read_case({"hut.toml", text}).value)), results_(folder_.path(), model_, text, kNames, {}, by_hand()) {}

  void frame(double time, const Move& move) {
    std::vector<float> displacement, quaternion;
    for (std::size_t e = 0; e < model_.blocks.size(); ++e) {
      const Vec3 u = move(e, centroid(e)) - centroid(e);
      for (const double v : {u.x, u.y, u.z}) displacement.push_back(static_cast<float>(v));
      for (const float q : {1.0F, 0.0F, 0.0F, 0.0F}) quaternion.push_back(q);
    }
    results_.frame({time, displacement, quaternion, std::vector<float>(model_.blocks.size())});
  }
  void crack_whole_joint(double time, std::size_t joint) {
    const geometry::Joint& j = model_.assembly.joints[joint];
    const solver::CrackRow row{time,
                               static_cast<std::int32_t>(joint),
                               j.element_a,
                               j.element_b,
                               {},
                               {},
                               j.area,
                               solver::FailureMode::tension,
                               solver::FailureMode::tension,
                               time};
    results_.cracks(std::array{row});
  }
  Measures measures() {
    results_.finish();
    return measures_of(folder_);
  }
  [[nodiscard]] Vec3 centroid(std::size_t e) const { return model_.assembly.elements[e].mass.centroid; }
  [[nodiscard]] const std::string& tag(std::size_t e) const { return model_.blocks[e].tag; }
  [[nodiscard]] bool is_beam(std::size_t e) const { return model_.blocks[e].kind == cases::PartKind::beam; }
  [[nodiscard]] const cases::Model& model() const { return model_; }
  ResultsWriter& results() { return results_; }
  [[nodiscard]] std::string file() const { return folder_.file("run.h5"); }

 private:
  TempFolder folder_;
  cases::Model model_;
  ResultsWriter results_;
};

inline const WallMeasures& wall(const Measures& m, const std::string& name) {
  const auto at = std::ranges::find(m.walls, name, &WallMeasures::name);
  REQUIRE(at != m.walls.end());
  return *at;
}

inline Vec3 stays(std::size_t, Vec3 x) { return x; }

}  // namespace voussoir::io::test
