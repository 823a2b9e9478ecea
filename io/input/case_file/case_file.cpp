// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_file.h"

#include <algorithm>
#include <array>

#include "cases/input_error.h"
#include "cases/model.h"
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

std::vector<Described> described(const LoadedCase& c, const cases::InputErrors& errors) {
  std::vector<Described> all;
  for (const cases::InputError& one : errors.all()) all.push_back(described(c, one));
  return all;
}

/// Whether no element, joint or tie of the model depends on the value of the key.
bool is_beside_the_model(const std::string& key) {
  if (key.find("].motion") != std::string::npos) return true;  // of a block or a part of the base
  const std::string table = key.substr(0, key.find_first_of(".["));
  constexpr std::array kTables{"analysis", "damping", "gravity", "motion", "output", "time", "title"};
  return std::ranges::find(kTables, table) != kTables.end();
}

/// What else is at fault: of the model, if all faults of reading are beside it. Stones, which are in other files, are left out.
std::vector<Described> faults_of_model(const std::vector<Fault>& faults, const LoadedCase& loaded) {
  const bool beside = std::ranges::all_of(faults, [](const Fault& f) { return is_beside_the_model(f.key); });
  const cases::Case& c = loaded.value;
  const bool has_blocks = c.house || !c.walls.empty() || !c.blocks.empty();
  if (!beside || !has_blocks || !c.stones.empty()) return {};
  std::vector<Described> all;
  try {
    (void)cases::build_model(c);
  } catch (const cases::InputErrors& several) {
    all = described(loaded, several);
  } catch (const cases::InputError& one) {
    all = {described(loaded, one)};
  }
  std::erase_if(all, [&](const Described& d) {  // the same place was at fault when it was read
    return std::ranges::any_of(faults,
                               [&](const Fault& f) { return f.key.starts_with(d.message.key) || d.message.key.starts_with(f.key); });
  });
  return all;
}

[[noreturn]] void refuse(const std::vector<Fault>& faults, const Document& document, const std::vector<std::string>& overrides,
                         const LoadedCase& loaded) {
  std::vector<Described> all = faults_of_model(faults, loaded);
  for (const Fault& fault : faults)
    all.push_back({fault.source,
                   {.text = place_of(document, overrides, fault.source) + ": " + sentence_of(fault.key, fault.value, fault.problem),
                    .file = file_of(document, fault.source),
                    .line = fault.source.line,
                    .key = fault.key,
                    .value = fault.value,
                    .allowed = fault.allowed}});
  std::ranges::stable_sort(all, [](const Described& a, const Described& b) { return a.source.before(b.source); });
  std::vector<Message> messages;
  for (Described& d : all) messages.push_back(std::move(d.message));
  throw CaseFileError(messages, faults.front().problem);
}

}  // namespace

CaseFileError::CaseFileError(std::vector<Message> faults, const std::string& problem)
    : InputError(faults.front().key, problem), faults_(std::move(faults)), message_(lines_of(faults_)) {}

std::string LoadedCase::describe(const cases::InputError& error) const { return lines_of(messages(error)); }

std::vector<Message> LoadedCase::messages(const cases::InputError& error) const {
  const auto* several = dynamic_cast<const cases::InputErrors*>(&error);
  std::vector<Described> all;
  if (several == nullptr)
    all.push_back(described(*this, error));
  else
    all = described(*this, *several);
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
  for (const auto& [key, known] : reading.known()) {
    const bool included = known.source.set < 0 && (known.source.file > 0 || text.built_in);
    loaded.keys[key] = {known.source, place_of(document, overrides, known.source), file_of(document, known.source), known.value, included};
  }
  if (reading.faults() > 0) refuse(reading.all(), document, overrides, loaded);
  for (const Fault& d : reading.doubts())
    loaded.findings.push_back(place_of(document, overrides, d.source) + ": " + sentence_of(d.key, d.value, d.problem));
  if (const std::string note = inherited_values(loaded); !note.empty()) loaded.findings.push_back(note);
  return loaded;
}

LoadedCase load_case(const std::string& name_or_path, const std::vector<std::string>& overrides) {
  return read_case(find_case(name_or_path), overrides);
}

}  // namespace voussoir::io
