// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_keys.h"

namespace voussoir::io {
namespace {

std::string comment_of(const KeyInfo& info, bool with_shape) {
  std::vector<std::string> parts;
  const std::string limits = with_shape ? info.limits.full_text() : info.limits.text();
  const bool words = info.shape.find(" | ") != std::string::npos;
  if (!info.unit.empty()) parts.push_back(info.unit);
  if (words || with_shape) parts.push_back(info.shape);
  if (!limits.empty()) parts.push_back(limits);
  parts.push_back(info.sentence);
  return joined(parts, "; ");
}

/// Escapes text for a cell of a Markdown table.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += std::string(c == '|' || c == '<' ? "\\" : "") + c;
  return out;
}

std::string markdown_row(const KeyInfo& info, const std::string& default_text) {
  const std::string by_default = info.required ? "*required*" : default_text.empty() ? "none" : "`" + default_text + "`";
  const std::string limits = info.limits.full_text();
  const std::string allowed = info.shape + (limits.empty() ? "" : "; " + limits);
  return "| `" + info.name + "` | " + by_default + " | " + info.unit + " | " + escaped(allowed) + " | " + escaped(info.sentence) + " |\n";
}

std::string markdown_header(const Header& at, const std::string& sentence) {
  const std::string title = at.path.empty() ? "## At the top\n\n" : "\n## `" + at.text() + "`\n\n" + sentence + "\n\n";
  return title + "| key | default | unit | allowed | meaning |\n|---|---|---|---|---|\n";
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

}  // namespace

bool RuleCheck::given(std::string_view key) const {
  const auto* entries = table.as<Node::Table>();
  const Entry* entry = entries == nullptr ? nullptr : find_entry(*entries, key);
  return entry != nullptr && !entry->node.removed();
}

bool RuleCheck::given_together(std::string_view key, std::string_view other) const {
  if (!given(key) || !given(other)) return false;
  const auto& entries = *table.as<Node::Table>();
  const Source a = find_entry(entries, key)->node.source, b = find_entry(entries, other)->node.source;
  return a.file == b.file && a.set < 0 && b.set < 0;
}

Fault RuleCheck::at(const std::string& key, const std::string& problem) const {
  const std::string key_path = key.empty() ? path : path_to(path, key);
  const auto known = reading.known().find(key_path);
  if (known == reading.known().end()) return {table.source, key_path, "", problem};
  return {known->second.source, key_path, known->second.value, problem};
}

void RuleCheck::fault(const std::string& key, const std::string& problem) const { reading.fault(at(key, problem)); }

void RuleCheck::doubt(const std::string& key, const std::string& problem) const { reading.doubt(at(key, problem)); }

void Lines::header(const Header& at, const std::string& sentence) {
  if (tables != nullptr) return static_cast<void>(tables->push_back({at, sentence}));
  if (markdown) {
    out += markdown_header(at, sentence);
    return;
  }
  if (!at.path.empty()) out += "\n" + padded(at.text(), 32) + "  # " + sentence + "\n";
}

void Lines::absent_table(const Header& at, const std::string& sentence) {
  out += "\n" + padded("# none: " + at.text(), 32) + "  # " + sentence + "\n";
}

void Lines::key(const KeyInfo& info, const std::string& text) {
  const std::string left = text.empty() ? "# none: " + info.name : info.name + " = " + text;
  out += padded(left, 32) + "  # " + comment_of(info, false) + "\n";
}

void Lines::in_place_of(const std::string& path, const KeyInfo& info) const {
  if (tables == nullptr) return;
  for (ListedTable& t : *tables)
    if (t.at.path == path) t.in_place = info.types;
}

void Lines::reference(const KeyInfo& info, const std::string& default_text) {
  if (tables != nullptr) return tables->back().keys.push_back({info, default_text});
  if (markdown) {
    out += markdown_row(info, default_text);
    return;
  }
  const std::string value = info.required ? "required" : (default_text.empty() ? "none" : default_text);
  out += "  " + padded(info.name, 17) + " " + padded(value, 18) + " " + comment_of(info, true) + "\n";
}

}  // namespace voussoir::io
