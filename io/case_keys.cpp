// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/case_keys.h"

namespace voussoir::io {
namespace {

std::string comment_of(const KeyInfo& info, bool with_shape) {
  std::vector<std::string> parts;
  const std::string limits = info.limits.text();
  const bool words = info.shape.find(" | ") != std::string::npos;
  if (!info.unit.empty()) parts.push_back(info.unit);
  if (words || with_shape) parts.push_back(info.shape);
  if (!limits.empty()) parts.push_back(limits);
  parts.push_back(info.sentence);
  return joined(parts, "; ");
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

void RuleCheck::fault(const std::string& key, const std::string& problem) const {
  const std::string key_path = key.empty() ? path : path_to(path, key);
  const auto known = reading.known().find(key_path);
  if (known != reading.known().end()) {
    reading.fault({known->second.source, key_path, known->second.value, problem});
  } else {
    reading.fault({table.source, key_path, "", problem});
  }
}

void Lines::header(const Header& at, const std::string& sentence) {
  if (!at.path.empty()) out += "\n" + padded(at.text(), 32) + "  # " + sentence + "\n";
}

void Lines::absent_table(const Header& at, const std::string& sentence) {
  out += "\n" + padded("# none: " + at.text(), 32) + "  # " + sentence + "\n";
}

void Lines::key(const KeyInfo& info, const std::string& text) {
  const std::string left = text.empty() ? "# none: " + info.name : info.name + " = " + text;
  out += padded(left, 32) + "  # " + comment_of(info, false) + "\n";
}

void Lines::reference(const KeyInfo& info, const std::string& default_text) {
  const std::string value = info.required ? "required" : (default_text.empty() ? "none" : default_text);
  out += "  " + padded(info.name, 17) + " " + padded(value, 18) + " " + comment_of(info, true) + "\n";
}

}  // namespace voussoir::io
