// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/results_model.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>

#include "cases/case.h"
#include "cases/loads/loads.h"
#include "cases/loads/moving_load.h"
#include "cases/model.h"
#include "cases/ties/ties.h"
#include "geometry/nth.h"
#include "io/output/replay/cells.h"

namespace voussoir::io {
namespace {

template <class T>
StaticDataset dataset(std::string name, const std::vector<T>& values, std::uint64_t width, const char* unit, std::string description) {
  StaticDataset d;
  d.name = std::move(name);
  d.type = Hdf5TypeOf<T>::value;
  d.shape = width == 1 ? Shape{values.size()} : Shape{values.size() / width, width};
  d.bytes.resize(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(d.bytes.data(), values.data(), d.bytes.size());
  d.note = {unit, std::move(description)};
  return d;
}

/// Writes a dataset at once, of which no copy is made.
template <class T>
void put(Hdf5File& file, const std::string& name, const std::vector<T>& values, std::uint64_t width, const char* unit,
         const std::string& description) {
  const Shape shape = width == 1 ? Shape{values.size()} : Shape{values.size() / width, width};
  const std::size_t row = values.size() * sizeof(T) / std::max<std::size_t>(1, shape[0]);
  file.write_dataset(name, Hdf5TypeOf<T>::value, shape, values.data(), checked_layout(row), {unit, description});
}

void put_texts(Hdf5File& file, const char* name, const std::vector<std::string>& values, const char* description) {
  file.write_strings(name, values, {"1", description});
}

void append(std::vector<double>& to, Vec3 v) { to.insert(to.end(), {v.x, v.y, v.z}); }

/// A dataset with one value for each item of a list.
template <class T, class List, class Get>
std::vector<T> each(const List& list, Get get) {
  std::vector<T> values;
  values.reserve(list.size());
  for (const auto& item : list) values.push_back(static_cast<T>(std::invoke(get, item)));
  return values;
}

template <class List, class Get>
std::vector<double> each_vector(const List& list, Get get) {
  std::vector<double> values;
  values.reserve(3 * list.size());
  for (const auto& item : list) append(values, std::invoke(get, item));
  return values;
}

using Datasets = std::vector<StaticDataset>;

/// Writes a dataset of which no more than a few rows are in memory.
void write_made(Hdf5File& file, const StaticDataset& d) {
  const std::uint64_t width = d.shape.size() > 1 ? d.shape[1] : 1;
  file.create_dataset(d.name, Hdf5Type::f64, d.shape, checked_layout(width * sizeof(double)), d.note);
  std::uint64_t first = 0;
  d.source([&](std::span<const double> values) {
    file.write_rows(d.name, Hdf5Type::f64, first, values.size() / width, values.data());
    first += values.size() / width;
  });
}

/// Text "0 block, 1 brick, ...".
std::string numbered_kinds() {
  using enum cases::PartKind;
  std::string text;
  for (const cases::PartKind kind : {block, brick, lintel, beam, voussoir, column, ring_beam, floor_beam, walling, arch_stone})
    text += (text.empty() ? "" : ", ") + std::to_string(static_cast<int>(kind)) + " " + cases::name(kind);
  return text;
}

void write_elements(const cases::Model& model, Hdf5File& file) {
  using cases::Block;
  std::vector<double> mass, inertia, position, segment;
  std::vector<std::int32_t> first_vertex, first_face;
  std::vector<std::string> tags;
  std::int32_t vertex = 0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& b = model.blocks[i];
    const geometry::Element& e = model.assembly.elements[i];
    const double density = nth(model.materials, b.material).value.density;
    mass.push_back(density * e.mass.volume);
    append(inertia, density * e.mass.principal);
    append(position, e.mass.centroid);
    segment.push_back(b.segment_size);
    tags.push_back(b.tag.empty() ? b.name : b.tag);
    first_vertex.push_back(vertex);
    first_face.push_back(e.first_face);
    vertex += static_cast<std::int32_t>(b.shape.vertices.size());
  }
  put(file, "/model/element/material", each<std::int32_t>(model.blocks, &Block::material), 1, "1", "row of /model/material");
  put_texts(file, "/model/element/tag", tags, "which part of the building the element is, or its name");
  put(file, "/model/element/kind", each<std::uint8_t>(model.blocks, &Block::kind), 1, "1",
      "what the element is in a house: " + numbered_kinds());
  put(file, "/model/element/mass", mass, 1, "kg", "mass");
  put(file, "/model/element/inertia", inertia, 3, "kg m2", "principal moments of inertia about the centroid, ascending");
  put(file, "/model/element/position0", position, 3, "m", "centroid in the reference configuration; global axes");
  put(file, "/model/element/segment_size", segment, 1, "m", "longest edge of the segments that the element's faces are cut into");
  put(file, "/model/element/fixed", each<std::uint8_t>(model.blocks, &Block::fixed), 1, "1", "1: the element is fixed");
  put(file, "/model/element/house", each<std::int32_t>(model.blocks, &Block::house), 1, "1", "copy of the house; -1: a free block");
  if (model.units > 0)
    put(file, "/model/element/unit", each<std::int32_t>(model.blocks, &Block::unit), 1, "1",
        "unit of which the element is a cell; -1: the element is in one piece");
  put(file, "/model/element/first_vertex", first_vertex, 1, "1", "first of the element's rows of /model/vertex");
  put(file, "/model/element/first_face", first_face, 1, "1", "first of the element's rows of /model/face");
}

void write_vertices(const cases::Model& model, Hdf5File& file) {
  std::size_t all = 0;
  for (const cases::Block& b : model.blocks) all += b.shape.vertices.size();
  std::vector<double> vertices;
  vertices.reserve(3 * all);
  for (const cases::Block& b : model.blocks)
    for (const Vec3 v : b.shape.vertices) append(vertices, v);
  put(file, "/model/vertex", vertices, 3, "m", "vertices of all elements in the reference configuration; global axes");
}

void write_cells(const cases::Model& model, Hdf5File& file) {
  const Cells cells = cells_of(model);
  put(file, "/model/cells", cells.corners, 8, "1", "corners of cells in VTK's order, rows of /model/vertex; -1: none");
  put(file, "/model/cell_type", cells.type, 1, "1", "VTK's cell type: 10 tetrahedron, 12 hexahedron, 13 wedge");
  put(file, "/model/cell_element", cells.element, 1, "1", "element of the cell");
}

void write_faces(const cases::Model& model, Hdf5File& file) {
  using geometry::Face;
  const auto& faces = model.assembly.faces;
  std::vector<std::int32_t> element(faces.size());
  for (std::size_t i = 0; i < model.assembly.elements.size(); ++i) {
    const geometry::Element& e = model.assembly.elements[i];
    for (std::int32_t f = 0; f < e.face_count; ++f) nth(element, e.first_face + f) = static_cast<std::int32_t>(i);
  }
  put(file, "/model/face/element", element, 1, "1", "element of the face");
  put(file, "/model/face/normal", each_vector(faces, &Face::normal), 3, "1", "outward unit normal in the reference configuration");
  put(file, "/model/face/distance", each<double>(faces, &Face::distance), 1, "m", "from the element's centroid to the face");
  std::vector<std::int32_t> first_corner, corners;
  std::int32_t vertex = 0;
  for (const cases::Block& b : model.blocks) {
    for (const auto& loop : b.shape.faces) {
      first_corner.push_back(static_cast<std::int32_t>(corners.size()));
      for (const std::int32_t v : loop) corners.push_back(vertex + v);
    }
    vertex += static_cast<std::int32_t>(b.shape.vertices.size());
  }
  put(file, "/model/face/first_corner", first_corner, 1, "1", "first of the face's entries of /model/face/corners");
  put(file, "/model/face/corners", corners, 1, "1",
      "rows of /model/vertex, face by face, counter-clockwise seen from outside; a face's end where the next begins");
  put(file, "/model/face/area", each<double>(faces, &Face::area), 1, "m2", "area of the face");
}

void write_joints(const cases::Model& model, Hdf5File& file) {
  using geometry::Joint;
  const auto& joints = model.assembly.joints;
  const auto add = [&](const char* name, auto member, const char* description) {
    put(file, name, each<std::int32_t>(joints, member), 1, "1", description);
  };
  add("/model/joint/element_a", &Joint::element_a, "element whose face carries the joint's frame");
  add("/model/joint/element_b", &Joint::element_b, "the other element; -1: the base");
  add("/model/joint/face_a", &Joint::face_a, "face of element_a, counted from its first");
  add("/model/joint/face_b", &Joint::face_b, "face of element_b, counted from its first; -1: the base");
  put(file, "/model/joint/law", model.joint_law, 1, "1", "row of /model/law");
  put(file, "/model/joint/area", each<double>(joints, &Joint::area), 1, "m2", "area that the two faces share");
  const auto centre = [](const Joint& j) { return j.centre; };
  const auto normal = [](const Joint& j) { return j.frame().normal; };
  put(file, "/model/joint/centre", each_vector(joints, centre), 3, "m", "centre of the joint in the reference configuration");
  put(file, "/model/joint/normal", each_vector(joints, normal), 3, "1", "unit normal in the reference configuration, out of element_a");
}

void write_materials(const cases::Model& model, Hdf5File& file) {
  std::vector<std::string> names;
  for (const auto& m : model.materials) names.push_back(m.name);
  put_texts(file, "/model/material/name", names, "name of the material");
  const auto material = [&](const char* name, double cases::Material::*member, const char* unit, const char* description) {
    const auto get = [member](const cases::NamedMaterial& m) { return m.value.*member; };
    put(file, name, each<double>(model.materials, get), 1, unit, description);
  };
  material("/model/material/density", &cases::Material::density, "kg/m3", "density");
  material("/model/material/young", &cases::Material::young, "Pa", "Young's modulus");
  material("/model/material/poisson", &cases::Material::poisson, "1", "Poisson's ratio");

  std::vector<std::string> laws;
  for (const auto& l : model.laws) laws.push_back(l.name);
  put_texts(file, "/model/law/name", laws, "name of the joint law; dry: no bond");
  const auto law = [&](const char* name, double cases::JointLaw::*member, const char* unit, const char* description) {
    const auto get = [member](const cases::NamedLaw& l) { return l.value.*member; };
    put(file, name, each<double>(model.laws, get), 1, unit, description);
  };
  law("/model/law/tension", &cases::JointLaw::tension, "Pa", "tensile strength");
  law("/model/law/cohesion", &cases::JointLaw::cohesion, "Pa", "cohesion");
  law("/model/law/friction", &cases::JointLaw::friction, "degree", "angle of friction while the bond holds");
  law("/model/law/compression", &cases::JointLaw::compression, "Pa", "compressive strength");
  law("/model/law/thickness", &cases::JointLaw::thickness, "m", "thickness of the mortar");
  law("/model/law/young", &cases::JointLaw::young, "Pa", "Young's modulus of the mortar");
  law("/model/law/poisson", &cases::JointLaw::poisson, "1", "Poisson's ratio of the mortar");
  if (std::ranges::none_of(model.laws, [](const cases::NamedLaw& l) { return l.value.normal_stiffness.has_value(); })) return;
  const auto own = [&](const char* name, std::optional<double> cases::JointLaw::*member, const char* unit, const char* description) {
    const auto get = [member](const cases::NamedLaw& l) { return (l.value.*member).value_or(0.0); };
    put(file, name, each<double>(model.laws, get), 1, unit, description);
  };
  own("/model/law/normal_stiffness", &cases::JointLaw::normal_stiffness, "Pa/m", "of the joint alone; 0: none of its own");
  own("/model/law/shear_stiffness", &cases::JointLaw::shear_stiffness, "Pa/m", "of the joint alone, along it; 0: none of its own");
  if (std::ranges::none_of(model.laws, [](const cases::NamedLaw& l) { return l.value.stiffens(); })) return;
  own("/model/law/maximum_closure", &cases::JointLaw::maximum_closure, "m", "most that a dry joint closes; 0: its stiffness is one number");
}

/// Where bars of ties begin and end, and what holds them.
class BarEnds {
 public:
  void add(const cases::TieBar& bar) {
    for (const auto& end : bar.ends) {
      Vec3 at;
      for (const cases::TieHold& h : end) at += h.share * h.point;
      append(ends_, at);
      elements_.push_back(std::ranges::max_element(end, {}, &cases::TieHold::share)->element);
    }
  }
  void write(const std::string& name, const std::string& of, Hdf5File& file) const {
    put(file, name + "_ends", ends_, 6, "m", "where each " + of + " begins and ends at the start: x, y, z of both ends");
    put(file, name + "_element", elements_, 2, "1", "what holds most of each end: an element, or -1, the base");
  }

