// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/document/case_tree.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "io/input/document/case_values.h"
#include "io/input/document/written_units.h"

namespace voussoir::io {
namespace {

constexpr int kMostDots = 64;

/// A syntax error at an offset, with line and column from 1.
SyntaxError syntax_error_at(std::string_view text, std::size_t offset, const std::string& reason) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t start = before.rfind('\n');
  const std::size_t column = offset - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return {reason, static_cast<int>(line), static_cast<int>(column)};
}

/// The offset after the string that starts at `at`, or the end of the text.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool triple = text.substr(at, 3) == std::string(3, quote);
  const std::string close(triple ? 3 : 1, quote);
  for (std::size_t i = at + close.size(); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (text.substr(i, close.size()) == close || (text[i] == '\n' && !triple)) {
      return i + close.size();
    }
  }
  return text.size();
}

// The parser bounds nested values, but not dotted keys: `a.a.a. ...` over megabytes would nest as deeply and overflow the stack when freed.
void refuse_deep_keys(std::string_view text) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = after_string(text, i) - 1;
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '.') {
      if (++dots > kMostDots) throw syntax_error_at(text, i, "more than 64 dots in one key");
    } else if (c == '\n' || c == ',' || c == '=' || c == '[' || c == ']' || c == '{' || c == '}') {
      dots = 0;
    }
  }
}

Source source_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), -1};
}

Node convert(const toml::node& from, Source source);

Node::Table convert_table(const toml::table& from) {
  Node::Table table;
  table.reserve(from.size());
  for (const auto& [key, value] : from) {
    Source source = source_of(key.source());
    if (source.line == 0) source = source_of(value.source());
    table.push_back({std::string(key.str()), convert(value, source)});
  }
  std::stable_sort(table.begin(), table.end(), [](const Entry& a, const Entry& b) { return a.node.source.before(b.node.source); });
  return table;
}

Node::Array convert_array(const toml::array& from) {
  Node::Array array;
  array.reserve(from.size());
  for (const toml::node& value : from) array.push_back(convert(value, source_of(value.source())));
  return array;
}

Node convert(const toml::node& from, Source source) {
  Node node{Node::Date{}, source};
  if (const auto* v = from.as_boolean()) node.value = v->get();
  if (const auto* v = from.as_integer()) node.value = v->get();
  if (const auto* v = from.as_floating_point()) node.value = v->get();
  if (const auto* v = from.as_string()) node.value = v->get();
  if (const auto* v = from.as_array()) node.value = convert_array(*v);
  if (const auto* v = from.as_table()) node.value = convert_table(*v);
  return node;
}

}  // namespace

const Entry* find_entry(const Node::Table& table, std::string_view name) noexcept {
  const auto it = std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.name == name; });
  return it == table.end() ? nullptr : &*it;
}

Entry* find_entry(Node::Table& table, std::string_view name) noexcept {
  return const_cast<Entry*>(find_entry(static_cast<const Node::Table&>(table), name));
}

namespace {

std::string_view line_of(std::string_view text, int number) {
  for (int line = 1; line < number; ++line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

/// The fault for invalid UTF-8, which the parser found after `near`.
SyntaxError encoding_error(std::string_view text, Source near) {
  std::size_t at = static_cast<std::size_t>(line_of(text, near.line).data() - text.data());
  at = std::min(at + static_cast<std::size_t>(std::max(near.column - 1, 0)), text.size());
  while (at < text.size() && static_cast<unsigned char>(text[at]) < 0x80U) ++at;
  std::array<char, 8> byte{};
  if (at < text.size()) std::snprintf(byte.data(), byte.size(), " 0x%02X", static_cast<unsigned>(static_cast<unsigned char>(text[at])));
  return syntax_error_at(text, at, "byte" + std::string(byte.data()) + " is no UTF-8; save the file in UTF-8");
}

}  // namespace

Node parse_document(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw syntax_error_at(text, 0, "the file is in UTF-16; save it in UTF-8");
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
    throw syntax_error_at(text, nul, nul < 2 ? "a NUL byte, as in UTF-16; save the file in UTF-8" : "a NUL byte");
  refuse_deep_keys(text);
  try {
    return convert(toml::parse(text), Source{1, 1, -1});
  } catch (const toml::parse_error& e) {
    const Source at = source_of(e.source());
    if (std::string_view(e.description()).find("utf-8") != std::string_view::npos) throw encoding_error(text, at);
    const std::string remedy = unit_in_line(line_of(text, at.line), static_cast<std::size_t>(std::max(at.column, 0)));
    throw SyntaxError(remedy.empty() ? std::string(e.description()) : remedy, at.line, at.column);
  }
}

Node parse_value(const std::string& text) {
  try {
    // A line end would allow further keys in an override.
    if (text.find_first_of("\r\n") != std::string::npos) return Node{text, {}};
    Node document = parse_document("v = " + text);
    return std::move(document.as<Node::Table>()->front().node);
  } catch (const SyntaxError&) {
    return Node{text, {}};
  }
}

bool is_utf8(std::string_view text) {
  try {
    parse_document("v = " + toml_string(text));
    return true;
  } catch (const SyntaxError&) {
    return false;
  }
}

}  // namespace voussoir::io
