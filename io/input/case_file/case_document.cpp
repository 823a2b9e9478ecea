// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_document.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "cases/names.h"
#include "io/input/case_file/built_in_cases.h"
#include "io/input/case_file/case_paths.h"
#include "io/input/case_file/catalogue.h"
#include "io/input/document/case_values.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/motion/motion_keys.h"

namespace voussoir::io {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargest = 16U << 20U;  // bytes
constexpr std::size_t kMostFiles = 64;
constexpr std::size_t kMostNames = 1000;  // of files among which a similar one is looked for

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
  note_input(path);
  const std::string folder = fs::path(path).parent_path().string();
  return {path, std::move(text), folder.empty() ? "." : folder};
}

bool is_path(const std::string& name) { return name.find('/') != std::string::npos || name.ends_with(".toml"); }

CaseText text_of(const CatalogueEntry& entry) { return {entry.path, entry.text, entry.folder, entry.built_in}; }

/// Reads a case and the files that it includes.
class Reader {
 public:
  Node read(const CaseText& text) {
    const auto file = static_cast<int>(files_.size());
    files_.push_back(text.path);
    if (files_.size() > kMostFiles) 
      throw CaseFileError({{.text = text.path + ": more than 64 files are included", .file = text.path, .key = "include"}}, "too many files");
    open_.push_back(text.path);
    Node document = parse(text);
    set_file(document, file);
    if (file > 0 && !text.built_in) find_files_from(document, text.folder);
    Node whole = included(text, *document.as<Node::Table>());
    make_way(document, whole);
    lay_over(std::move(document), whole);
    open_.pop_back();
    return whole;
  }

  [[nodiscard]] std::vector<std::string> files() && { return std::move(files_); }

 private:
  static Node parse(const CaseText& text) {
    try {
      return parse_document(text.text);
    } catch (const SyntaxError& e) {
      const std::string where = text.path + ":" + std::to_string(e.line()) + ":" + std::to_string(e.column());
      throw CaseFileError({{.text = where + ": " + e.what(), .file = text.path, .line = e.line()}}, e.what());
    }
  }

  static void set_file(Node& node, int file) {
    node.source.file = file;
    if (auto* array = node.as<Node::Array>()) {
      for (Node& n : *array) set_file(n, file);
    }
    if (auto* table = node.as<Node::Table>()) {
      for (Entry& e : *table) set_file(e.node, file);
    }
  }

  /// Makes paths in an included case relative to its own folder, not to that of the including case.
  static void find_files_from(Node& document, const std::string& folder) {
    for_each_path(document, [&](std::string& path) { path = fs::absolute(fs::path(folder) / path).lexically_normal().string(); });
  }

  /// Removes `include` from a document and reads the included files.
  Node included(const CaseText& text, Node::Table& document) {
    Node whole{Node::Table{}, {1, 1, -1}};
    Entry* include = find_entry(document, "include");
    if (include == nullptr) return whole;
    const Node list = std::move(include->node);
    document.erase(document.begin() + (include - document.data()));
    const auto* array = list.as<Node::Array>();
    for (const Node& node : array != nullptr ? *array : Node::Array{list}) {
      const std::string where = text.path + ":" + std::to_string(node.source.line) + ": include";
      const auto* name = node.as<std::string>();
      if (name == nullptr || name->empty()) {
        const std::string problem = "wanted the name of a case or the path of a .toml file, or an array of them";
        throw CaseFileError({{.text = where + ": " + problem, .file = text.path, .line = node.source.line, .key = "include"}}, problem);
      }
      const CaseText part = find(text, *name, where, node.source.line);
      if (std::find(open_.begin(), open_.end(), part.path) != open_.end())
        throw CaseFileError({{.text = where + " = \"" + *name + "\" leads back to itself",
                              .file = text.path,
                              .line = node.source.line,
                              .key = "include",
                              .value = toml_string(*name)}},
                            "leads back to itself");
      Node next = read(part);
      make_way(next, whole);
      lay_over(std::move(next), whole);
    }
    return whole;
  }

  /// The built-in text "parts/mesh.toml", unless the folder of the including case has a file of that name.
  static std::optional<CatalogueEntry> ready_part(const CaseText& from, const std::string& name) {
    std::error_code none;
    if (!name.starts_with("parts/") || fs::exists(fs::path(from.folder) / name, none)) return std::nullopt;
    return built_in_part(name.ends_with(".toml") ? name : name + ".toml");
  }

