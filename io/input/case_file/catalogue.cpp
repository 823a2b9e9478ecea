// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/catalogue.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "io/input/case_file/built_in_cases.h"
#include "io/input/document/case_tree.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"

namespace voussoir::io {
namespace {

namespace fs = std::filesystem;

/// Whether a built-in text is a ready case, and not a part that cases include or a text to begin with: those are in folders.
bool is_case(const BuiltInCase& c) { return c.name.find('/') == std::string_view::npos; }

std::string title_of(const std::string& text) {
  try {
    const Node document = parse_document(text);
    const Entry* title = find_entry(*document.as<Node::Table>(), "title");
    const auto* words = title == nullptr ? nullptr : title->node.as<std::string>();
    return words == nullptr ? "" : *words;
  } catch (const SyntaxError& e) {
    return "cannot be parsed: line " + std::to_string(e.line()) + ": " + e.what();
  }
}

CatalogueEntry built_in_entry(const BuiltInCase& c) {
  const std::string name(c.name), text(c.text);
  return {name, title_of(text), text, "catalogue/" + name + ".toml", ".", true};
}

void add_folder(const std::string& folder, std::map<std::string, CatalogueEntry>& entries) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path& path = it->path();
    if (path.extension() != ".toml" || !it->is_regular_file(error)) continue;
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in) throw FileError(path.string(), "cannot be read");
    note_input(path.string());
    const std::string name = path.stem().string();
    entries[name] = {name, title_of(text), text, path.string(), folder, false};
  }
  if (error) throw FileError(folder, "VOUSSOIR_CATALOGUE: " + error.message());
}

}  // namespace

std::vector<CatalogueEntry> catalogue() {
  std::map<std::string, CatalogueEntry> entries;
  for (const BuiltInCase& c : built_in_cases()) {
    if (is_case(c)) entries[std::string(c.name)] = built_in_entry(c);
  }
  if (const char* folder = std::getenv("VOUSSOIR_CATALOGUE"); folder != nullptr && *folder != '\0') add_folder(folder, entries);

  std::vector<CatalogueEntry> sorted;
  for (auto& [name, entry] : entries) sorted.push_back(std::move(entry));
  return sorted;
}

std::optional<CatalogueEntry> built_in_part(const std::string& name) {
  for (const BuiltInCase& c : built_in_cases()) {
    if (name == c.name || name == std::string(c.name) + ".toml") return built_in_entry(c);
  }
  return std::nullopt;
}

}  // namespace voussoir::io
