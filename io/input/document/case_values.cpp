// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/document/case_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "cases/names.h"
#include "io/input/document/other_names.h"
#include "io/input/document/written_units.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kLongest = 80;
constexpr int kMostFaults = 1000;  // no user reads more

std::string cut(std::string text) {
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not within a UTF-8 character
  return text.substr(0, end) + "...";
}

std::string plain_number(double v) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), v).ptr;
  return {buffer.data(), end};
}

/// A number such as 1e6 instead of 1e+06.
std::string short_number(double v) {
  std::string text = plain_number(v);
  for (const auto& [sign, without] : {std::pair{"e+0", "e"}, std::pair{"e-0", "e-"}, std::pair{"e+", "e"}}) {
    if (const std::size_t at = text.find(sign); at != std::string::npos) text.replace(at, std::string_view(sign).size(), without);
  }
  return text;
}

std::string kind_of(const Node& node) {
  constexpr std::array<const char*, 8> kinds{
      "nothing", "a date or time", "true or false", "an integer", "a number with a fraction", "a string in quotes", "an array", "a table"};
  return kinds.at(node.value.index());
}

std::string text_of(const Node& node) {
  if (const auto* v = node.as<bool>()) return *v ? "true" : "false";
  if (const auto* v = node.as<std::int64_t>()) return std::to_string(*v);
  if (const auto* v = node.as<double>()) return plain_number(*v);
  if (const auto* v = node.as<std::string>()) return toml_string(cut(*v));
  if (const auto* v = node.as<Node::Array>()) {
    std::string text = "[";
    for (const Node& n : *v) {
      if (text.size() > kLongest) break;
      text += (text.size() > 1 ? ", " : "") + text_of(n);
    }
    return text + "]";
  }
  return "";
}

bool starts_with_verb(std::string_view problem) {
  constexpr std::array<std::string_view, 10> verbs{"is ", "are ", "has ", "does ", "do ", "would ", "needs ", "cannot ", "names ", "says "};
  return std::any_of(verbs.begin(), verbs.end(), [&](std::string_view v) { return problem.starts_with(v); });
}

bool is_number(const Node& node) {
  return node.as<double>() != nullptr || node.as<std::int64_t>() != nullptr || node.as<Node::Array>() != nullptr;
}

}  // namespace

std::string Limits::usual_text() const {
  if (!std::isfinite(usual_low) || !std::isfinite(usual_high)) return "";
  return "usually " + short_number(usual_low) + " to " + short_number(usual_high);
}

std::string Limits::possible_text() const {
  const bool below = least > 0.0, above = std::isfinite(most);
  if (below && above) return short_number(least) + " to " + short_number(most);
  if (above) return "at most " + short_number(most) + (low < 0.0 ? " in magnitude" : "");
  return below ? "at least " + short_number(least) : "";
}

std::string Limits::full_text() const {
  std::string all;
  const std::string possible = possible_text();
  for (const std::string& part : {text(), usual_text(), (possible.find(" to ") == std::string::npos ? "" : "possible ") + possible})
    all += (all.empty() || part.empty() ? "" : ", ") + part;
  return all;
}

std::string Limits::text() const {
  const bool bounded_below = std::isfinite(low), bounded_above = std::isfinite(high);
  if (filled) return "not empty";
  if (bounded_below && bounded_above)
    return "in " + std::string(low_open ? "(" : "[") + plain_number(low) + ", " + plain_number(high) + (high_open ? ")" : "]");
  if (bounded_below) return (low_open ? "> " : ">= ") + plain_number(low);
  if (bounded_above) return (high_open ? "< " : "<= ") + plain_number(high);
  return "";
}

std::string KeyInfo::allowed() const {
  std::string all = shape;
  for (const std::string& part : {unit, limits.full_text()}) all += (all.empty() || part.empty() ? "" : ", ") + part;
  return all;
}

std::string sentence_of(const std::string& key, const std::string& value, const std::string& problem) {
  if (key.empty() || problem.starts_with(key + " ")) return problem;
  if (problem.starts_with("= ")) return key + " " + problem;
  if (value.empty()) return key + (starts_with_verb(problem) ? " " : ": ") + problem;
  const std::string bare = value.substr(0, value.find(' '));
  if (problem.starts_with(value) || problem.starts_with(bare + " ")) return key + " = " + problem;
  return key + " = " + value + (starts_with_verb(problem) ? " " : ": ") + problem;
}

void Reading::fault(Fault fault) {
  if (count_++ < kMostFaults) all_.push_back(std::move(fault));
}

std::vector<Fault> Reading::all() const {
  std::vector<Fault> sorted = all_;
  std::ranges::stable_sort(sorted, [](const Fault& a, const Fault& b) { return a.source.before(b.source); });
  return sorted;
}

void Reading::wrong_type(const Node& node, const std::string& path, const KeyInfo& info) {
  const std::string limits = info.limits.text();
  const auto* text = node.as<std::string>();
  const std::string remedy = text != nullptr && info.shape.find("a number") != std::string::npos && !info.shape.starts_with("an array")
                                 ? without_unit(*text, info.unit)
                                 : "";
  const std::string details = info.unit.empty() || limits.empty() ? info.unit + limits : info.unit + ", " + limits;
  fault({node.source, path, short_text(node),
         "found " + kind_of(node) + ", wanted " + info.shape + (details.empty() ? "" : " (" + details + ")") +
             (remedy.empty() ? "" : "; " + remedy),
         info.allowed()});
}

void Reading::bad_value(const Node& node, const std::string& path, const KeyInfo& info, const std::string& problem) {
  const bool with_unit = !info.unit.empty() && is_number(node);
  fault({node.source, path, short_text(node) + (with_unit ? " " + info.unit : ""), problem, info.allowed()});
}

