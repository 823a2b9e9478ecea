// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_data.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include "cases/case.h"
#include "geometry/message.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/input/files/packed_text.h"
#include "io/input/files/sealed_file.h"
#include "io/input/messages/messages.h"
#include "io/output/replay/covered_faces.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/joint_cracks.h"
#include "io/output/replay/opened_faces.h"
#include "io/output/replay/run_file.h"
#include "io/output/report/damage/report_cracks.h"
#include "io/output/report/damage/report_loads.h"
#include "io/output/report/damage/report_ties.h"
#include "io/output/report/report_bodies.h"
#include "io/output/report/report_facts.h"
#include "io/output/report/report_frames.h"
#include "io/output/report/report_model.h"
#include "io/output/report/report_modes.h"
#include "io/output/report/report_page.h"
#include "io/output/results/case_of_run.h"

namespace voussoir::io {
namespace {

/// HTML elements whose ids begin with a prefix.
class Scripts {
 public:
  explicit Scripts(std::string prefix) : prefix_(std::move(prefix)) {}
  void put(const char* type, const std::string& id, const std::string& content) {
    text += "<script type=\"" + std::string(type) + "\" id=\"" + prefix_ + id + "\">" + content + "</script>\n";
  }
  template <class T>
  void put(const std::string& id, const std::vector<T>& values) {
    put("text/plain", id, packed(std::span<const T>(values)));
  }
  std::string text;

