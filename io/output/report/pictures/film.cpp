// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/film.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

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
#include "io/output/report/pictures/child_input.h"
#include "io/output/report/report_data.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSize = "1280, 720";  // pixels
constexpr const char* kHint =
    "films are put together by ffmpeg; install it (Debian: ffmpeg), or name its program in the environment variable FFMPEG";

/// Options of ffmpeg by the extension of the film.
std::vector<std::string> coding(const std::string& file) {
  const std::string kind = fs::path(file).extension().string();
  if (kind == ".mp4") return {"-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
  if (kind == ".webm")
    return {"-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-deadline", "realtime", "-cpu-used", "8", "-pix_fmt", "yuv420p"};
  if (kind == ".gif") return {"-vf", "fps=12,scale=800:-1:flags=lanczos,split[a][b];[a]palettegen[p];[b][p]paletteuse"};
  throw cases::InputError("--film", "'" + file + "' is of no known kind; allowed: .mp4, .webm, .gif");
}

std::vector<std::string> command(const FilmOptions& o, const std::string& to) {
  const char* chosen = std::getenv("FFMPEG");
  std::vector<std::string> words{chosen != nullptr && *chosen != '\0' ? chosen : "ffmpeg"};
  for (const char* w : {"-nostdin", "-loglevel", "error", "-f", "image2pipe", "-c:v", "mjpeg", "-framerate"}) words.emplace_back(w);
  words.push_back(std::to_string(o.rate));
  for (const char* w : {"-i", "pipe:0"}) words.emplace_back(w);
  for (const std::string& w : coding(o.file)) words.push_back(w);
  words.push_back(to);
  return words;
}

struct Stretch {
  double from = 0, until = 0;  // s
};
/// Time range from the first frame of all runs to the last.
Stretch stretch_of(const std::vector<std::string>& runs) {
  Stretch all{1e300, -1e300};
  for (const std::string& run : runs) {
    const auto times = open_run(run).read<double>("/frames/time");
    if (times.empty()) throw FileError(run, "holds no frames");
    all = {std::min(all.from, times.front()), std::max(all.until, times.back())};
  }
  return all;
}

}  // namespace

void write_film(const std::vector<std::string>& runs, const FilmOptions& o) {
  coding(o.file);
  const Output film{o.file, FileKind::film, "--film", o.overwrite};
  check_output(film);
  const Stretch time = stretch_of(runs);
  const ScratchFolder scratch;
  const std::string made = scratch.path() + "/film" + fs::path(o.file).extension().string();
  ChildInput ffmpeg(command(o, made), scratch.path() + "/ffmpeg.log", kHint);
  Browser browser(scratch.path());
  const std::string page = scratch.path() + "/page.html";
  write_text_file(page, report_html(runs));
  browser.open(page, "still&film");
  const double step = o.speed / o.rate;
  const auto pictures = static_cast<long>(std::floor((time.until - time.from) / step + 1e-6)) + 1;
  const auto at = [&](long i) { return cases::text(time.from + static_cast<double>(i) * step); };
  for (long i = 0; i < pictures; ++i) {
    const std::string view = i == 0 ? "\"" + o.view + "\"" : "null", next = i + 1 < pictures ? ", " + at(i + 1) : "";
    ffmpeg.write(from_base64(browser.evaluate("opened.then((report) => report.shot(" + at(i) + ", " + view + ", " + kSize + next + "))")));
  }
  ffmpeg.finish();
  check_output(film);
  const std::string beside = own_temporary(o.file);
  std::error_code none;
  if (!fs::copy_file(made, beside, fs::copy_options::overwrite_existing, none)) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw FileError(o.file, "cannot be written: " + none.message());
  }
  replace_file(beside, o.file);
  std::printf("%s  %ld pictures, %.1f s, %.1f MB\n", o.file.c_str(), pictures, static_cast<double>(pictures) / o.rate,
              1e-6 * static_cast<double>(fs::file_size(o.file)));
}

}  // namespace voussoir::io
