// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/field_table.h"

#include <cstring>

namespace voussoir::solver {

namespace {

Field field(const char* name, const char* unit, const char* shape, Array<double>& a) {
  return {name, unit, shape, FieldType::f64, a.data(), a.size()};
}
Field field(const char* name, const char* unit, const char* shape, Array<std::int32_t>& a) {
  return {name, unit, shape, FieldType::i32, a.data(), a.size()};
}
template <class T>
Field field(const char* name, const char* unit, const char* shape, Array<T>& a) {
  static_assert(sizeof(T) == 1);
  return {name, unit, shape, FieldType::u8, a.data(), a.size()};
}

void add_elements(std::vector<Field>& t, Elements& e) {
  const char* shape = "element";
  t.insert(t.end(), {field("ux", "m", shape, e.ux),
                     field("uy", "m", shape, e.uy),
                     field("uz", "m", shape, e.uz),
                     field("qw", "-", shape, e.qw),
                     field("qx", "-", shape, e.qx),
                     field("qy", "-", shape, e.qy),
                     field("qz", "-", shape, e.qz),
                     field("vx", "m/s", shape, e.vx),
                     field("vy", "m/s", shape, e.vy),
                     field("vz", "m/s", shape, e.vz),
                     field("lx", "kg m2/s", shape, e.lx),
                     field("ly", "kg m2/s", shape, e.ly),
                     field("lz", "kg m2/s", shape, e.lz),
                     field("wx", "rad/s", shape, e.wx),
                     field("wy", "rad/s", shape, e.wy),
                     field("wz", "rad/s", shape, e.wz),
                     field("work_ground", "J", shape, e.work_ground),
                     field("work_gravity", "J", shape, e.work_gravity),
                     field("loss_damping", "J", shape, e.loss_damping),
                     field("loss_dashpot", "J", shape, e.loss_dashpot),
                     field("alpha", "1/s", shape, e.alpha),
                     field("bonds", "-", shape, e.bonds)});
}

void add_sides(std::vector<Field>& t, Sides& s) {
  t.insert(t.end(), {field("side_quick", "-", "side", s.quick), field("side_retired", "-", "side", s.retired),
                     field("side_held", "-", "side", s.held), field("side_friction", "J", "side", s.friction),
                     field("side_impact", "J", "side", s.impact), field("side_fracture", "J", "side", s.fracture),
                     field("segment_bond", "-", "segment", s.bond), field("segment_first_mode", "-", "segment", s.first_mode),
                     field("segment_first_time", "s", "segment", s.first_time), field("segment_slip1", "m", "segment", s.slip1),
                     field("segment_slip2", "m", "segment", s.slip2), field("segment_closure", "m", "segment", s.closure)});
}

void add_patches(std::vector<Field>& t, Patches& p) {
  t.insert(t.end(), {field("patch_from_side", "-", "patch", p.from_side), field("patch_mastered", "-", "patch", p.mastered),
                     field("patch_touching", "-", "patch", p.touching), field("patch_stored", "J", "patch", p.stored),
                     field("patch_friction", "J", "patch", p.friction), field("patch_impact", "J", "patch", p.impact),
                     field("point_partner", "-", "point", p.partner), field("point_face", "-", "point", p.face),
                     field("point_slip_x", "m", "point", p.slip_x), field("point_slip_y", "m", "point", p.slip_y),
                     field("point_slip_z", "m", "point", p.slip_z), field("point_closure", "m", "point", p.closure)});
}

// When the next search is due depends on where elements were at the last one, and contacts begin with a search.
void add_search(std::vector<Field>& t, Contacts& c) {
  const char* shape = "element";
  t.insert(t.end(),
           {field("searched_ux", "m", shape, c.at_ux), field("searched_uy", "m", shape, c.at_uy), field("searched_uz", "m", shape, c.at_uz),
            field("searched_qw", "-", shape, c.at_qw), field("searched_qx", "-", shape, c.at_qx), field("searched_qy", "-", shape, c.at_qy),
            field("searched_qz", "-", shape, c.at_qz)});
}

}  // namespace

std::size_t Field::bytes() const noexcept {
  return count * (type == FieldType::f64 ? sizeof(double) : type == FieldType::i32 ? sizeof(std::int32_t) : 1U);
}

std::vector<Field> fields(World& w) {
  std::vector<Field> table;
  add_elements(table, w.elements);
  add_sides(table, w.sides);
  add_patches(table, w.patches);
  add_search(table, w.contacts);
  return table;
}

std::uint64_t state_hash(World& w) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto eat = [&hash](const void* data, std::size_t n) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < n; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3ULL;
  };
  for (const Field& f : fields(w)) {
    eat(f.name, std::strlen(f.name));
    eat(f.data, f.bytes());
  }
  return hash;
}

}  // namespace voussoir::solver
