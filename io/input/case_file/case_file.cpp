// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_file.h"

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

}  // namespace

std::string LoadedCase::describe(const cases::InputError& error) const {
  if (error.key().empty()) return path + ": " + error.problem();
  if (const auto it = keys.find(error.key()); it != keys.end()) {
    return it->second.where + ": " + sentence_of(error.key(), it->second.value, error.problem());
  }
  const std::string message = sentence_of(error.key(), "", error.problem());
  for (std::string at = parent_of(error.key()); !at.empty(); at = parent_of(at)) {
    if (const auto it = keys.find(at); it != keys.end()) return it->second.where + ": " + message;
  }
  return path + ": " + message;
}

LoadedCase read_case(const CaseText& text, const std::vector<std::string>& overrides) {
  Document document = read_document(text);
  LoadedCase loaded;
  loaded.notes = apply_overrides(document.root, overrides);
  loaded.path = text.path;
  loaded.value.folder = text.folder;
  Reading reading;
  read_table(case_table(), document.root, loaded.value, reading, "");
  if (const auto& fault = reading.first()) {
    const std::string problem = sentence_of(fault->key, fault->value, fault->problem);
    throw CaseFileError(place_of(document, overrides, fault->source) + ": " + problem, fault->key, fault->problem, fault->source.line);
  }
  for (const auto& [key, known] : reading.known()) {
    const bool included = known.source.set < 0 && (known.source.file > 0 || text.built_in);
    loaded.keys[key] = {place_of(document, overrides, known.source), known.value, included};
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
