// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/stills.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "cases/input_error.h"
#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/input/files/output_path.h"
#include "io/input/files/packed_text.h"
#include "io/input/files/scratch_folder.h"
#include "io/input/files/whole_file.h"
#include "io/input/messages/messages.h"
#include "io/output/replay/run_file.h"
#include "io/output/report/pictures/browser.h"
#include "io/output/report/pictures/plain/plain_scene.h"
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
      if (std::ranges::any_of(all, [&](const ShownStill& s) { return s.output.path == file; })) continue;  // asked for twice
      all.push_back({view, {file, FileKind::picture, "--stills", o.overwrite}, t});
      refuse_to_replace(all.back().output);
    }
  return all;
}

void write_picture(const ShownStill& s, std::string_view png) {
  write_output(s.output, png);
  std::printf("%s\n", s.output.path.c_str());
}

void take(Browser& browser, const ShownStill& s) {
  const std::string size = std::to_string(kWidth) + ", " + std::to_string(kHeight);
  const std::string png =
      browser.evaluate("opened.then((report) => report.still(" + cases::text(s.time) + ", \"" + s.view + "\", " + size + "))");
  const std::vector<std::byte> bytes = from_base64(png);
  write_picture(s, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void draw(const PlainScene& scene, const ShownStill& s) { write_picture(s, png_of(scene.picture(s.view, s.time, kWidth, kHeight))); }

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

/// The page in a browser. \return nothing where there is no browser, which is said
std::unique_ptr<Studio> studio_for(const std::string& html) {
  try {
    return std::make_unique<Studio>(html);
  } catch (const NoBrowser&) {
    say_note("no Chromium was found: pictures are plain, with no title, scale, legend or ties");
    return nullptr;
  }
}

}  // namespace

void write_stills(const std::vector<std::string>& runs, const StillsOptions& o) {
  const bool pair = runs.size() > 1;
  if (o.plain && pair) throw cases::InputError("--plain", "is of pictures of one run, not of two");
  check_times(runs.front(), o.times);
  const std::vector<ShownStill> stills = planned(o);
  const std::unique_ptr<Studio> studio = o.plain ? nullptr
                                         : pair  ? std::make_unique<Studio>(report_html(runs))
                                                 : studio_for(report_html(runs));
  std::error_code fault;
  fs::create_directories(o.folder, fault);
  if (fault) throw FileError(o.folder, "cannot make the folder: " + fault.message());
  if (studio) {
    for (const ShownStill& s : stills) take(studio->browser, s);
    return;
  }
  const Hdf5File run = open_run(runs.front());
  const PlainScene scene(run);
  for (const ShownStill& s : stills) draw(scene, s);
}

void write_still(const ModelPicture& picture, const Output& output) {
  const ShownStill still{picture.view, output, 0.0};
  if (const std::unique_ptr<Studio> studio = picture.plain ? nullptr : studio_for(model_html(picture.run, picture.text, picture.faults)))
    return take(studio->browser, still);
  const Hdf5File run = open_run(picture.run);
  draw(PlainScene(run, picture.faults), still);
}

std::string view_names() {
  std::string text;
  for (const std::string& name : kViews) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace voussoir::io