bool Reading::mistyped(const Node& node, const std::string& path, const KeyInfo& info, const std::vector<std::string>& words) {
  const auto* given = node.as<std::string>();
  std::string meant = given == nullptr ? "" : cases::did_you_mean(*given, words);
  if (const std::string unit = given == nullptr ? "" : unit_name(*given); std::ranges::find(words, unit) != words.end())
    meant = "did you mean " + cases::quoted(unit) + "? ";
  if (meant.empty()) return false;
  bad_value(node, path, info, "must be " + info.shape + "; " + meant.substr(0, meant.size() - 1));
  return true;
}

void Reading::unknown_key(const Entry& entry, const std::string& table_path, const std::vector<std::string>& allowed) {
  if (count_ >= kMostFaults) {  // limits the number of searches for a file with many unknown keys
    ++count_;
    return;
  }
  const std::string meant = meant_key(entry.name, allowed);
  const std::string table = table_path.empty() ? "the case file" : "[" + table_path + "]";
  fault({entry.node.source, cut(path_to(table_path, entry.name)), "",
         "unknown key; " + (meant.empty() ? cases::did_you_mean(entry.name, allowed) : "did you mean " + cases::quoted(meant) + "? ") +
             "Keys of " + table + ": " + joined(allowed),
         joined(allowed)});
}

void Reading::missing_key(const Node& table, const std::string& table_path, const KeyInfo& info) {
  const std::string unit = info.unit.empty() ? "" : ", " + info.unit;
  const std::string limits = info.limits.text();
  fault({table.source, path_to(table_path, info.name), "",
         "is missing; wanted " + info.shape + unit + (limits.empty() ? "" : ", " + limits) + ": " + info.sentence, info.allowed()});
}

void Reading::know(const std::string& path, const Node& node, const std::string& unit) {
  std::string value = node.as<Node::Table>() != nullptr ? "" : short_text(node);
  if (!unit.empty() && is_number(node)) value += " " + unit;
  known_[path] = {node.source, std::move(value)};
}

const Node::Table* Reading::table_of(const Node& node, const std::string& path) {
  const auto* table = node.as<Node::Table>();
  if (table == nullptr) wrong_type(node, path, {"", "", "", {}, "a table", false});
  return table;
}

const Node::Array* Reading::array_of(const Node& node, const std::string& path) {
  const auto* array = node.as<Node::Array>();
  if (array == nullptr) wrong_type(node, path, {"", "", "", {}, "an array of tables ([[" + path + "]])", false});
  return array;
}

std::string toml_number(double v) {
  std::string text = plain_number(v);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string toml_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04X", static_cast<unsigned>(c));
      out += code.data();
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string toml_key(std::string_view name) {
  const auto bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), bare) ? std::string(name) : toml_string(name);
}

std::string short_text(const Node& node) { return cut(text_of(node)); }

bool same_word(const Node& node, std::string_view toml) {
  if (const auto* v = node.as<double>()) return plain_number(*v) == toml;
  return text_of(node) == toml;
}

std::string joined(const std::vector<std::string>& names, std::string_view separator) {
  std::string out;
  for (const std::string& name : names) {
    if (!out.empty()) out += separator;
    out += name;
  }
  return out;
}

std::string path_to(const std::string& table_path, const std::string& name) { return table_path.empty() ? name : table_path + "." + name; }
std::string path_to(const std::string& array_path, std::size_t index) { return array_path + "[" + std::to_string(index) + "]"; }

bool read_value(const Node& node, double& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  double v = 0.0;
  if (const auto* number = node.as<double>()) {
    v = *number;
  } else if (const auto* integer = node.as<std::int64_t>()) {
    v = static_cast<double>(*integer);
  } else {
    reading.wrong_type(node, path, info);
    return false;
  }
  if (!std::isfinite(v)) {
    reading.bad_value(node, path, info, "must be finite");
  } else if (!info.limits.contains(v)) {
    reading.bad_value(node, path, info, "must be " + info.limits.text());
  } else if (!info.limits.is_possible(v)) {
    reading.bad_value(node, path, info,
                      "is impossible; allowed: " + info.limits.possible_text() + (info.unit.empty() ? "" : " " + info.unit));
  } else {
    if (!info.limits.is_usual(v)) {
      const std::string unit = info.unit.empty() ? "" : " " + info.unit;
      reading.doubt({node.source, path, short_text(node) + unit, "is unusual; " + info.limits.usual_text() + unit});
    }
    out = v;
    return true;
  }
  return false;
}

bool read_value(const Node& node, int& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  const auto* v = node.as<std::int64_t>();
  if (v == nullptr) {
    reading.wrong_type(node, path, info);
    return false;
  }
  if (*v < std::numeric_limits<int>::min() || *v > std::numeric_limits<int>::max()) {
    reading.bad_value(node, path, info, "must be an integer of 32 bits, at most 2147483647 in magnitude");
    return false;
  }
  if (!info.limits.contains(static_cast<double>(*v))) {
    reading.bad_value(node, path, info, "must be " + info.limits.text());
    return false;
  }
  out = static_cast<int>(*v);
  return true;
}

bool read_value(const Node& node, bool& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  const auto* v = node.as<bool>();
  if (v == nullptr) {
    reading.wrong_type(node, path, info);
    return false;
  }
  out = *v;
  return true;
}

bool read_value(const Node& node, std::string& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  const auto* v = node.as<std::string>();
  if (v == nullptr) {
    reading.wrong_type(node, path, info);
    return false;
  }
  if (info.limits.filled && v->empty()) {
    reading.bad_value(node, path, info, "must not be empty");
    return false;
  }
  out = *v;
  return true;
}

}  // namespace voussoir::io
