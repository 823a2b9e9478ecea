// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "io/input/case_file/case_file.h"
#include "io/input/document/case_tree.h"
#include "io/input/motion/motion_keys.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kDeepest = 64;

/// A step of a path: a name, or an index in brackets.
struct Step {
  std::string name;
  bool bracket = false;
};

struct Override {
  std::string_view text;  // a.b[0].c=value
  int index = 0;
  std::vector<Step> path;
  std::string value;

  [[noreturn]] void refuse(const std::string& problem) const {
    throw CaseFileError({{.text = "--set " + std::string(text) + ": " + problem, .key = "--set", .value = std::string(text)}}, problem);
  }
  [[nodiscard]] Source source() const { return {0, 0, index}; }
};

std::optional<std::size_t> as_index(const std::string& text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return index;
}

/// Reads a name, plain or in quotes, or an index in brackets; `at` is moved past it.
Step read_step(const Override& o, std::size_t& at, bool first) {
  const auto until = [&](std::size_t from, char close) {
    const std::size_t end = o.text.find(close, from);
    if (end == std::string_view::npos) o.refuse(std::string("no closing ") + close + " in the key");
    at = end + 1;
    return std::string(o.text.substr(from, end - from));
  };
  if (o.text[at] == '[') {
    Step step{until(at + 1, ']'), true};
    if (first || !as_index(step.name)) o.refuse("[" + step.name + "] is no index; write key[0]");
    return step;
  }
  if (o.text[at] == '"' || o.text[at] == '\'') return {until(at + 1, o.text[at]), false};
  const std::size_t end = std::min(o.text.find_first_of(".[=", at), o.text.size());
  Step step{std::string(o.text.substr(at, end - at)), false};
  while (!step.name.empty() && std::isspace(static_cast<unsigned char>(step.name.back())) != 0) step.name.pop_back();
  if (step.name.empty()) o.refuse("an empty name in the key");
  at = end;
  return step;
}

Override parse_override(const std::string& text, int index) {
  Override o{text, index, {}, {}};
  std::size_t at = 0;
  while (true) {
    if (at >= text.size()) o.refuse("wanted key=value");
    o.path.push_back(read_step(o, at, o.path.empty()));
    if (o.path.size() > kDeepest) o.refuse("the key is too deep");
    while (at < text.size() && text[at] == ' ') ++at;
    if (at >= text.size()) o.refuse("no '='; wanted key=value");
    if (text[at] == '=') break;
    if (text[at] == '.') {
      ++at;
    } else if (text[at] != '[') {
      o.refuse("the key cannot be read; wanted a.b[0].c=value");
    }
  }
  const std::size_t start = text.find_first_not_of(" \t", at + 1);
  o.value = start == std::string::npos ? "" : text.substr(start);
  return o;
}

/// A child of `node`. If it is missing, it is created if `make`, else nullptr is returned.
Node* step_into(Node& node, const Override& o, std::size_t depth, bool make) {
  const Step& step = o.path[depth];
  if (node.removed()) node.value = step.bracket ? decltype(node.value){Node::Array{}} : decltype(node.value){Node::Table{}};
  if (auto* array = node.as<Node::Array>()) {
    const auto index = as_index(step.name);
    if (!index) o.refuse("\"" + o.path[depth - 1].name + "\" is an array; write " + o.path[depth - 1].name + "[0]." + step.name);
    if (*index > array->size() || (*index == array->size() && !make)) {
      o.refuse("[" + step.name + "] is past the end: the array has " + std::to_string(array->size()) + " values");
    }
    if (*index == array->size()) array->push_back({Node::Removed{}, o.source()});
    return &(*array)[*index];
  }
  auto* table = node.as<Node::Table>();
  if (table == nullptr || step.bracket) o.refuse("\"" + o.path[depth - 1].name + "\" is no " + (step.bracket ? "array" : "table"));
  if (Entry* entry = find_entry(*table, step.name)) return &entry->node;
  if (!make) return nullptr;
  table->push_back({step.name, {Node::Removed{}, o.source()}});
  return &table->back().node;
}

