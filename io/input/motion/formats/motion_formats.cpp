// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <span>
#include <system_error>

#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// Choice of the reader of a file, and of the component in a file.
namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

using Lines = std::span<const std::string_view>;

/// The last field of a name, which may contain commas: "228" of "Northridge-01, 1/17/1994, Rinaldi Receiving Sta, 228".
std::string last_field(const std::string& name) {
  const std::size_t comma = name.rfind(',');
  return comma == std::string::npos ? std::string() : std::string(trimmed(std::string_view(name).substr(comma + 1)));
}

std::vector<Channel> only(cases::Accelerogram a) {
  const std::string component = last_field(a.name);
  return {{component, 0, std::nullopt, std::move(a)}};
}

struct Format {
  const char* name;
  bool (*is)(Lines first_lines);
  std::vector<Channel> (*read)(const std::string& path);
};

constexpr std::size_t kFirstLines = 16;  // enough for every mark

bool any_begins(Lines lines, std::string_view word) {
  return std::any_of(lines.begin(), lines.end(), [&](std::string_view line) { return begins(line, word); });
}

/// Formats; the first that recognises a file reads it.
constexpr Format kKnown[] = {
    {"BHRC V1", [](Lines l) { return begins(l[0], "* VOL1"); }, read_bhrc},
    {"ESM ASC", [](Lines l) { return begins(l[0], "EVENT_NAME:"); }, read_esm},
    {"K-NET", [](Lines l) { return begins(l[0], "ORIGIN TIME ") && any_begins(l, "SAMPLING FREQ(HZ)"); }, read_knet},
    {"COSMOS", [](Lines l) { return holds(l[0], "(FORMAT V") && holds(l[0], "TEXT LINES"); }, read_cosmos},
    {"GeoNet V2A", [](Lines l) { return begins(l[0], "CORRECTED ACCELEROGRAM") && any_begins(l, "NUMBER OF POINTS"); }, read_geonet},
    {"CSMIP V2, USC V2", [](Lines l) { return begins(l[0], "CORRECTED ACCELEROGRAM"); }, read_csmip},
    {"PEER AT2", [](Lines l) { return l.size() > 2 && !l[2].starts_with('#') && holds(l[2], "IN UNITS OF"); },
     [](const std::string& path) { return only(read_at2(path)); }},
};

std::string format_names() {
  std::string names;
  for (const Format& f : kKnown) names += (names.empty() ? "" : ", ") + std::string(f.name);
  return names + " (known by their first lines), or two columns of time and acceleration, or one of acceleration (.csv, .txt)";
}

const Format* format_of(const std::string& path) {
  const std::string text = read_foreign_text(path, kLargestMotionFile);
  LineReader reader(text);
  std::vector<std::string_view> lines;
  while (lines.size() < kFirstLines) {
    const auto line = reader.next();
    if (!line) break;
    lines.push_back(*line);
  }
  if (lines.empty()) return nullptr;
  const auto found = std::find_if(std::begin(kKnown), std::end(kKnown), [&](const Format& f) { return f.is(lines); });
  return found == std::end(kKnown) ? nullptr : found;
}

/// A file and component from "FILE#COMPONENT", unless a file with the whole name exists.
struct Choice {
  std::string file, component;
};
Choice choice_of(const std::string& path) {
  std::error_code error;
  const std::size_t mark = path.rfind('#'), folder = path.rfind('/');
  const bool in_folder = folder != std::string::npos && mark != std::string::npos && mark < folder;
  if (mark == std::string::npos || in_folder || fs::exists(path, error)) return {path, {}};
  return {path.substr(0, mark), path.substr(mark + 1)};
}

/// The only channel for which `fits` is true.
template <class Fits>
const Channel* only_one(const std::vector<Channel>& channels, Fits fits) {
  const auto first = std::find_if(channels.begin(), channels.end(), fits);
  if (first == channels.end() || std::any_of(first + 1, channels.end(), fits)) return nullptr;
  return &*first;
}

const Channel* numbered(const std::vector<Channel>& channels, const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool good = error == std::errc{} && end == text.data() + text.size() && number >= 1 && number <= channels.size();
  return good ? &channels[number - 1] : nullptr;
}

}  // namespace

std::vector<Channel> read_motion_file(const std::string& path, const Unstated& unstated) {
  if (const Format* known = format_of(path)) return known->read(path);
  const std::string ending = upper(fs::path(path).extension().string());
  // VT2 and DT2 files go to the AT2 reader, which refuses them by the quantity in their third line.
  if (ending == ".AT2" || ending == ".VT2" || ending == ".DT2") return only(read_at2(path));
  if (ending == ".CSV" || ending == ".TXT") return only(read_motion_csv(path, unstated));
  throw FileError(path, "is in no format that is read; allowed: " + format_names());
}

std::string component_list(const std::vector<Channel>& channels) {
  std::string all;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    all += (i > 0 ? ", " : "") + ("#" + std::to_string(i + 1)) + " (" + channels[i].component + ")";
  }
  return all;
}

Channel read_channel(const std::string& path, const Unstated& unstated, char axis) {
  const Choice choice = choice_of(path);
  const std::vector<Channel> channels = read_motion_file(choice.file, unstated);
  const Channel* found = nullptr;
  if (!choice.component.empty()) {
    found = only_one(channels, [&](const Channel& c) { return upper(c.component) == upper(choice.component); });
    if (found == nullptr) found = numbered(channels, choice.component);
    if (found == nullptr) {
      throw FileError(choice.file, "no one component is " + shown("#" + choice.component) + "; allowed: " + component_list(channels));
    }
  } else {
    if (channels.size() == 1 && axis != 0 && channels[0].axis != 0 && channels[0].axis != axis) {
      throw FileError(choice.file, std::string("holds ") + channels[0].axis + " alone (" + channels[0].component + "), and " + axis +
                                       " is wanted; to take it all the same, name it: " + component_list(channels));
    }
    found = channels.size() == 1 ? &channels[0] : only_one(channels, [axis](const Channel& c) { return axis != 0 && c.axis == axis; });
    if (found == nullptr) {
      throw FileError(choice.file, "holds " + std::to_string(channels.size()) +
                                       " components; say which is wanted behind the file's name: " + component_list(channels));
    }
  }
  return *found;
}

cases::Accelerogram read_accelerogram(const std::string& path, const Unstated& unstated, char axis) {
  return read_channel(path, unstated, axis).motion;
}

}  // namespace voussoir::io
