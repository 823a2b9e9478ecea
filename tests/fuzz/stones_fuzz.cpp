// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/polyhedron.h"
#include "io/input/files/errors.h"
#include "io/input/stones/stone_file.h"
#include "io/input/stones/stones.h"
#include "tests/fuzz/memory_file.h"

// Files of stones. The first byte chooses the reader (0: by what the file begins with) and whether there is a gap. Whatever a reader takes
// has finite corners and faces of them; whatever the import takes is valid convex polyhedra.

namespace {

using namespace voussoir;

void check(const io::StoneFile& file) {
  for (const io::FileSolid& s : file.solids) {
    for (const Vec3& v : s.mesh.vertices) {
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) std::abort();
    }
    for (const auto& loop : s.mesh.faces) {
      if (loop.size() < 3) std::abort();
      for (const std::int32_t v : loop) {
        if (v < 0 || static_cast<std::size_t>(v) >= s.mesh.vertices.size()) std::abort();
      }
    }
  }
}

void import(const std::string& path, bool gap) {
  cases::Case c;
  cases::StonesSpec spec;
  spec.file = path, spec.unit = "m";
  if (gap) spec.gap = 0.01;
  c.stones.push_back(spec);
  io::load_stones(c);
  for (const cases::Stone& s : c.stones[0].stones) {
    for (const cases::StonePiece& p : s.pieces) geometry::validate(p.shape);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::MemoryFile file;
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  constexpr io::StoneFile (*kReaders[])(const std::string&, std::string_view) = {io::read_stone_file, io::read_obj, io::read_ply,
                                                                                 io::read_stl,        io::read_vtu, io::read_compas};
  try {
    check(kReaders[data[0] % 6](std::string("fuzz"), text));
    file.fill(data + 1, size - 1);
    import(file.path(), data[0] >= 128);
  } catch (const io::FileError&) {
  } catch (const cases::InputError&) {
  }
  return 0;
}