 private:
  std::vector<double> ends_;
  std::vector<std::int32_t> elements_;
};

double or_nan(double limit) { return std::isfinite(limit) ? limit : std::numeric_limits<double>::quiet_NaN(); }

/// Adds separate ties, not those of meshes; nothing for a model without ties.
void write_ties(const cases::Model& m, Hdf5File& file) {
  std::vector<std::string> names;
  std::vector<double> strengths;
  BarEnds ends;
  for (const cases::TieBar& bar : m.ties) {
    if (bar.mesh >= 0) break;
    names.push_back(bar.name);
    strengths.push_back(or_nan(bar.yield));
    ends.add(bar);
  }
  if (names.empty()) return;
  put_texts(file, "/model/tie", names, "names of the ties");
  ends.write("/model/tie", "tie", file);
  put(file, "/model/tie_strength", strengths, 1, "N", "force at which each tie yields; NaN: it is elastic");
}

/// Adds the names and bars of decks and meshes; nothing for a model without.
void write_meshes(const cases::Model& m, Hdf5File& file) {
  std::vector<std::string> names;
  std::vector<std::int64_t> bars;
  std::vector<double> breaking;
  BarEnds ends;
  for (const cases::TieGroup& g : cases::tie_groups(m)) {
    names.push_back(g.name);
    bars.push_back(static_cast<std::int64_t>(g.last - g.first));
    for (const cases::TieBar& bar : std::span(m.ties).subspan(g.first, g.last - g.first))
      ends.add(bar), breaking.push_back(or_nan(bar.breaking));
  }
  if (names.empty()) return;
  put_texts(file, "/model/mesh", names, "names of decks and meshes");
  put(file, "/model/mesh_bars", bars, 1, "1", "number of the bars of each deck and mesh");
  ends.write("/model/mesh_bar", "bar of decks and meshes, in their order,", file);
  put(file, "/model/mesh_bar_breaking", breaking, 1, "m", "elongation at which each bar breaks; NaN: never");
}

/// Rows of /loads.
class LoadTable {
 public:
  void add(std::size_t load, const cases::Load& l, const cases::LoadShare& share, const cases::SupportHistory& force, double part) {
    load_.push_back(static_cast<std::int32_t>(load));
    element_.push_back(share.element);
    append(point_, share.point);
    follows_.push_back(l.follows ? 1 : 0), grows_.push_back(l.grows ? 1 : 0);
    first_.push_back(static_cast<std::int32_t>(time_.size()));
    for (std::size_t k = 0; k < force.time.size(); ++k) time_.push_back(force.time[k]), append(force_, part * force.displacement[k]);
  }
  [[nodiscard]] Datasets datasets() const {
    Datasets out;
    out.push_back(
        dataset("/loads/load", load_, 1, "1", "number of the table [[load]] in the case, from 0; a moving load has a row each place"));
    out.push_back(dataset("/loads/element", element_, 1, "1", "element on which this share of the load acts"));
    out.push_back(dataset("/loads/point", point_, 3, "m", "where it acts, in the reference configuration; moves with the element"));
    out.push_back(dataset("/loads/follows", follows_, 1, "1", "1: the force turns with the element"));
    out.push_back(dataset("/loads/grows", grows_, 1, "1", "1: the force is multiplied by /assessment/factor"));
    out.push_back(dataset("/loads/first_row", first_, 1, "1", "first of its rows of /loads/time and /loads/force"));
    out.push_back(dataset("/loads/time", time_, 1, "s",
                          "of the rows of force: linear between them, nothing before the first, constant after the last"));
    out.push_back(dataset("/loads/force", force_, 3, "N", "of the share at these times"));
    return out;
  }

