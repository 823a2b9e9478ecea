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
  Message message;
};

Described at(const KeyPlace& place, Message message) {
  message.file = place.file, message.line = place.source.line;
  message.text = place.where + ": " + message.text;
  return {place.source, std::move(message)};
}

Described described(const LoadedCase& c, const cases::InputError& error) {
  if (error.key().empty()) return {{}, {.text = c.path + ": " + error.problem(), .file = c.path}};
  if (const auto it = c.keys.find(error.key()); it != c.keys.end()) {
    const std::string& value = it->second.value;
    return at(it->second, {.text = sentence_of(error.key(), value, error.problem()), .key = error.key(), .value = value});
  }
  const std::string sentence = sentence_of(error.key(), "", error.problem());
  for (std::string up = parent_of(error.key()); !up.empty(); up = parent_of(up)) {
    if (const auto it = c.keys.find(up); it != c.keys.end()) return at(it->second, {.text = sentence, .key = error.key()});
  }
  return {{}, {.text = c.path + ": " + sentence, .file = c.path, .key = error.key()}};
}

std::string lines_of(const std::vector<Message>& messages) {
  std::vector<std::string> lines;
  for (const Message& m : messages) lines.push_back(m.text);
  return joined(lines, "\n");
}

std::string file_of(const Document& document, Source source) { return source.set >= 0 ? "" : nth(document.files, source.file); }

[[noreturn]] void refuse(const std::vector<Fault>& faults, const Document& document, const std::vector<std::string>& overrides) {
  std::vector<Message> messages;
  for (const Fault& fault : faults)
    messages.push_back({.text = place_of(document, overrides, fault.source) + ": " + sentence_of(fault.key, fault.value, fault.problem),
                        .file = file_of(document, fault.source),
                        .line = fault.source.line,
                        .key = fault.key,
                        .value = fault.value,
                        .allowed = fault.allowed});
  throw CaseFileError(messages, faults.front().problem);
}

}  // namespace

CaseFileError::CaseFileError(std::vector<Message> faults, const std::string& problem)
    : InputError(faults.front().key, problem), faults_(std::move(faults)), message_(lines_of(faults_)) {}

std::string LoadedCase::describe(const cases::InputError& error) const { return lines_of(messages(error)); }

std::vector<Message> LoadedCase::messages(const cases::InputError& error) const {
  const auto* several = dynamic_cast<const cases::InputErrors*>(&error);
  std::vector<Described> all;
  if (several == nullptr) {
    all.push_back(described(*this, error));
  } else {
    for (const cases::InputError& one : several->all()) all.push_back(described(*this, one));
  }
  std::ranges::stable_sort(all, [](const Described& a, const Described& b) { return a.source.before(b.source); });
  std::vector<Message> messages;
  for (Described& d : all) messages.push_back(std::move(d.message));
  return messages;
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
    loaded.keys[key] = {known.source, place_of(document, overrides, known.source), file_of(document, known.source), known.value, included};
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