  /// The file beside one that is missing, or the ready part, whose name is most similar; empty: none.
  static std::string near_part(const CaseText& from, const std::string& name) {
    const fs::path folder = (fs::path(from.folder) / name).lexically_normal().parent_path();
    const std::string before = name.substr(0, name.rfind('/') + 1);
    std::vector<std::string> names;
    std::error_code none;
    for (const fs::directory_entry& file : fs::directory_iterator(folder, none)) {
      if (names.size() >= kMostNames) break;
      if (file.path().extension() == ".toml") names.push_back(before + file.path().filename().string());
    }
    std::ranges::sort(names);
    for (const BuiltInCase& c : built_in_cases())
      if (c.name.starts_with("parts/")) names.emplace_back(name.ends_with(".toml") ? c.name : c.name.substr(0, c.name.rfind(".toml")));
    return cases::nearest(name, names);
  }

  static CaseText find(const CaseText& from, const std::string& name, const std::string& where, int line) {
    if (from.built_in) {
      if (const auto part = built_in_part(name)) return text_of(*part);
    }
    if (const auto part = ready_part(from, name)) return text_of(*part);
    if (is_path(name)) {
      try {
        return read_file((fs::path(from.folder) / name).lexically_normal().string());
      } catch (const FileError& e) {
        const std::string near = near_part(from, name);
        throw FileError(where, e.what() + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
      }
    }
    try {
      return find_case(name, from.folder);
    } catch (const CaseFileError& e) {
      throw CaseFileError({{.text = where + ": " + e.problem(), .file = from.path, .line = line, .key = "include", .value = toml_string(name)}},
                          e.problem());
    }
  }

  /// Removes the source of a motion from `under` if `top` gives another.
  static void make_way(const Node& top, Node& under) {
    const Entry* from = find_entry(*top.as<Node::Table>(), "motion");
    Entry* to = find_entry(*under.as<Node::Table>(), "motion");
    const auto* later = from == nullptr ? nullptr : from->node.as<Node::Table>();
    auto* earlier = to == nullptr ? nullptr : to->node.as<Node::Table>();
    if (later == nullptr || earlier == nullptr) return;
    for (const Entry& entry : *later) {
      for (const std::string_view other : give_way_to(entry.name)) {
        std::erase_if(*earlier, [&](const Entry& e) { return e.name == other; });
      }
    }
  }

  /// Merges `top` into `under`, with precedence.
  static void lay_over(Node top, Node& under) {
    auto* from = top.as<Node::Table>();
    auto* to = under.as<Node::Table>();
    if (from == nullptr || to == nullptr) {
      under = std::move(top);
      return;
    }
    under.source = top.source;
    std::map<std::string, std::size_t> known_at;  // a search for each entry would take the square of their number
    for (std::size_t i = 0; i < to->size(); ++i) known_at.emplace((*to)[i].name, i);
    for (Entry& entry : *from) {
      if (const auto at = known_at.find(entry.name); at != known_at.end()) {
        Entry* known = &(*to)[at->second];
        const auto* array = entry.node.as<Node::Array>();
        if (array != nullptr && array->empty() && known->node.as<Node::Array>() == nullptr) {
          known->node = {Node::Removed{}, entry.node.source};  // `key = []` removes the included value, even if it is no array
        } else {
          lay_over(std::move(entry.node), known->node);
        }
      } else {
        to->push_back(std::move(entry));
      }
    }
  }

  std::vector<std::string> files_;
  std::vector<std::string> open_;  // files being read, each included by the one before
};

}  // namespace

CaseText find_case(const std::string& name, const std::string& folder) {
  std::error_code error;
  const std::string file = (fs::path(folder) / name).string();
  if (is_path(name)) return read_file(file);
  const std::vector<CatalogueEntry> entries = catalogue();
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const CatalogueEntry& e) { return e.name == name; });
  if (entry != entries.end()) return text_of(*entry);
  if (fs::exists(file, error)) return read_file(file);

  std::vector<std::string> names;
  for (const CatalogueEntry& e : entries) names.push_back(e.name);
  const std::string near = fs::exists(file + ".toml", error) ? name + ".toml" : cases::nearest(name, names);
  const std::string problem = "case \"" + name + "\" is neither in the catalogue nor a file; " +
                              (near.empty() ? "" : "did you mean \"" + near + "\"? ") + "The catalogue: " + joined(names);
  throw CaseFileError({{.text = problem, .value = toml_string(name)}}, problem);
}

Document read_document(const CaseText& text) {
  Reader reader;
  Node root = reader.read(text);
  return {std::move(root), std::move(reader).files()};
}

}  // namespace voussoir::io
