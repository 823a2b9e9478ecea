// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/paraview_files.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <type_traits>
#include <vector>

#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/vec3.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/files/whole_file.h"
#include "io/output/replay/cells.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/run_file.h"
#include "io/output/results/results_parts.h"

namespace voussoir::io {
namespace {

constexpr const char* kData = "paraview.h5";
constexpr std::int32_t kXdmfTetrahedron = 6, kXdmfWedge = 8, kXdmfHexahedron = 9;
constexpr int kDeflate = 1;

/// Constant data, checked: all indices are in range.
struct Still {
  std::vector<double> vertex;                   // m, three per vertex, reference configuration
  std::vector<std::int32_t> first_vertex;       // by element, and the end
  std::vector<std::int32_t> topology;           // mixed topology of XDMF: type and corners of each cell
  std::vector<std::int32_t> element, material;  // by cell
};

bool in_range(std::span<const std::int32_t> values, std::size_t end) {
  return std::ranges::all_of(values, [end](std::int32_t v) { return v >= 0 && static_cast<std::size_t>(v) < end; });
}

/// Topology of the cells. \throw FileError for a corner that is no vertex
std::vector<std::int32_t> mixed_topology(const Hdf5File& run, std::size_t vertices) {
  const auto corners = run.read<std::int32_t>("/model/cells");
  const auto types = run.read<std::uint8_t>("/model/cell_type");
  if (corners.size() != 8 * types.size()) throw FileError(run.path(), "/model/cells does not fit /model/cell_type");
  std::vector<std::int32_t> all;
  for (std::size_t c = 0; c < types.size(); ++c) {
    const std::span<const std::int32_t> row(corners.data() + 8 * c, static_cast<std::size_t>(corners_of(types[c])));
    if (!in_range(row, vertices)) throw FileError(run.path(), "/model/cells: row " + std::to_string(c) + " refers to no vertex");
    all.push_back(types[c] == kTetrahedron ? kXdmfTetrahedron : types[c] == kWedge ? kXdmfWedge : kXdmfHexahedron);
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

Still read_still(const Hdf5File& run, std::size_t elements) {
  Still s;
  s.vertex = run.read<double>("/model/vertex");
  s.first_vertex = run.read<std::int32_t>("/model/element/first_vertex");
  s.element = run.read<std::int32_t>("/model/cell_element");
  const auto material = run.read<std::int32_t>("/model/element/material");
  const std::size_t vertices = s.vertex.size() / 3;
  if (s.first_vertex.size() != elements || material.size() != elements || s.element.size() != run.shape("/model/cell_type").at(0) ||
      !in_range(s.element, elements) || !in_range(s.first_vertex, vertices) || !std::ranges::is_sorted(s.first_vertex))
    throw FileError(run.path(), "/model does not fit together");
  s.topology = mixed_topology(run, vertices);
  s.first_vertex.push_back(static_cast<std::int32_t>(vertices));
  for (const std::int32_t e : s.element) s.material.push_back(nth(material, e));
  return s;
}

Vec3 vector_at(std::span<const double> values, std::size_t i) { return {values[3 * i], values[3 * i + 1], values[3 * i + 2]}; }

void append(std::vector<float>& to, Vec3 v) {
  for (const double x : {v.x, v.y, v.z}) to.push_back(static_cast<float>(x));
}

/// Positions of all vertices in a frame.
std::vector<float> vertices_at(const FrameReader& frames, std::uint64_t frame, const Still& still) {
  const std::vector<double> position = frames.position(frame), q = frames.row("quaternion", frame, 4);
  std::vector<float> points;
  points.reserve(still.vertex.size());
  for (std::size_t e = 0; e < frames.elements(); ++e) {
    const Mat3 turn = rotation({q[4 * e], q[4 * e + 1], q[4 * e + 2], q[4 * e + 3]});
    const Vec3 from = vector_at(frames.start(), e), to = vector_at(position, e);
    for (auto v = static_cast<std::size_t>(still.first_vertex[e]); v < static_cast<std::size_t>(still.first_vertex[e + 1]); ++v)
      append(points, to + turn * (vector_at(still.vertex, v) - from));
  }
  return points;
}

/// A dataset as the data item of an XDMF element.
std::string item(const std::string& path, const Shape& shape, const char* type) {
  std::string extents;
  for (const std::uint64_t n : shape) extents += (extents.empty() ? "" : " ") + std::to_string(n);
  return std::string("<DataItem Format=\"HDF\" NumberType=\"") + type + "\" Precision=\"4\" Dimensions=\"" + extents + "\">" + kData + ":" +
         path + "</DataItem>";
}

std::string cell_array(const char* name, const char* kind, const std::string& data) {
  return std::string("<Attribute Name=\"") + name + "\" AttributeType=\"" + kind + "\" Center=\"Cell\">" + data + "</Attribute>\n";
}

std::string time_element(double t) { return geometry::printed("<Time Value=\"%.9g\"/>\n", t); }

/// Writes arrays into paraview.h5 and their description into run.xdmf.
class ParaviewWriter {
 public:
  /// \param origin  of the run: what points are relative to, since single precision keeps no coordinate far from zero
  ParaviewWriter(Hdf5File& file, const FrameReader& frames, const Still& still, Vec3 origin)
      : file_(file), frames_(frames), still_(still), origin_(origin) {}

  void write_still() {
    file_.write_dataset("/origin", Hdf5Type::f64, {3}, &origin_, {}, {"m", "in the axes of the case file: what points are relative to"});
    const std::string cells = write("/cells", still_.topology, 1, {"1", "type and corners of each cell, in XDMF's numbers"});
    const std::string element = write("/element", still_.element, 1, {"1", "element of the cell"});
    const std::string material = write("/material", still_.material, 1, {"1", "row of /model/material of run.h5"});
    topology_ =
        "<Topology TopologyType=\"Mixed\" NumberOfElements=\"" + std::to_string(still_.element.size()) + "\">" + cells + "</Topology>\n";
    still_arrays_ = cell_array("element", "Scalar", element) + cell_array("material", "Scalar", material);
  }

  void write_frame(std::uint64_t frame) {
    const std::vector<double> u = frames_.displacement(frame), fraction = frames_.row("broken", frame, 1);
    std::vector<float> displacement, broken;
    for (const std::int32_t e : still_.element) {
      append(displacement, vector_at(u, static_cast<std::size_t>(e)));
      broken.push_back(static_cast<float>(nth(fraction, e)));
    }
    const std::string group = "/frames/" + std::to_string(frame) + "/";
    const std::string points = write(group + "points", vertices_at(frames_, frame, still_), 3, {"m", "vertices, relative to /origin"});
    const std::string share = write(group + "broken", broken, 1, {"1", "fraction of the element's bonds that are broken"});
    const std::string way =
        write(group + "displacement", displacement, 3, {"m", "of the element's centroid from the reference configuration"});
    grids_ += "<Grid Name=\"house\" GridType=\"Uniform\">\n" + time_element(frames_.times()[frame]) + topology_ +
              "<Geometry GeometryType=\"XYZ\">" + points + "</Geometry>\n" + still_arrays_ + cell_array("broken", "Scalar", share) +
              cell_array("displacement", "Vector", way) + "</Grid>\n";
  }

  [[nodiscard]] std::string xdmf() const {
    return "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
           "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n" +
           geometry::printed("<Information Name=\"origin\" Value=\"%.17g %.17g %.17g\"/>\n", origin_.x, origin_.y, origin_.z) + grids_ +
           "</Grid>\n</Domain>\n</Xdmf>\n";
  }

 private:
  /// Writes rows of `width`, and returns the item that refers to them.
  template <class T>
  std::string write(const std::string& path, const std::vector<T>& values, std::uint64_t width, const Hdf5Note& note) {
    const std::uint64_t rows = values.size() / width;
    const Shape shape = width == 1 ? Shape{rows} : Shape{rows, width};
    file_.write_dataset(path, Hdf5TypeOf<T>::value, shape, values.data(), {rows, false, kDeflate}, note);
    return item(path, shape, std::is_same_v<T, float> ? "Float" : "Int");
  }

  Hdf5File& file_;
  const FrameReader& frames_;
  const Still& still_;
  Vec3 origin_;
  std::string topology_, still_arrays_, grids_;  // pieces of XDMF
};

}  // namespace

void write_paraview(const std::string& folder, bool overwrite) {
  const std::string xdmf = folder + "/run.xdmf", data = folder + "/" + kData;
  const Output description{xdmf, FileKind::xdmf, "--paraview", overwrite};
  for (const Output& output : {description, Output{data, FileKind::hdf5, "--paraview", overwrite}}) refuse_to_replace(output);
  const Hdf5File run = open_run(folder + "/run.h5");
  const FrameReader frames(run);
  if (frames.frames() == 0) throw FileError(run.path(), "holds no frames");
  const Still still = read_still(run, frames.elements());
  std::string text;
  const auto fill = [&](Hdf5File& file) {
    ParaviewWriter out(file, frames, still, origin_of_run(run));
    out.write_still();
    for (std::uint64_t f = 0; f < frames.frames(); ++f) out.write_frame(f);
    text = out.xdmf();
  };
  write_file(data, fill, own_temporary(data));
  write_output(description, text);
}

}  // namespace voussoir::io
