// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "cases/case.h"
#include "cases/model.h"
#include "io/input/case_file/case_file.h"

namespace voussoir {
namespace {

struct Building {
  const char* name;
  std::size_t blocks;
  double mass;     // kg, by areas of polygons (scripts/real_buildings/masses.py)
  double differs;  // relative: straight blocks in a curved wall have less volume than its line
};

}  // namespace

TEST_CASE("the five real buildings are accepted, with their blocks and their mass by polygons") {
  for (const Building& b : {Building{"farmhouse", 5414, 262328.8, 1e-6},
                            {"row", 4267, 118139.6, 1e-6},
                            {"tower", 3387, 1427718.1, 1e-6},
                            {"church", 3509, 431783.5, 3e-3},
                            {"apsidal", 2024, 238465.4, 3e-3}}) {
    CAPTURE(b.name);
    const cases::Model m =
        cases::build_model(io::load_case(std::string(VOUSSOIR_SOURCE_DIR "/cases/catalogue/studies/buildings/") + b.name + ".toml").value);
    double mass = 0.0;
    for (std::size_t i = 0; i < m.blocks.size(); ++i)
      mass += m.assembly.elements[i].mass.volume * m.materials[static_cast<std::size_t>(m.blocks[i].material)].value.density;
    CHECK(m.blocks.size() == b.blocks);
    CHECK(mass == doctest::Approx(b.mass).epsilon(b.differs));
  }
}

}  // namespace voussoir
