// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/crack_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/model.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "io/output/drawing/svg.h"
#include "io/output/replay/joint_cracks.h"

namespace voussoir::io {
namespace {

using geometry::Point2;

constexpr double kMargin = 40.0, kHead = 62.0, kFoot = 108.0;  // user units
constexpr double kWidest = 1000.0;                            // user units, greatest width of the elevation
constexpr double kLargestScale = 240.0;                       // units per metre
constexpr double kLeastSheet = 820.0;                         // user units, least width of the sheet, for the legend
constexpr double kOnFace = 1e-4;                              // m
constexpr std::size_t kLabels = 6;                            // number of labelled widths
constexpr double kApart = 0.4;                                // m, least distance between labels

const CrackClass* class_of(double width) {
  const CrackClass* found = nullptr;
  for (const CrackClass& c : kCrackClasses)
    if (width >= c.from) found = &c;
  return found;
}

class Map {
 public:
  Map(const Building& building, std::int32_t wall) : building_(building), number_(wall), wall_(nth(building.walls, wall)) {
    extent_ = wall_.box;
    for (std::size_t e = 0; e < building.wall.size(); ++e)
      if (building.wall[e] == wall) extent_.include(building.box_in(wall_, e));  // including the gable
    axis_ = 1 - wall_.across;
    face_ = wall_.outward > 0 ? wall_.box.high[wall_.across] : wall_.box.low[wall_.across];
    scale_ = std::min(kLargestScale, kWidest / std::max(extent_.size(axis_), extent_.size(2)));
  }

  std::string draw(const Hdf5File& run, const std::string& title, double time, const std::vector<JointWidth>& joints,
                   const std::vector<std::uint8_t>& fallen, const std::vector<Crack>& cracks) {
    const double wide = scale_ * extent_.size(axis_), high = scale_ * extent_.size(2);
    left_ = std::max(kMargin, 0.5 * (kLeastSheet - wide));
    Svg svg(std::max(wide + 2.0 * kMargin, kLeastSheet), kHead + high + kFoot);
    svg.text({kMargin, 26.0}, title + ": " + wall_.name, 17.0);
    draw_elements(svg, fallen);
    const double ground = kHead + high;
    svg.line({left_ - 12.0, ground}, {left_ + wide + 12.0, ground}, "#222", 1.6);
    const double widest = draw_cracks(svg, run, joints);
    write_widths(svg, cracks);
    svg.text({kMargin, 46.0}, "cracks at " + geometry::printed("%.3f s", time) + ", seen from outside" + widths(joints, widest), 13.0);
    draw_legend(svg, ground + 30.0);
    draw_scale_bar(svg, {left_ + wide, ground + 74.0});
    return std::move(svg).finish();
  }

 private:
  [[nodiscard]] Point2 at(double along, double z) const {
    const double u = wall_.right() > 0 ? along - extent_.low[axis_] : extent_.high[axis_] - along;
    return {left_ + scale_ * u, kHead + scale_ * (extent_.high[2] - z)};
  }
  [[nodiscard]] double along(Vec3 v) const { return wall_.along(v); }
  [[nodiscard]] double out(Vec3 v) const { return wall_.through(v); }

  /// Draws elements visible on the outer face at their initial positions; fallen ones are grey.
  void draw_elements(Svg& svg, const std::vector<std::uint8_t>& fallen) const {
    for (std::size_t e = 0; e < building_.wall.size(); ++e) {
      const Box b = building_.box_in(wall_, e);
      const double outer = wall_.outward > 0 ? b.high[wall_.across] : b.low[wall_.across];
      const bool touches = b.low[axis_] < wall_.box.high[axis_] + kOnFace && b.high[axis_] > wall_.box.low[axis_] - kOnFace;
      const bool beside = touches && b.centre(2) > extent_.low[2] && b.centre(2) < extent_.high[2];
      const bool of_wall = building_.wall[e] == number_, shows = of_wall || (beside && building_.wall[e] >= 0);
      if (!shows || std::abs(outer - face_) > kOnFace) continue;
      const bool timber = building_.kind[e] == cases::PartKind::lintel;
      const std::array<Point2, 4> corners{at(b.low[axis_], b.low[2]), at(b.high[axis_], b.low[2]), at(b.high[axis_], b.high[2]),
                                          at(b.low[axis_], b.high[2])};
      svg.polygon(corners, fallen[e] != 0 ? "#c9c9c9" : timber ? "#dcc9ab" : "#fbf8f3", "#d8cebf");
    }
  }

