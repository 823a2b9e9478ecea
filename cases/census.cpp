// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/census.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "cases/case.h"
#include "geometry/nth.h"
#include "geometry/prism.h"

namespace voussoir::cases {
namespace {

constexpr double kLess = 1.0 - 1e-9;  // share of a bound: round-off must not make one of many equal bricks, or faces, the limiting one

/// The group of a block: "roof beam 12" and "roof beam 3" are in one group.
std::string group_name(const Model& model, const Block& block) {
  if (block.wall >= 0) return block.tag;
  if (block.house < 0 && block.span < 0 && block.vault < 0) return "blocks of " + nth(model.materials, block.material).name;
  if (block.tag.find(", storey ") != std::string::npos) return block.tag;
  const std::size_t last = block.tag.find_last_not_of("0123456789");
  const bool numbered = last != std::string::npos && last + 1 < block.tag.size() && block.tag[last] == ' ';
  return numbered ? block.tag.substr(0, last) : block.tag;
}

/// Indices of blocks: houses part by part in building order, then free blocks.
std::vector<std::size_t> as_built(const std::vector<Block>& blocks) {
  std::vector<std::size_t> order(blocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return static_cast<std::uint32_t>(blocks[i].built); });  // −1 is last
  return order;
}

void count_blocks(const Model& model, Census& result) {
  std::map<std::string, std::size_t> index;
  std::vector<bool> counted(static_cast<std::size_t>(model.units), false);
  for (const std::size_t i : as_built(model.blocks)) {
    const Block& block = model.blocks[i];
    const std::string name = group_name(model, block);
    const auto [at, added] = index.emplace(name, result.groups.size());
    if (added) result.groups.push_back({name});
    CensusGroup& group = result.groups[at->second];
    const double volume = model.assembly.elements[i].mass.volume;
    const double mass = volume * nth(model.materials, block.material).value.density;
    if (block.unit < 0 || !counted[static_cast<std::size_t>(block.unit)]) ++(block.whole ? group.whole : group.cut);
    if (block.unit >= 0) counted[static_cast<std::size_t>(block.unit)] = true;
    group.volume += volume;
    group.mass += mass;
    if (block.fixed) {
      result.fixed_mass += mass;
    } else {
      result.volume += volume;
      result.mass += mass;
    }
  }
}

/// A block in one piece, or all cells of a unit.
struct Piece {
  const Block* block;  // of several cells, the first
  geometry::Box3 box;
  double volume = 0.0;  // m3
};

std::vector<Piece> pieces_of(const Model& model) {
  std::vector<Piece> pieces;
  std::vector<std::size_t> of_unit(static_cast<std::size_t>(model.units), model.blocks.size());
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& block = model.blocks[i];
    const geometry::Box3 box = geometry::bounds(block.shape);
    const double volume = model.assembly.elements[i].mass.volume;
    std::size_t at = block.unit < 0 ? model.blocks.size() : nth(of_unit, block.unit);
    if (at == model.blocks.size()) {
      if (block.unit >= 0) nth(of_unit, block.unit) = pieces.size();
      pieces.push_back({&block, box, volume});
      continue;
    }
    Piece& p = pieces[at];
    p.box.low = {std::min(p.box.low.x, box.low.x), std::min(p.box.low.y, box.low.y), std::min(p.box.low.z, box.low.z)};
    p.box.high = {std::max(p.box.high.x, box.high.x), std::max(p.box.high.y, box.high.y), std::max(p.box.high.z, box.high.z)};
    p.volume += volume;
  }
  return pieces;
}

/// Edge lengths [m] rounded to the micrometre, descending; zeros if it is no box.
std::array<double, 3> box_edges(const Piece& piece) {
  const Vec3 size = piece.box.high - piece.box.low;
  if (piece.block->shape.vertices.size() != 8 || std::abs(size.x * size.y * size.z / piece.volume - 1.0) > 1e-6) return {};
  std::array edges{size.x, size.y, size.z};
  for (double& e : edges) e = std::round(e * 1e6) * 1e-6;
  std::sort(edges.begin(), edges.end(), std::greater<>());
  return edges;
}

