// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/results_schema.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <stdexcept>

#include "geometry/nth.h"
#include "io/input/document/history_name.h"

namespace voussoir::io {
namespace {

using enum Hdf5Type;

ColumnSpec scalar(const std::string& name, const char* unit, const char* description) { return {name, f64, {}, {unit, description}, {}}; }

ColumnSpec vector(const std::string& name, const char* unit, const char* description) { return {name, f64, {3}, {unit, description}, {}}; }

ColumnSpec integer(const std::string& name, Hdf5Type type, const char* description) { return {name, type, {}, {"1", description}, {}}; }

/// Refuses invalid names. \param what  kind of the names, for messages
void check_names(const std::string& what, std::span<const std::string> names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (name.empty()) throw std::invalid_argument("a " + what + " has no name");
    if (!can_name_history(name))
      throw std::invalid_argument(what + " \"" + name + "\": a name may not be 'time', '.' or '..' nor hold '/' or control characters");
    if (!seen.insert(name).second) throw std::invalid_argument(what + " \"" + name + "\": the name is given twice");
  }
}

void add_tie_columns(TableSpec& t, std::uint64_t n) {
  t.push_back({"/ties/force", f64, {n}, {"N", "of each tie, in the order of /model/tie, at /history/time; tension is positive"}, {}});
  t.push_back({"/ties/elongation", f64, {n}, {"m", "of each tie, with that of its pretension"}, {}});
  t.push_back({"/ties/plastic", f64, {n}, {"m", "of it, what stays when the force is gone"}, {}});
  t.push_back({"/ties/broken", u8, {n}, {"1", "1: the tie has broken"}, {}});
}

void add_mesh_columns(TableSpec& t, std::uint64_t n) {
  const std::string order = "of each deck and mesh, in the order of /model/mesh, at /history/time: of its bar with the largest";
  t.push_back({"/meshes/force", f64, {n}, {"N", order + "; tension is positive"}, {}});
  t.push_back({"/meshes/elongation", f64, {n}, {"m", order}, {}});
  t.push_back({"/meshes/utilisation", f64, {n}, {"1", order + ": force over yield force; NaN: its bars are elastic"}, {}});
  t.push_back({"/meshes/yielded", i64, {n}, {"1", "bars that have yielded and are not broken"}, {}});
  t.push_back({"/meshes/broken", i64, {n}, {"1", "bars that have broken"}, {}});
}

void add_load_columns(TableSpec& t, std::uint64_t n) {
  t.push_back({"/loaded/force", f64, {n, 3}, {"N", "of each [[load]] of the case, in order, at /history/time; global axes"}, {}});
  t.push_back({"/loaded/displacement",
               f64,
               {n, 3},
               {"m", "of the place where each acts, relative to the base, from time zero; global axes; NaN: it acts nowhere"},
               {}});
}

TableSpec history_columns(std::span<const std::string> names, std::uint64_t ties, std::uint64_t groups, std::uint64_t loads) {
  TableSpec t{scalar("/history/time", "s", "time of the rows of all histories; zero is the start of shaking, settling is before")};
  for (const std::string& name : names) {
    const std::string group = "/history/" + name + "/";
    t.push_back(vector(group + "displacement", "m", "of the element's centroid relative to the base, from time zero; global axes"));
    t.push_back(vector(group + "velocity", "m/s", "of the element's centroid relative to the base; global axes"));
    t.push_back(vector(group + "rotation", "rad", "rotation vector of the element; global axes"));
  }
  if (ties > 0) add_tie_columns(t, ties);
  if (groups > 0) add_mesh_columns(t, groups);
  if (loads > 0) add_load_columns(t, loads);
  return t;
}

TableSpec energy_columns() {
  return {scalar("/energy/time", "s", "time of the rows; zero is the start of shaking"),
          scalar("/energy/kinetic", "J", "stored: kinetic energy relative to the base"),
          scalar("/energy/strain", "J", "stored: elastic energy of bonds and ties"),
          scalar("/energy/contact", "J", "stored: elastic energy of contacts"),
          scalar("/energy/gravity", "J", "stored: potential energy of gravity"),
          scalar("/energy/input", "J", "work put in by ground, loads and supports, with the initial energy"),
          scalar("/energy/dashpot", "J", "lost in the dashpots of contacts"),
          scalar("/energy/friction", "J", "lost by sliding, where bonds that hold slip or are crushed, and where ties yield"),
          scalar("/energy/fracture", "J", "lost where bonds and ties break"),
          scalar("/energy/damping", "J", "lost by mass damping"),
          scalar("/energy/residual", "1", "what the balance leaves over, as a ratio")};
}

TableSpec forces_columns() {
  return {scalar("/forces/time", "s", "time of the rows; zero is the start of shaking"),
          vector("/forces/base_shear", "N", "force of the base on the structure; global axes"),
          vector("/forces/base_moment", "N m", "moment about the origin of the force of the base on the structure; global axes")};
}

TableSpec damage_columns() {
  return {scalar("/damage/time", "s", "time of the rows; zero is the start of shaking"),
          integer("/damage/bonded", i64, "segment sides that still hold, slipped ones included"),
          integer("/damage/slipped", i64, "segment sides that hold and have slipped"),
          integer("/damage/tension", i64, "segment sides opened in tension"),
          integer("/damage/shear", i64, "segment sides opened in shear"),
          integer("/damage/compression", i64, "segment sides opened in compression"),
          integer("/damage/first_tension", i64, "segment sides that reached the limit in tension first, open since"),
          integer("/damage/first_shear", i64, "segment sides that reached the limit in shear first, whether they hold or are open"),
          integer("/damage/first_compression", i64, "segment sides that reached the limit in compression first, open since")};
}

TableSpec cracks_columns() {
  const std::vector<std::string> modes{"none", "tension", "shear", "compression"};
  return {scalar("/cracks/time", "s", "when the segment broke; zero is the start of shaking"),
          integer("/cracks/joint", i32, "joint of the segment, a row of /model/joint"),
          integer("/cracks/element_a", i32, "element on the side that the normal leaves"),
          integer("/cracks/element_b", i32, "element on the other side; -1: the base"),
          vector("/cracks/position", "m", "of the segment when it broke; global axes"),
          vector("/cracks/normal", "1", "unit normal of the segment when it broke; global axes"),
          scalar("/cracks/area", "m2", "of the segment"),
          {"/cracks/mode", u8, {}, {"1", "what opened the segment; see the attribute names"}, modes},
          {"/cracks/first_mode", u8, {}, {"1", "the limit that the segment reached first; see the attribute names"}, modes},
          scalar("/cracks/first_time", "s", "when the segment reached its first limit")};
}

TableSpec assessment_columns() {
  return {scalar("/assessment/time", "s", "time of the rows; zero is the start of a quasi-static analysis; a time history has no rows"),
          scalar("/assessment/factor", "1", "load factor; of a tilt the tangent of the angle"),
          scalar("/assessment/displacement", "m", "of the control point from time zero, along analysis.direction"),
          scalar("/assessment/drift", "1", "displacement over the control point's height above the base"),
          scalar("/assessment/moved", "m", "conjugate to the forces: their work is the integral of factor times weight over it"),
          scalar("/assessment/base_shear", "N",
                 "force along analysis.direction that base and supports bear, mean over a first period; mass damping is not in it"),
          scalar("/assessment/support_moved", "m", "of the moving support that has gone farthest"),
          scalar("/assessment/over", "1", "1 once the analysis has found what it looks for; 2: no state of rest was found from here on"),
          scalar("/assessment/unbalanced", "1",
                 "analysis.solver = equilibrium: largest unbalanced force over the mean weight of an element, or moment over that and the "
                 "element's radius; NaN: dynamics")};
}

TableSpec frames_columns(std::uint64_t n) {
  return {scalar("/frames/time", "s", "time of the frames; zero is the start of shaking"),
          {"/frames/displacement", f32, {n, 3}, {"m", "centroids of all elements from position0, in axes that move with the base"}, {}},
          {"/frames/quaternion",
           f32,
           {n, 4},
           "1",
           "w, x, y, z: rotation of all elements from the reference, x = position0 + displacement + R(q) (X - position0)",
           {}},
          {"/frames/broken", f32, {n}, {"1", "broken fraction of each element's bonds"}, {}}};
}

TableSpec cuts_columns(std::span<const std::string> names) {
  TableSpec t{scalar("/cuts/time", "s", "time of the rows of all cuts, those of /forces; zero is the start of shaking")};
  for (const std::string& name : names) {
    const std::string group = "/cuts/" + name + "/";
    t.push_back(
        vector(group + "force", "N", "of what lies before the plane on what lies behind it; times the normal: tension; global axes"));
    t.push_back(vector(group + "moment", "N m", "of that force about the cut's point; global axes"));
  }
  return t;
}

}  // namespace

