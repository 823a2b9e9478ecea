// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/stills.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <span>

#include "cases/input_error.h"
#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/input/files/output_path.h"
#include "io/input/files/packed_text.h"
#include "io/input/files/scratch_folder.h"
#include "io/input/files/whole_file.h"
#include "io/output/replay/run_file.h"
#include "io/output/report/pictures/browser.h"
#include "io/output/report/report_data.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

constexpr int kWidth = 1600, kHeight = 1000;  // pixels

struct ShownStill {
  std::string view;
  Output output;
  double time;  // s
};

void check_times(const std::string& run, const std::vector<double>& times) {
  const std::vector<double> frames = open_run(run).read<double>("/frames/time");
  if (frames.empty()) throw FileError(run, "holds no frames");
  // A picture shows the nearest frame. The run may end after the last frame, by less than the frame interval.
  const double interval = frames.size() > 1 ? frames[1] - frames[0] : 0.0;
  for (const double t : times)
    if (!(t >= frames.front() && t < frames.back() + std::max(interval, 1e-9)))
      throw cases::InputError("--stills", cases::text(t) + " s is not in the run; allowed: " + cases::text(frames.front()) + " to " +
                                              cases::text(frames.back()) +
                                              " s, where its last frame stands, or by less than a frame later");
}

std::vector<ShownStill> planned(const StillsOptions& o) {
  std::vector<ShownStill> all;
  for (const std::string& view : o.views)
    for (const double t : o.times) {
      const std::string file = o.folder + "/" + view + "-" + cases::text(t) + "s.png";
      all.push_back({view, {file, FileKind::picture, "--stills", o.overwrite}, t});
      refuse_to_replace(all.back().output);
    }
  return all;
}

void take(Browser& browser, const ShownStill& s) {
  const std::string size = std::to_string(kWidth) + ", " + std::to_string(kHeight);
  const std::string png =
      browser.evaluate("opened.then((report) => report.still(" + cases::text(s.time) + ", \"" + s.view + "\", " + size + "))");
  const std::vector<std::byte> bytes = from_base64(png);
  write_output(s.output, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  std::printf("%s\n", s.output.path.c_str());
}

/// A page in a separate browser, which draws frames only on request.
class Studio {
 public:
  explicit Studio(const std::string& html) : browser(scratch_.path()) {
    const std::string page = scratch_.path() + "/page.html";
    write_text_file(page, html);
    browser.open(page, "still");
  }

 private:
  ScratchFolder scratch_;

 public:
  Browser browser;
};

}  // namespace

void write_stills(const std::vector<std::string>& runs, const StillsOptions& o) {
  check_times(runs.front(), o.times);
  const std::vector<ShownStill> stills = planned(o);
  Studio studio(report_html(runs));
  std::error_code fault;
  fs::create_directories(o.folder, fault);
  if (fault) throw FileError(o.folder, "cannot make the folder: " + fault.message());
  for (const ShownStill& s : stills) take(studio.browser, s);
}

void write_still(const std::string& html, const std::string& view, const Output& picture) {
  Studio studio(html);
  take(studio.browser, {view, picture, 0.0});
}

std::string view_names() {
  std::string text;
  for (const std::string& name : kViews) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace voussoir::io