void write_bill(const Model& model, Census& result) {
  using Key = std::tuple<PartKind, std::int32_t, bool, std::array<double, 3>, std::int32_t, std::int32_t>;
  std::map<Key, BillLine> lines;
  for (const Piece& piece : pieces_of(model)) {
    const Block& block = *piece.block;
    const std::array<double, 3> edges = box_edges(piece);
    const bool box = edges[0] > 0.0, prism = !box && geometry::is_prism(block.shape);
    const std::int32_t corners = prism ? static_cast<std::int32_t>(block.shape.vertices.size() / 2) : 0;
    const std::int32_t faces = box || prism ? 0 : static_cast<std::int32_t>(block.shape.faces.size());
    const Key key{block.kind, block.material, !block.whole, {-edges[0], -edges[1], -edges[2]}, corners, faces};
    BillLine& line = lines.try_emplace(key, BillLine{block.kind, block.material, block.whole, edges, corners, faces, 0, 0.0}).first->second;
    ++line.count;
    line.volume += piece.volume;
  }
  for (const auto& [key, line] : lines) result.bill.push_back(line);
}

void count_cells(const Model& model, Census& result) {
  const auto unit = [&](std::int32_t element) { return element == geometry::kBase ? -1 : nth(model.blocks, element).unit; };
  result.units = model.units;
  result.cells = std::ranges::count_if(model.blocks, [](const Block& b) { return b.unit >= 0; });
  result.cell_joints = std::ranges::count_if(
      model.assembly.joints, [&](const geometry::Joint& j) { return unit(j.element_a) >= 0 && unit(j.element_a) == unit(j.element_b); });
}

void count_segments(const geometry::Assembly& assembly, Census& result) {
  for (const geometry::Joint& joint : assembly.joints) {
    const auto side_a = static_cast<std::int64_t>(joint.side_a.size());
    const auto side_b = static_cast<std::int64_t>(joint.side_b.size());
    const bool base = joint.element_b == geometry::kBase;
    ++(base ? result.base_joints : result.joints);
    if (joint.merged && !base) ++result.merged_joints;
    result.joint_sides += joint.merged && !base ? 2 * side_a : side_a + side_b;
    result.joint_area += joint.area;
  }
  for (const geometry::FreePatch& patch : assembly.patches) result.free_segments += static_cast<std::int64_t>(patch.segments.size());
}

void find_step_bound(const Model& model, Census& result) {
  result.step_bound = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (model.blocks[i].fixed) continue;
    const StepBound bound = step_bound(model, i);
    if (bound.step >= result.step_bound * kLess) continue;
    result.step_bound = bound.step;
    result.step_element = static_cast<std::int32_t>(i);
    result.step_face = bound.face;
  }
}

}  // namespace

double frame_interval(const Case& c, std::size_t elements) {
  if (c.output.frame_interval) return *c.output.frame_interval;
  constexpr std::array kSeries{0.02, 0.05, 0.1};  // s; also times 10, 100, ...
  constexpr double kMost = 40e6;                  // elements times frames
  double interval = kSeries[0];
  if (is_assessment(c.analysis)) return interval;
  const auto too_many = [&] { return static_cast<double>(elements) * (std::floor(c.time.duration / interval) + 1.0) > kMost; };
  for (std::size_t k = 1; too_many(); ++k) {
    const double longer = kSeries[k % 3] * std::pow(10.0, k / 3);
    if (10.0 * longer > c.time.duration) break;
    interval = longer;
  }
  return interval;
}

Census census(const Model& model) {
  Census result;
  result.elements = static_cast<std::int64_t>(model.blocks.size());
  result.faces = static_cast<std::int64_t>(model.assembly.faces.size());
  count_cells(model, result);
  count_blocks(model, result);
  write_bill(model, result);
  count_segments(model.assembly, result);
  find_step_bound(model, result);
  return result;
}

StepBound step_bound(const Model& model, std::size_t block) {
  const geometry::Element& element = model.assembly.elements[block];
  const Material& material = nth(model.materials, model.blocks[block].material).value;
  StepBound least{std::numeric_limits<double>::infinity(), -1};
  for (std::int32_t f = 0; f < element.face_count; ++f) {
    const double bound = step_bound(material, nth(model.assembly.faces, element.first_face + f).distance);
    if (bound < least.step * kLess) least = {bound, f};
  }
  return least;
}

double step_bound(const Material& material, double distance) noexcept {
  return distance / std::sqrt(material.young / (1.0 - material.poisson * material.poisson) / material.density);
}

}  // namespace voussoir::cases
