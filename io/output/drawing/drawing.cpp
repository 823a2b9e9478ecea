// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/drawing/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "io/output/drawing/block_style.h"
#include "io/output/drawing/dimensions.h"
#include "io/output/drawing/svg.h"
#include "io/output/drawing/wall_dimensions.h"

namespace voussoir::io {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr double kMargin = 30.0, kTitle = 44.0, kCaption = 64.0, kLegend = 40.0;  // user units
constexpr double kSheet = 760.0;                                                  // widest view
constexpr double kLargestScale = 140.0;                                           // units per metre
constexpr double kBehind = 0.55;                 // m; faces farther than this behind the nearest one are drawn darker
constexpr double kWords = 58.0, kPieces = 20.0;  // below the foot of a view: caption, dimensions of the wall
constexpr double kBeside = 10.0;                 // units of ground drawn beside the house
constexpr std::size_t kMostPlans = 6;            // of walls of any plan
constexpr const char* kNamed = "#1f5fa8";        // not red, which marks cracks in all pictures
constexpr const char* kTie = "#1b7f5c";

/// A direction of view: screen axes right and up, and the direction into the picture.
struct View {
  const char* name;
  Vec3 right, up, into;
};
constexpr std::array<View, 4> kElevations{{{"front", {1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                           {"rear", {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                           {"left", {0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
                                           {"right", {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}}}};
constexpr View kPlan{"plan", {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};

/// The part of the sheet occupied by a view.
class Frame {
 public:
  Frame(const View& view, Point2 low, double scale, Point2 corner, double height)
      : view_(view), low_(low), scale_(scale), corner_(corner), height_(height) {}

  [[nodiscard]] Point2 at(Vec3 p) const {
    return {corner_.s + scale_ * (dot(p, view_.right) - low_.s), corner_.t + height_ - scale_ * (dot(p, view_.up) - low_.t)};
  }
  [[nodiscard]] double depth(Vec3 p) const { return dot(p, view_.into); }
  [[nodiscard]] const View& view() const { return view_; }

 private:
  const View& view_;
  Point2 low_;
  double scale_;
  Point2 corner_;
  double height_;
};

/// A face that may be visible.
struct VisibleFace {
  double depth = 0.0;
  Polygon corners;
  std::size_t element = 0;
  bool upright = false;  // parallel to the picture plane
};

class Drawing {
 public:
  Drawing(const cases::Case& c, const cases::Model& model)
      : case_(c), model_(model), base_(c.base ? c.base->z : 0.0), outlines_(cases::wall_outlines(c.walls, {c.floors, c.roofs, c.vaults})) {
    box_ = geometry::bounds(model.blocks.front().shape);
    for (const cases::Block& b : model.blocks) {
      if (b.ground >= 0) continue;  // ground may extend far beyond the walls on it
      const geometry::Box3 box = geometry::bounds(b.shape);
      box_.low = {std::min(box_.low.x, box.low.x), std::min(box_.low.y, box.low.y), std::min(box_.low.z, box.low.z)};
      box_.high = {std::max(box_.high.x, box.high.x), std::max(box_.high.y, box.high.y), std::max(box_.high.z, box.high.z)};
    }
    for (const cases::HistoryPoint& h : c.output.history) nth(named_, cases::nearest_element(model, h.point)) = h.name;
    const Vec3 size = box_.high - box_.low;
    scale_ = std::min(kLargestScale, kSheet / std::max({size.x, size.y, 0.5 * size.z}));
  }

  std::string draw() {
    const Vec3 size = box_.high - box_.low;
    const double wide = scale_ * size.x, deep = scale_ * size.y, high = scale_ * size.z;
    const double width = std::max(2.0 * std::max(wide, deep) + 3.0 * kMargin, 640.0);
    const std::vector<double> sections = section_heights();
    double height = kTitle + kLegend + kMargin + 2.0 * (high + kCaption + kMargin);
    for (std::size_t i = 0; i < sections.size(); i += 2) height += deep + kCaption + kMargin;
    const std::vector<Vec3> crowns = crowns_of_vaults();
    if (!crowns.empty()) height += deep + kCaption + kMargin + static_cast<double>(crowns.size()) * (high + kCaption + kMargin);
    Svg svg(width, height);
    svg.text({kMargin, 30.0}, case_.title, 18.0);
    double top = kTitle;
    const double second = 0.5 * width + 0.5 * kMargin;
    draw_elevation(svg, kElevations[0], {kMargin, top}, high);
    draw_elevation(svg, kElevations[1], {second, top}, high);
    top += high + kCaption + kMargin;
    draw_elevation(svg, kElevations[2], {kMargin, top}, high);
    draw_elevation(svg, kElevations[3], {second, top}, high);
    top += high + kCaption + kMargin;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      draw_plan(svg, sections[i], {i % 2 == 0 ? kMargin : second, top}, deep);
      if (i % 2 == 1 || i + 1 == sections.size()) top += deep + kCaption + kMargin;
    }
    if (!crowns.empty()) draw_vaults(svg, {kMargin, top}, deep), top += deep + kCaption + kMargin;
    for (const Vec3 crown : crowns) {
      draw_section(svg, kElevations[0], crown, {kMargin, top}, high);
      draw_section(svg, kElevations[2], crown, {second, top}, high);
      top += high + kCaption + kMargin;
    }
    draw_legend(svg, height - kLegend);
    draw_scale_bar(svg, {width - kMargin - 180.0, height - kLegend + 8.0}, scale_);
    return std::move(svg).finish();
  }

 private:
  [[nodiscard]] Frame frame_of(const View& view, Point2 corner, double height) const {
    const double right = std::min(dot(box_.low, view.right), dot(box_.high, view.right));
    const double up = std::min(dot(box_.low, view.up), dot(box_.high, view.up));
    return {view, {right, up}, scale_, corner, height};
  }

  /// Faces on the near side of their elements that are not entirely in contact; the farthest first.
  [[nodiscard]] std::vector<VisibleFace> visible(const Frame& frame) const {
    std::vector<VisibleFace> faces;
    for (const geometry::FreePatch& patch : model_.assembly.patches) {
      if (dot(patch.frame().normal, frame.view().into) > -1e-6) continue;
      const auto element = static_cast<std::size_t>(patch.element);
      const geometry::Polyhedron& shape = model_.blocks[element].shape;
      VisibleFace face{frame.depth(geometry::face_plane(shape, patch.face).centroid),
                       {},
                       element,
                       dot(patch.frame().normal, frame.view().into) < -0.999};
      for (const std::int32_t v : nth(shape.faces, patch.face)) face.corners.push_back(frame.at(nth(shape.vertices, v)));
      faces.push_back(std::move(face));
    }
    for (std::size_t e = 0; e < model_.blocks.size(); ++e) {
      if (model_.blocks[e].ground < 0) continue;
      const geometry::Polyhedron shape = ground_near_walls(model_.blocks[e]);
      for (int f = 0; f < static_cast<int>(shape.faces.size()); ++f) {
        const geometry::FacePlane plane = geometry::face_plane(shape, f);
        if (dot(plane.normal, frame.view().into) > -0.5) continue;
        VisibleFace face{frame.depth(plane.centroid), {}, e, false};
        for (const std::int32_t v : nth(shape.faces, f)) face.corners.push_back(frame.at(nth(shape.vertices, v)));
        faces.push_back(std::move(face));
      }
    }
    std::stable_sort(faces.begin(), faces.end(), [](const VisibleFace& a, const VisibleFace& b) { return a.depth > b.depth; });
    return faces;
  }

  /// A part of the base, cut off near the house.
  [[nodiscard]] geometry::Polyhedron ground_near_walls(const cases::Block& block) const {
    const geometry::Box3 whole = geometry::bounds(block.shape);
    Vec3 low = whole.low, high = whole.high;
    const double beside = kBeside / scale_;
    low.x = std::clamp(low.x, box_.low.x - beside, box_.high.x), high.x = std::clamp(high.x, box_.low.x, box_.high.x + beside);
    low.y = std::clamp(low.y, box_.low.y - beside, box_.high.y), high.y = std::clamp(high.y, box_.low.y, box_.high.y + beside);
    return low.x < high.x && low.y < high.y ? geometry::make_box(low, high) : geometry::Polyhedron{};
  }

  [[nodiscard]] std::string fill(std::size_t element, double light) const {
    return named_.count(element) != 0 ? kNamed : style(model_.blocks[element]).colour.text(light);
  }

  /// Depth of the nearest face, without piers and buttresses, which stand before their wall and must not darken it.
  [[nodiscard]] double nearest_wall(const std::vector<VisibleFace>& faces) const {
    for (std::size_t i = faces.size(); i-- > 0;) {
      const cases::Block& block = model_.blocks[faces[i].element];
      if (block.ground >= 0) continue;
      if (block.house < 0 || block.tag.find(" pier ") == std::string::npos) return faces[i].depth;
    }
    return faces.empty() ? 0.0 : faces.back().depth;
  }

  void draw_elevation(Svg& svg, const View& view, Point2 corner, double height) const {
    const Frame frame = frame_of(view, corner, height);
    const std::vector<VisibleFace> faces = visible(frame);
    const double nearest = nearest_wall(faces);
    for (const VisibleFace& f : faces) svg.polygon(f.corners, fill(f.element, f.upright && f.depth > nearest + kBehind ? 0.62 : 1.0));
    for (const auto& [element, name] : named_) {  // also elements inside the wall
      if (frame.depth(model_.assembly.elements[element].mass.centroid) <= nearest + kBehind) label(svg, frame, element);
    }
    for (const cases::TieBar& t : model_.ties) {  // straps of the near faces only, all rods
      if (t.mesh < 0 || std::max(frame.depth(end_of(t, 0)), frame.depth(end_of(t, 1))) <= nearest + kBehind) draw_tie(svg, frame, t);
    }
    const Vec3 size = box_.high - box_.low;
    const double width = scale_ * std::abs(dot(size, view.right));
    svg.line({corner.s - 8.0, corner.t + height}, {corner.s + width + 8.0, corner.t + height}, "#222", 1.5);
    draw_opening_dimensions(
        svg, case_, view.name, box_, [&](Vec3 p) { return frame.at(p); }, kPieces);
    draw_wall_openings(svg, outlines_, base_, {view.right, view.into}, [&](Vec3 p) { return frame.at(p); });
    draw_axes(svg, {corner.s + width - 30.0, corner.t + height + kWords + 2.0}, view.right, view.up);
    svg.text({corner.s, corner.t + height + kWords},
             std::string(view.name) + ", " + metres_text(std::abs(dot(size, view.right))) + " x " + metres_text(size.z) + " m", 13.0);
  }

  void draw_plan(Svg& svg, double z, Point2 corner, double height) const {
    const Frame frame = frame_of(kPlan, corner, height);
    for (std::size_t e = 0; e < model_.blocks.size(); ++e) {
      const bool ground = model_.blocks[e].ground >= 0;
      const Polygon section = section_at(ground ? ground_near_walls(model_.blocks[e]) : model_.blocks[e].shape, -z, frame);
      if (section.size() > 2) svg.polygon(section, fill(e, 1.0));
    }
    for (const cases::TieBar& t : model_.ties) {
      if (t.mesh < 0) draw_tie(svg, frame, t);
    }
    for (const auto& [element, name] : named_) label(svg, frame, element);
    draw_thicknesses(svg, case_, z, [&](Vec3 p) { return frame.at(p); });
    draw_wall_plan(svg, outlines_, base_, z - base_, [&](Vec3 p) { return frame.at(p); });
    draw_axes(svg, {corner.s + scale_ * (box_.high.x - box_.low.x) - 30.0, corner.t + height + kWords + 2.0}, kPlan.right, kPlan.up);
    svg.text({corner.s, corner.t + height + kWords}, "plan at z = " + metres_text(model_.origin.z + z) + " m; front below", 13.0);
  }

  static Vec3 end_of(const cases::TieBar& t, std::size_t end) {
    Vec3 at;
    for (const cases::TieHold& h : t.ends[end]) at += h.share * h.point;
    return at;
  }

  /// Draws a rod with a dot at either end, also in a view along it; a strap as a thin line.
  static void draw_tie(Svg& svg, const Frame& frame, const cases::TieBar& t) {
    const std::array<Point2, 2> ends{frame.at(end_of(t, 0)), frame.at(end_of(t, 1))};
    svg.line(ends[0], ends[1], kTie, t.mesh < 0 ? 2.0 : 0.6);
    if (t.mesh >= 0) return;
    for (const Point2 at : ends) svg.circle(at, 3.0, kTie);
  }

  /// The middle in plan of each vault between walls.
  [[nodiscard]] std::vector<Vec3> crowns_of_vaults() const {
    std::vector<Vec3> crowns;
    for (std::size_t v = 0; v < case_.vaults.size(); ++v) {
      Vec3 low{1e9, 1e9, 0.0}, high{-1e9, -1e9, 0.0};
      for (const cases::Block& b : model_.blocks) {
        if (b.vault != static_cast<std::int32_t>(v)) continue;
        const geometry::Box3 box = geometry::bounds(b.shape);
        low = {std::min(low.x, box.low.x), std::min(low.y, box.low.y), 0.0},
        high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y), 0.0};
      }
      crowns.push_back(0.5 * (low + high));
    }
    return crowns;
  }

  /// All vaults between walls from above.
  void draw_vaults(Svg& svg, Point2 corner, double height) const {
    const Frame frame = frame_of(kPlan, corner, height);
    for (const VisibleFace& f : visible(frame)) {
      if (model_.blocks[f.element].vault >= 0) svg.polygon(f.corners, fill(f.element, 1.0));
    }
    draw_axes(svg, {corner.s + scale_ * (box_.high.x - box_.low.x) - 30.0, corner.t + height + kWords + 2.0}, kPlan.right, kPlan.up);
    svg.text({corner.s, corner.t + height + kWords}, case_.vaults.size() == 1 ? "vault from above" : "vaults from above", 13.0);
  }

  /// An upright section through a point, in the direction of a view.
  void draw_section(Svg& svg, const View& view, Vec3 at, Point2 corner, double height) const {
    const Frame frame = frame_of(view, corner, height);
    for (std::size_t e = 0; e < model_.blocks.size(); ++e) {
      if (model_.blocks[e].ground >= 0) continue;
      const Polygon section = section_at(model_.blocks[e].shape, frame.depth(at), frame);
      if (section.size() > 2) svg.polygon(section, fill(e, 1.0));
    }
    const bool across = std::abs(view.into.y) > 0.5;
    draw_axes(svg, {corner.s + scale_ * std::abs(dot(box_.high - box_.low, view.right)) - 30.0, corner.t + height + kWords + 2.0},
              view.right, view.up);
    svg.text({corner.s, corner.t + height + kWords},
             std::string("section at ") + (across ? "y = " : "x = ") +
                 metres_text(across ? model_.origin.y + at.y : model_.origin.x + at.x) + " m, seen from the " + view.name,
             13.0);
  }

  /// The convex polygon of a block's section square to the view.
  [[nodiscard]] static Polygon section_at(const geometry::Polyhedron& shape, double depth, const Frame& frame) {
    Polygon points;
    for (const auto& loop : shape.faces) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 a = nth(shape.vertices, loop[i]);
        const Vec3 b = nth(shape.vertices, loop[(i + 1) % loop.size()]);
        const double from = frame.depth(a), to = frame.depth(b);
        if ((from > depth) != (to > depth)) points.push_back(frame.at(a + (depth - from) / (to - from) * (b - a)));
      }
    }
    Point2 middle;
    for (const Point2 p : points)
      middle.s += p.s / static_cast<double>(points.size()), middle.t += p.t / static_cast<double>(points.size());
    std::sort(points.begin(), points.end(),
              [&](Point2 a, Point2 b) { return std::atan2(a.t - middle.t, a.s - middle.s) < std::atan2(b.t - middle.t, b.s - middle.s); });
    return points;
  }

  void label(Svg& svg, const Frame& frame, std::size_t element) const {
    const Point2 at = frame.at(model_.assembly.elements[element].mass.centroid);
    svg.circle(at, 4.0, kNamed);
    svg.text({at.s + 7.0, at.t - 6.0}, named_.at(element), 12.0, "start", kNamed);
  }

  [[nodiscard]] Style style(const cases::Block& b) const { return style_of(b, case_.house && case_.house->bond == cases::Bond::rubble); }

  void draw_legend(Svg& svg, double top) const {
    std::map<std::string, std::pair<Colour, int>> styles;
    for (const cases::Block& b : model_.blocks) {
      const Style of_block = style(b);
      ++styles.try_emplace(of_block.name, of_block.colour, 0).first->second.second;
    }
    double left = kMargin;
    for (const auto& [name, entry] : styles) {
      const std::array<Point2, 4> patch{{{left, top}, {left + 16.0, top}, {left + 16.0, top + 12.0}, {left, top + 12.0}}};
      svg.polygon(patch, entry.first.text(1.0));
      const std::string words = name + ": " + std::to_string(entry.second);
      svg.text({left + 22.0, top + 11.0}, words, 12.0);
      left += 46.0 + 7.0 * static_cast<double>(words.size());
    }
    if (model_.ties.empty()) return;
    svg.line({left, top + 6.0}, {left + 16.0, top + 6.0}, kTie, 2.0);
    svg.text({left + 22.0, top + 11.0}, "tie: " + std::to_string(model_.ties.size()), 12.0);
  }

  /// Heights of the plans [m]: of walls of any plan as many as show all openings, of a house a course and the one above it.
  [[nodiscard]] std::vector<double> section_heights() const {
    std::vector<double> heights;
    for (const double h : plan_heights(outlines_, kMostPlans)) heights.push_back(base_ + h);
    if (!heights.empty()) return heights;
    const double section = section_height();
    if (!case_.house) return {section};
    return {section, section + case_.house->brick[2] + case_.house->mortar};
  }

  /// Height of the section of a house: the middle of the course that meets most openings, among courses at half the height of an opening.
  [[nodiscard]] double section_height() const {
    double best = 0.5 * (box_.low.z + box_.high.z);
    if (!case_.house) return best;
    const double course = case_.house->brick[2] + case_.house->mortar, base = case_.base ? case_.base->z : 0.0;
    const auto middle = [&](double z) { return (std::floor(z / course) + 0.5) * course; };
    best = base + middle(0.5 * case_.house->height);
    std::ptrdiff_t most = 0;
    for (const cases::Opening& o : case_.house->openings) {
      const double z = middle(o.sill + 0.5 * o.height - 0.5 * course);
      const auto meets = std::count_if(case_.house->openings.begin(), case_.house->openings.end(),
                                       [&](const cases::Opening& p) { return p.sill < z && z + course < p.sill + p.height; });
      if (meets > most) most = meets, best = base + z;
    }
    return best;
  }

  const cases::Case& case_;
  const cases::Model& model_;
  double base_;                               // m, base.z
  std::vector<cases::WallOutline> outlines_;  // of [[wall]]
  geometry::Box3 box_;                        // m
  std::map<std::size_t, std::string> named_;
  double scale_ = 1.0;  // units per metre
};

}  // namespace

std::string draw(const cases::Case& c, const cases::Model& model) { return Drawing(c, model).draw(); }

}  // namespace voussoir::io