 private:
  std::vector<std::int32_t> load_, element_, first_;
  std::vector<std::uint8_t> follows_, grows_;
  std::vector<double> point_, time_, force_;
};

}  // namespace

void write_model(Hdf5File& file, const cases::Model& model) {
  if (model.blocks.size() != model.assembly.elements.size() || model.joint_law.size() != model.assembly.joints.size())
    throw std::invalid_argument("the model's assembly does not belong to its blocks");
  put(file, "/model/origin", each_vector(std::vector{model.origin}, std::identity{}), 1, "m",
      "in the axes of the case file: what all coordinates in this file are relative to");
  write_elements(model, file);
  write_vertices(model, file);
  write_cells(model, file);
  write_faces(model, file);
  write_joints(model, file);
  write_materials(model, file);
  write_ties(model, file);
  write_meshes(model, file);
}

std::vector<StaticDataset> load_datasets(const cases::Case& c, const cases::Model& model) {
  if (c.loads.empty()) return {};
  LoadTable t;
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    const cases::Load& l = c.loads[i];
    if (l.path) {
      for (const cases::MovingShare& m : cases::moving_shares(model, l, i, nth(model.support_motions, model.load_path[i])))
        t.add(i, l, m.share, m.force, 1.0);
      continue;
    }
    cases::SupportHistory force{{l.ramp[0], l.ramp[1]}, {Vec3{}, l.force}};
    if (l.ramp[1] <= l.ramp[0]) force = cases::SupportHistory{{l.ramp[1]}, {l.force}};
    if (l.grows) force = cases::SupportHistory{{0.0}, {l.force}};
    if (l.history) force = nth(model.support_motions, model.load_history[i]);
    for (const cases::LoadShare& s : cases::load_shares(model, l, i)) t.add(i, l, s, force, s.part);
  }
  return t.datasets();
}

void write_datasets(Hdf5File& file, const std::vector<StaticDataset>& datasets) {
  for (const StaticDataset& d : datasets) {
    if (d.source)
      write_made(file, d);
    else
      file.write_dataset(d.name, d.type, d.shape, d.bytes.data(), checked_layout(d.bytes.size() / std::max<std::size_t>(1, d.shape[0])),
                         d.note);
  }
}

}  // namespace voussoir::io
