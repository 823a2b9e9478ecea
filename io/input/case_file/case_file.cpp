// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_file.h"

#include <algorithm>

#include "cases/input_error.h"
#include "geometry/nth.h"
#include "io/input/case_file/case_document.h"
#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/inherited_values.h"
#include "io/input/files/errors.h"

namespace voussoir::io {
namespace {

std::string place_of(const Document& document, const std::vector<std::string>& overrides, Source source) {
  if (source.set >= 0) return "--set " + nth(overrides, source.set);
  return nth(document.files, source.file) + ":" + std::to_string(source.line);
}

/// The path without its last step: "a.b[1].c" → "a.b[1]" → "a.b" → "a" → "".
std::string parent_of(const std::string& path) {
  const std::size_t end = path.find_last_of(".[");
  return end == std::string::npos ? "" : path.substr(0, end);
}

/// An error with its place.
struct Described {
  Source source;
  std::string text;
};

Described described(const LoadedCase& c, const cases::InputError& error) {
  if (error.key().empty()) return {{}, c.path + ": " + error.problem()};
  if (const auto it = c.keys.find(error.key()); it != c.keys.end()) {
    return {it->second.source, it->second.where + ": " + sentence_of(error.key(), it->second.value, error.problem())};
  }
  const std::string message = sentence_of(error.key(), "", error.problem());
  for (std::string at = parent_of(error.key()); !at.empty(); at = parent_of(at)) {
    if (const auto it = c.keys.find(at); it != c.keys.end()) return {it->second.source, it->second.where + ": " + message};
  }
  return {{}, c.path + ": " + message};
}

/// All faults of a text, a line each.
[[noreturn]] void refuse(const std::vector<Fault>& faults, const Document& document, const std::vector<std::string>& overrides) {
  std::vector<std::string> lines;
  for (const Fault& fault : faults)
    lines.push_back(place_of(document, overrides, fault.source) + ": " + sentence_of(fault.key, fault.value, fault.problem));
  const Fault& first = faults.front();
  throw CaseFileError(joined(lines, "\n"), first.key, first.problem, first.source.line);
}

}  // namespace

std::string LoadedCase::describe(const cases::InputError& error) const {
  const auto* several = dynamic_cast<const cases::InputErrors*>(&error);
  if (several == nullptr) return described(*this, error).text;
  std::vector<Described> all;
  for (const cases::InputError& one : several->all()) all.push_back(described(*this, one));
  std::ranges::stable_sort(all, [](const Described& a, const Described& b) { return a.source.before(b.source); });
  std::vector<std::string> lines;
  for (const Described& d : all) lines.push_back(d.text);
  return joined(lines, "\n");
}

LoadedCase read_case(const CaseText& text, const std::vector<std::string>& overrides) {
  Document document = read_document(text);
  LoadedCase loaded;
  loaded.notes = apply_overrides(document.root, overrides);
  loaded.path = text.path;
  loaded.value.folder = text.folder;
  Reading reading;
  read_table(case_table(), document.root, loaded.value, reading, "");
  if (reading.faults() > 0) refuse(reading.all(), document, overrides);
  for (const auto& [key, known] : reading.known()) {
    const bool included = known.source.set < 0 && (known.source.file > 0 || text.built_in);
    loaded.keys[key] = {known.source, place_of(document, overrides, known.source), known.value, included};
  }
  for (const Fault& d : reading.doubts())
    loaded.findings.push_back(place_of(document, overrides, d.source) + ": " + sentence_of(d.key, d.value, d.problem));
  if (const std::string note = inherited_values(loaded); !note.empty()) loaded.findings.push_back(note);
  return loaded;
}

LoadedCase load_case(const std::string& name_or_path, const std::vector<std::string>& overrides) {
  return read_case(find_case(name_or_path), overrides);
}

}  // namespace voussoir::io