// A removed key remains as a marker, so that a misspelt name is still detected when the tables are read.
void remove(Node& document, const Override& o) {
  Node* node = &document;
  for (std::size_t depth = 0; depth + 1 < o.path.size(); ++depth) {
    Node* next = step_into(*node, o, depth, false);
    if (next == nullptr) {
      node->as<Node::Table>()->push_back({o.path[depth].name, {Node::Removed{}, o.source()}});
      return;
    }
    if (next->removed()) return;
    node = next;
  }
  if (auto* array = node->as<Node::Array>()) {
    const Node* gone = step_into(*node, o, o.path.size() - 1, false);
    array->erase(array->begin() + (gone - array->data()));
    return;
  }
  *step_into(*node, o, o.path.size() - 1, true) = {Node::Removed{}, o.source()};
}

void set_source(Node& node, Source source) {
  node.source = source;
  if (auto* array = node.as<Node::Array>()) {
    for (Node& n : *array) set_source(n, source);
  }
  if (auto* table = node.as<Node::Table>()) {
    for (Entry& e : *table) set_source(e.node, source);
  }
}

/// Removes the sources of motion that conflict with the source of an override, as a later file does for an included one.
void make_way(Node& document, const Override& o) {
  if (o.path.size() != 2 || o.path[0].name != "motion" || o.path[1].bracket || o.value.empty()) return;
  Entry* motion = find_entry(*document.as<Node::Table>(), "motion");
  auto* keys = motion == nullptr ? nullptr : motion->node.as<Node::Table>();
  if (keys == nullptr) return;
  for (const std::string_view other : give_way_to(o.path[1].name)) std::erase_if(*keys, [&](const Entry& e) { return e.name == other; });
}

/// The tables of an array that an override removes, with their names if they have any; empty if it removes no such array.
std::string tables_in(const Node& document, const Override& o) {
  const Node* node = &document;
  for (const Step& step : o.path) {
    const auto* table = node->as<Node::Table>();
    const Entry* entry = table == nullptr ? nullptr : find_entry(*table, step.name);
    if (entry == nullptr) return "";
    node = &entry->node;
  }
  const auto* array = node->as<Node::Array>();
  if (array == nullptr || array->empty() || array->front().as<Node::Table>() == nullptr) return "";
  std::string names;
  for (const Node& each : *array) {
    const auto* table = each.as<Node::Table>();
    const Entry* name = table == nullptr ? nullptr : find_entry(*table, "name");
    const auto* text = name == nullptr ? nullptr : name->node.as<std::string>();
    if (text != nullptr) names += (names.empty() ? ": " : ", ") + *text;
  }
  return std::to_string(array->size()) + names;
}

}  // namespace

std::vector<std::string> apply_overrides(Node& document, const std::vector<std::string>& overrides) {
  std::vector<std::string> notes;
  std::vector<Override> all;
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    all.push_back(parse_override(overrides[i], static_cast<int>(i)));
    if (!is_utf8(all.back().text)) all.back().refuse("is not in UTF-8");
  }
  for (const Override& o : all) make_way(document, o);  // before any is set, since two overrides may still contradict each other
  for (const Override& o : all) {
    if (o.value.empty()) {
      const std::string gone = tables_in(document, o);
      if (!gone.empty()) notes.push_back("--set " + std::string(o.text) + " takes away all that the case has there (" + gone + ")");
      remove(document, o);
      continue;
    }
    Node* node = &document;
    for (std::size_t depth = 0; depth < o.path.size(); ++depth) node = step_into(*node, o, depth, true);
    *node = parse_value(o.value);
    set_source(*node, o.source());
  }
  return notes;
}

}  // namespace voussoir::io
