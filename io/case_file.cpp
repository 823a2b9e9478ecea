// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/case_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "io/case_tables.h"
#include "io/case_tree.h"
#include "io/catalogue.h"
#include "io/errors.h"

namespace voussoir::io {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargest = 16U << 20U;  // bytes

std::string place_of(const CaseText& text, const std::vector<std::string>& overrides, Source source) {
  if (source.set >= 0) return "--set " + overrides[static_cast<std::size_t>(source.set)];
  return text.path + ":" + std::to_string(source.line);
}

CaseText read_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw FileError(path, "no such file");
  if (fs::is_directory(status)) throw FileError(path, "is a folder, wanted a case file (.toml)");
  if (!fs::is_regular_file(status)) throw FileError(path, "is not a regular file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw FileError(path, error.message());
  if (size > kLargest) throw FileError(path, "has " + std::to_string(size) + " bytes; a case file may have 16 MB");
  std::ifstream in(path, std::ios::binary);
  std::string text(size, '\0');
  if (!in || !in.read(text.data(), static_cast<std::streamsize>(size))) throw FileError(path, "cannot be read");
  const std::string folder = fs::path(path).parent_path().string();
  return {path, std::move(text), folder.empty() ? "." : folder};
}

/// The catalogue's text, if the name can be one of the catalogue.
CaseText find_case(const std::string& name) {
  std::error_code error;
  if (name.find('/') != std::string::npos || name.ends_with(".toml")) return read_file(name);
  const std::vector<CatalogueEntry> entries = catalogue();
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const CatalogueEntry& e) { return e.name == name; });
  if (entry != entries.end()) return {entry->path, entry->text, entry->folder};
  if (fs::exists(name, error)) return read_file(name);

  std::vector<std::string> names;
  for (const CatalogueEntry& e : entries) names.push_back(e.name);
  const std::string near = nearest(name, names);
  const std::string problem = "case \"" + name + "\" is neither in the catalogue nor a file; " +
                              (near.empty() ? "" : "did you mean \"" + near + "\"? ") + "The catalogue: " + joined(names);
  throw CaseFileError(problem, "", problem, 0);
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
  Node document;
  try {
    document = parse_document(text.text);
  } catch (const SyntaxError& e) {
    const std::string where = text.path + ":" + std::to_string(e.line()) + ":" + std::to_string(e.column());
    throw CaseFileError(where + ": " + e.what(), "", e.what(), e.line());
  }
  apply_overrides(document, overrides);

  LoadedCase loaded;
  loaded.path = text.path;
  loaded.value.folder = text.folder;
  Reading reading;
  read_table(case_table(), document, loaded.value, reading, "");
  if (const auto& fault = reading.first()) {
    const std::string problem = sentence_of(fault->key, fault->value, fault->problem);
    throw CaseFileError(place_of(text, overrides, fault->source) + ": " + problem, fault->key, fault->problem, fault->source.line);
  }
  for (const auto& [key, known] : reading.known()) loaded.keys[key] = {place_of(text, overrides, known.source), known.value};
  return loaded;
}

LoadedCase load_case(const std::string& name_or_path, const std::vector<std::string>& overrides) {
  return read_case(find_case(name_or_path), overrides);
}

}  // namespace voussoir::io