const char* table_name(RowTable table) noexcept {
  constexpr std::array names{"history", "energy", "forces", "damage", "cracks", "frames", "cuts", "assessment"};
  return nth(names, table);
}

std::size_t ColumnSpec::row_bytes() const noexcept {
  std::size_t bytes = size_of(type);
  for (const std::uint64_t n : row) bytes *= n;
  return bytes;
}

RowSchema row_schema(std::span<const std::string> history_names, std::uint64_t elements, std::span<const std::string> cut_names,
                     std::uint64_t ties, std::uint64_t groups, std::uint64_t loads) {
  check_names("history", history_names);
  check_names("cut", cut_names);
  return {history_columns(history_names, ties, groups, loads),
          energy_columns(),
          forces_columns(),
          damage_columns(),
          cracks_columns(),
          frames_columns(elements),
          cuts_columns(cut_names),
          assessment_columns()};
}

RowBuffer::RowBuffer(const TableSpec& columns) : columns_(columns.size()), last_row_bytes_(columns.back().row_bytes()) {}

// A row counts once its last column is written: one for which memory did not suffice is ignored.
std::uint64_t RowBuffer::rows() const noexcept {
  if (columns_.empty()) return 0;
  return last_row_bytes_ > 0 ? columns_.back().size() / last_row_bytes_ : columns_.front().size() / sizeof(double);
}

bool RowBuffer::begin(double time, bool repeats) {
  if (time < last_)
    throw std::logic_error("a row of results at " + std::to_string(time) + " s comes after one at " + std::to_string(last_) + " s");
  if (time == last_ && !repeats) return false;
  last_ = time;
  put(0, time);
  return true;
}

void RowBuffer::put(std::size_t column, const void* data, std::size_t bytes) {
  std::vector<std::byte>& to = columns_[column];
  const auto* from = static_cast<const std::byte*>(data);
  to.insert(to.end(), from, from + bytes);
}

std::size_t RowBuffer::bytes() const noexcept {
  std::size_t sum = 0;
  for (const auto& c : columns_) sum += c.size();
  return sum;
}

double RowBuffer::first_time() const noexcept {
  double time = 0;
  std::memcpy(&time, columns_[0].data(), sizeof time);
  return time;
}

void RowBuffer::clear() noexcept {
  for (auto& c : columns_) c.clear();
}

}  // namespace voussoir::io