 private:
  std::string prefix_;
};

/// Rows of `width` bytes as differences from the row before, modulo 256.
std::vector<std::uint8_t> steps(std::vector<std::uint8_t> rows, std::size_t width) {
  for (std::size_t i = rows.size(); i-- > width;) rows[i] = static_cast<std::uint8_t>(rows[i] - rows[i - width]);
  return rows;
}

/// Adds the mechanism; omitted for a run whose case this program cannot read.
void put_bodies(Scripts& out, const Hdf5File& file, const FrameReader& reader) {
  try {
    const ReportBodies bodies = report_bodies(file, reader);
    out.put("application/json", "bodies", bodies.json);
    out.put("body-ids", steps(bodies.id, static_cast<std::size_t>(reader.elements())));
  } catch (const DamagedFile&) {
    throw;
  } catch (const FileError& e) {
    say_warning(std::string("the page has no mechanism: ") + e.what(), "");
  }
}

/// Adds where ties, and bars of decks and meshes, begin and end; omitted for a model without.
void put_ties(Scripts& out, const Hdf5File& file) {
  if (file.exists("/model/tie_ends") && file.shape("/model/tie_ends")[0] > 0) {
    out.put("tie-ends", file.read<float>("/model/tie_ends"));
    out.put("tie-elements", file.read<std::int32_t>("/model/tie_element"));
    out.put("tie-lives", tie_ends_of_life(file));
  }
  if (file.exists("/model/mesh_bar_ends") && file.shape("/model/mesh_bar_ends")[0] > 0) {
    out.put("mesh-bar-ends", file.read<float>("/model/mesh_bar_ends"));
    out.put("mesh-bar-elements", file.read<std::int32_t>("/model/mesh_bar_element"));
    out.put("mesh-bar-breaking", file.read<float>("/model/mesh_bar_breaking"));
  }
}

/// Adds the cracks at the end and their maps; omitted for a run whose case this program cannot read.
void put_cracks(Scripts& out, const Hdf5File& file, const FrameReader& reader) {
  try {
    const std::string cracks = report_cracks(file, case_of_run(file), reader);
    if (!cracks.empty()) out.put("crack-list", std::vector<char>(cracks.begin(), cracks.end()));
  } catch (const DamagedFile&) {
    throw;
  } catch (const std::exception& e) {
    say_warning(std::string("the page has no table of cracks: ") + e.what(), "");
  }
}

void put_modes(Scripts& out, const Hdf5File& file, const FrameReader& reader, const std::vector<solver::Mode>& modes) {
  if (modes.empty()) return;
  if (modes.front().displacement.size() != reader.elements())
    throw FileError(file.path(), "its case makes " + std::to_string(modes.front().displacement.size()) + " elements, and not the " +
                                     std::to_string(reader.elements()) + " of the run: no modes");
  const ReportModes packed_modes = report_modes(modes);
  out.put("application/json", "modes", packed_modes.json);
  out.put("mode-shapes", packed_modes.shape);
}

}  // namespace

std::string report_data(const std::string& run, const std::string& prefix, const std::vector<solver::Mode>& modes) {
  const Hdf5File file = open_run(run);
  const FrameReader reader(file, frames_apart(file.shape("/model/element/mass")[0], file.shape("/frames/time")[0]));
  const PackedFrames frames = pack_frames(file, reader);
  const ReportFacts facts = report_facts(file, reader, frames.quantum);
  const CoveredFaces covered = covered_faces(file, reader.frames() == 0 ? DryJoints::cover : DryJoints::open);
  const JointCracks cracks = joint_cracks(file, reader);
  const OpenedFaces opened = opened_faces(file, cracks.shown);
  Scripts out(prefix);
  out.put("application/json", "facts", facts.json);
  out.put("curves", std::vector<char>(facts.plots.begin(), facts.plots.end()));
  out.put("vertices", file.read<float>("/model/vertex"));
  out.put("cells", file.read<std::int32_t>("/model/cells"));
  out.put("cell-types", file.read<std::uint8_t>("/model/cell_type"));
  out.put("cell-elements", file.read<std::int32_t>("/model/cell_element"));
  out.put("centroids", file.read<float>("/model/element/position0"));
  out.put("parts", facts.part);
  out.put("materials", facts.material);
  out.put("covered-elements", covered.element);
  out.put("covered-normals", covered.normal);
  out.put("opened-elements", opened.element);
  out.put("opened-normals", opened.normal);
  out.put("opened-times", opened.time);
  out.put("crack-elements", cracks.elements);
  out.put("crack-edges", cracks.edges);
  out.put("crack-ends", cracks.ends);
  out.put("crack-levels", steps(cracks.level, cracks.edges.size()));
  if (const std::vector<std::int32_t> loops = polyhedron_loops(file); !loops.empty()) out.put("loops", loops);
  put_bodies(out, file, reader);
  put_cracks(out, file, reader);
  if (const std::string loads = report_loads(file, reader); !loads.empty()) out.put("loads", std::vector<char>(loads.begin(), loads.end()));
  put_ties(out, file);
  put_modes(out, file, reader, modes);
  out.put("turn-shifts", frames.shift);
  out.put("text/plain", "frames", frames.text);
  return out.text;
}

std::string model_html(const std::string& run, const std::string& fault, const std::vector<std::int32_t>& faults) {
  const ReportPage page = report_page();
  const ReportModel model = report_model(open_run(run), fault, faults);
  Scripts out("");
  out.put("application/json", "model", safe_json(model.json));
  out.put("fixed", model.fixed);
  out.put("joint-laws", model.edge_law);
  out.put("joint-ends", model.joint_ends);
  return std::string(page.head).append(report_data(run)).append(out.text).append(page.tail);
}

std::string live_html(const std::string& run, double every) {
  const ReportPage page = report_page();
  Scripts out("");
  out.put("application/json", "live", geometry::printed("%g", every));
  return std::string(page.head).append(report_data(run)).append(out.text).append(page.tail);
}

std::string report_html(const std::vector<std::string>& runs, const std::vector<solver::Mode>& modes) {
  const ReportPage page = report_page();
  std::string html(page.head);
  for (std::size_t i = 0; i < runs.size(); ++i) html += i == 0 ? report_data(runs[i], "", modes) : report_data(runs[i], "second-");
  return html.append(page.tail);
}

}  // namespace voussoir::io
