// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/stones/stone_file.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

// What OBJ has besides vertices, faces and names: normals, textures, materials, lines, points, how it is drawn, parts of free forms.
constexpr std::array<std::string_view, 36> kNoSolids{
    "vn",       "vt",       "vp",   "s",          "mg",        "l",     "p",     "usemtl", "mtllib", "usemap", "maplib", "bevel",
    "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech", "stech", "cstype", "deg",    "bmat",   "step",   "parm",
    "trim",     "hole",     "scrv", "sp",         "end",       "con",   "res",   "bzp",    "bsp",    "cdc",    "cdp",    "csh"};

class ObjReader {
 public:
  ObjReader(const std::string& path, std::string_view text) : path_(path), lines_(text) {}

  StoneFile read() {
    std::string joined;
    while (const auto next = lines_.next()) {
      std::string_view line = *next;
      if (!line.empty() && line.back() == '\\') {  // continued in the next line
        joined.append(line.substr(0, line.size() - 1)).push_back(' ');
        continue;
      }
      if (!joined.empty()) {
        joined.append(line);
        line = joined;
      }
      read_line(line.substr(0, line.find('#')));
      joined.clear();
    }
    if (!joined.empty()) fault("ends within a line that is to go on: it was cut; export it again");
    return std::move(*this).finish();
  }

 private:
  [[noreturn]] void fault(const std::string& what) const { throw FileError(path_, lines_.line(), what); }

  void read_line(std::string_view line) {
    Words words(line);
    const std::string_view key = words.next();
    if (key == "v") {
      vertices_.push_back(read_vertex(words));
    } else if (key == "f" || key == "fo") {
      read_face(words);
    } else if (key == "o") {
      begin_object(std::string(trimmed(words.rest())));
    } else if (key == "g") {
      begin_groups(std::string(trimmed(words.rest())));
    } else if (key == "curv" || key == "surf" || key == "curv2") {
      fault("holds free-form curves or surfaces, which are no solids of plane faces; export it as a mesh");
    } else if (!key.empty() && std::ranges::find(kNoSolids, key) == kNoSolids.end()) {
      unknown_.add(lines_.line(), key);
    }
  }

  Vec3 read_vertex(Words& words) {
    double x[3];
    for (double& value : x) {
      const std::string_view word = words.next();
      const auto number = finite_number(word);
      if (!number) fault(shown(word) + " is no finite number; wanted: v x y z");
      value = *number;
    }
    return {x[0], x[1], x[2]};
  }

  void begin_object(std::string name) {
    if (name.empty()) fault("an object without a name; wanted: o NAME");
    if (const auto [at, is_new] = objects_.emplace(name, lines_.line()); !is_new)
      fault("the name " + quoted_word(name) + " stands twice, first in line " + std::to_string(at->second) + "; give each stone its own");
    object_ = std::move(name);
    current_ = nullptr;
  }

  /// Sets the groups of the following faces. Several words are several groups; but many programs write one name with blanks, so the whole
  /// text is also a group, and the first.
  void begin_groups(const std::string& names) {
    groups_.clear();
    Words words(names);
    for (std::string_view name = words.next(); !name.empty(); name = words.next()) groups_.emplace_back(name);
    if (groups_.size() > 1) groups_.insert(groups_.begin(), names);
    current_ = nullptr;
  }

  void read_face(Words& words) {
    Solid& solid = current();
    std::vector<std::int32_t> loop;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const std::string_view number = word.substr(0, word.find('/'));
      long index = 0;
      const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
      const auto count = static_cast<long>(vertices_.size());
      if (error != std::errc() || end != number.data() + number.size() || index == 0) fault(shown(word) + " is no number of a vertex");
      const long at = index > 0 ? index - 1 : count + index;
      if (at < 0 || at >= count)
        fault("vertex " + std::to_string(index) + " of a face is not there; so far there are " + std::to_string(count));
      loop.push_back(solid.add(static_cast<std::int32_t>(at), vertices_));
    }
    if (loop.size() < 3) fault("a face of " + std::to_string(loop.size()) + " corners; wanted: 3 or more");
    solid.of.mesh.faces.push_back(std::move(loop));
  }

  /// A solid being read, with the indices of its vertices.
  struct Solid {
    FileSolid of;
    std::map<std::int32_t, std::int32_t> number;
    std::set<std::string> in_groups;
    std::int32_t add(std::int32_t vertex, const std::vector<Vec3>& all) {
      const auto [at, is_new] = number.try_emplace(vertex, static_cast<std::int32_t>(of.mesh.vertices.size()));
      if (is_new) of.mesh.vertices.push_back(nth(all, vertex));
      return at->second;
    }
  };

  Solid& current() {
    if (current_ != nullptr) return *current_;
    const std::string key = !object_.empty() ? "o" + object_ : groups_.empty() ? "" : "g" + groups_.front();
    const auto [at, is_new] = by_key_.try_emplace(key, solids_.size());
    if (is_new) {
      solids_.emplace_back();
      FileSolid& s = solids_.back().of;
      s.name = key.empty() ? "" : key.substr(1);
      s.whole = !key.empty();
    }
    current_ = &solids_[at->second];
    for (const std::string& g : groups_) {
      if (g != current_->of.name && current_->in_groups.insert(g).second) current_->of.groups.push_back(g);
    }
    return *current_;
  }

  StoneFile finish() && {
    if (solids_.empty()) throw FileError(path_, "holds no faces");
    StoneFile out;
    for (Solid& s : solids_) out.solids.push_back(std::move(s.of));
    unknown_.tell("OBJ", out.doubts);
    // A name before all others, or a single group added by an exporter, does not separate stones.
    if (out.solids.size() == 1 && objects_.empty()) out.solids[0].whole = false;
    return out;
  }

  const std::string& path_;
  LineReader lines_;
  UnknownLines unknown_;
  std::vector<Vec3> vertices_;
  std::map<std::string, long> objects_;  // with their line numbers
  std::string object_;
  std::vector<std::string> groups_;
  std::vector<Solid> solids_;
  std::map<std::string, std::size_t> by_key_;
  Solid* current_ = nullptr;
};

}  // namespace

StoneFile read_obj(const std::string& path, std::string_view text) { return ObjReader(path, text).read(); }

}  // namespace voussoir::io
