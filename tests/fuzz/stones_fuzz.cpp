// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/polyhedron.h"
#include "io/input/files/errors.h"
#include "io/input/stones/stone_file.h"
#include "io/input/stones/stone_sizes.h"
#include "io/input/stones/stones.h"
#include "tests/fuzz/memory_file.h"

// Files of stones. The first byte chooses the reader (0: by what the file begins with), whether there is a gap, whether stones are
// fitted to planes, and which are fixed.
// Whatever a reader takes has finite corners and faces of them; whatever the import takes is valid convex polyhedra.

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

/// A folder that has a file under two names, as long as this lasts.
class FolderOf {
 public:
  explicit FolderOf(const std::string& file) : path_(file + ".d") {
    std::filesystem::create_directory(path_);
    for (const char* name : {"a.obj", "b.JSON"}) std::filesystem::create_hard_link(file, path_ / name);
  }
  FolderOf(const FolderOf&) = delete;
  FolderOf& operator=(const FolderOf&) = delete;
  ~FolderOf() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

void import(const std::string& path, unsigned choice) {
  cases::Case c;
  cases::StonesSpec spec;
  spec.file = path, spec.unit = choice % 5 == 4 ? "mm" : "m";
  if (choice % 7 == 6) spec.only = {"a"};
  if (choice % 11 == 10) spec.turn.angle = 30.0;
  if (choice % 2 == 1) spec.warped = cases::WarpedFaces::triangles;
  if (choice >= 128) spec.gap = 0.01;
  if (choice % 4 == 3) {
    spec.fit = cases::StoneFit::planes, spec.warped = cases::WarpedFaces::refuse, spec.gap.reset();
    if (choice % 8 == 7) spec.fit_limit = 0.1;
  }
  constexpr cases::StoneSupports::Kind kSupports[] = {cases::StoneSupports::Kind::automatic, cases::StoneSupports::Kind::ground,
                                                      cases::StoneSupports::Kind::none, cases::StoneSupports::Kind::below,
                                                      cases::StoneSupports::Kind::named};
  spec.supports.kind = kSupports[choice / 6 % std::size(kSupports)];
  spec.supports.level = 0.5;
  spec.supports.names = {"a"};
  c.stones.push_back(spec);
  if (choice % 3 == 2) return static_cast<void>(io::load_shown_stones(c));
  io::load_stones(c);
  static_cast<void>(io::unusual_sizes(c));
  for (const cases::Stone& s : c.stones[0].stones) {
    for (const cases::StonePiece& p : s.pieces) geometry::validate(p.shape);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::MemoryFile file;
  static const FolderOf folder(file.path());
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  constexpr io::StoneFile (*kReaders[])(const std::string&, std::string_view) = {io::read_stone_file, io::read_obj, io::read_ply,
                                                                                 io::read_stl,        io::read_vtu, io::read_compas};
  try {
    check(kReaders[data[0] % 6](std::string("fuzz"), text));
    file.fill(data + 1, size - 1);
    import(data[0] % 13 == 12 ? folder.path() : file.path(), data[0]);
  } catch (const io::FileError&) {
  } catch (const cases::InputError&) {
  }
  return 0;
}