  /// "; widest 17 mm": the greatest width in the table (wall_figures), and that on this face if it differs. \param drawn  greatest width on
  /// this face [m]
  [[nodiscard]] std::string widths(const std::vector<JointWidth>& joints, double drawn) const {
    const CrackFigures f = wall_figures(joints, number_);
    if (f.joints == 0) return "";
    const std::string here = drawn > 0.0 ? geometry::printed("; on this face %.2f mm", 1e3 * drawn) : "; none of them on this face";
    return geometry::printed("; widest %.2f mm", 1e3 * f.largest) + (drawn < f.largest ? here : "");
  }

  /// Draws the cracks on the outer face. \return the greatest width [m]; 0: no crack
  double draw_cracks(Svg& svg, const Hdf5File& run, const std::vector<JointWidth>& joints) {
    std::vector<JointWidth> here;
    for (const JointWidth& j : joints)
      if (j.kind != OpeningKind::seat && j.is_of(number_) && class_of(j.width) != nullptr) here.push_back(j);
    std::ranges::stable_sort(here, {}, &JointWidth::width);  // the widest on top
    std::vector<std::size_t> rows;
    for (const JointWidth& j : here) rows.push_back(j.joint);
    const std::vector<std::vector<JointEdge>> edges = joint_edges(run, rows);
    std::vector<JointWidth> drawn;
    for (std::size_t i = 0; i < here.size(); ++i) {
      const CrackClass& c = *class_of(here[i].width);
      bool any = false;
      for (const JointEdge& e : edges[i]) {
        if (std::abs(out(e.from) - face_) > kOnFace || std::abs(out(e.to) - face_) > kOnFace) continue;
        svg.line(at(along(e.from), e.from.z), at(along(e.to), e.to.z), c.colour, c.stroke);
        nth(length_, &c - kCrackClasses.data()) += norm(e.to - e.from);
        any = true;
      }
      if (any && is_crack_of(here[i], number_)) drawn.push_back(here[i]);
    }
    return drawn.empty() ? 0.0 : drawn.back().width;
  }

  /// Labels the widest cracks of the wall, at least kApart from each other: "3: 4.2", the number in the table and the width in mm.
  void write_widths(Svg& svg, const std::vector<Crack>& cracks) const {
    std::vector<Vec3> taken;
    for (std::size_t i = 0; i < cracks.size() && taken.size() < kLabels; ++i) {
      const Crack& c = cracks[i];
      if (c.wall != number_) continue;
      if (std::ranges::any_of(taken, [&](Vec3 t) { return std::hypot(along(t) - along(c.widest), t.z - c.widest.z) < kApart; })) continue;
      taken.push_back(c.widest);
      const Point2 p = at(along(c.widest), c.widest.z);
      const std::string width = geometry::printed(c.width < 10e-3 ? "%.2g" : "%.0f", 1e3 * c.width);
      svg.text({p.s + 5.0, p.t - 5.0}, std::to_string(i + 1) + ": " + width, 12.0, "start", "#111");
    }
  }

  void draw_legend(Svg& svg, double top) const {
    double x = kMargin;
    for (std::size_t k = 0; k < kCrackClasses.size(); ++k) {
      const CrackClass& c = kCrackClasses[k];
      svg.line({x, top - 4.0}, {x + 24.0, top - 4.0}, c.colour, c.stroke);
      svg.text({x + 30.0, top}, c.words, 12.0);
      svg.text({x + 30.0, top + 15.0}, geometry::printed("%.1f m", length_[k]), 11.0, "start", "#666");
      x += 122.0;
    }
    svg.text(
        {kMargin, top + 62.0},
        "width: opening and sliding together; written: number of the crack in the table, its width in mm; grey: fallen; slip of timber "
        "is left out",
        11.0, "start", "#444");
  }

  void draw_scale_bar(Svg& svg, Point2 end) const {
    const Point2 begin{end.s - scale_, end.t};
    svg.line(begin, end, "#111", 2.0);
    for (const Point2 p : {begin, end}) svg.line({p.s, p.t - 4.0}, {p.s, p.t + 4.0}, "#111", 1.2);
    svg.text({0.5 * (begin.s + end.s), end.t - 6.0}, "1 m", 12.0, "middle");
  }

  const Building& building_;
  std::int32_t number_;
  const Wall& wall_;
  Box extent_ = Box::empty();
  std::size_t axis_ = 0;  // along the wall
  double face_ = 0;       // m, position of the outer face along the axis across
  double scale_ = 1, left_ = 0;
  std::array<double, kCrackClasses.size()> length_{};  // m, total length drawn, by class
};

}  // namespace

std::string crack_map(const Hdf5File& run, const std::string& title, const Building& building, std::int32_t wall, double time,
                      const std::vector<JointWidth>& joints, const std::vector<std::uint8_t>& fallen, const std::vector<Crack>& cracks) {
  return Map(building, wall).draw(run, title, time, joints, fallen, cracks);
}

}  // namespace voussoir::io
