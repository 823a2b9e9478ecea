// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/input/document/case_tree.h"

/// What the option tables are made of: limits, faults, and the way from a node to a typed value and back to text.
namespace voussoir::io {

/// Sizes that buildings have, without their sign.
struct Usual {
  double low, high;
};

/// The range of a number, or of each number of an array. Every number must be finite anyway.
struct Limits {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;
  bool filled = false;  // a string must not be empty
  // Of values that buildings have; 0 mostly means "none". What lies outside is let through, but told: its unit may be another.
  double usual_low = -std::numeric_limits<double>::infinity(), usual_high = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool contains(double v) const noexcept { return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high); }
  [[nodiscard]] bool is_usual(double v) const noexcept { return v == 0.0 || (std::abs(v) >= usual_low && std::abs(v) <= usual_high); }
  [[nodiscard]] Limits usually(Usual range) const {
    Limits l = *this;
    l.usual_low = range.low, l.usual_high = range.high;
    return l;
  }
  /// ">= 0", "in [0, 0.5)"; empty: any.
  [[nodiscard]] std::string text() const;
  /// "usually 200 to 12000"; empty: nothing is known of it.
  [[nodiscard]] std::string usual_text() const;
  /// Both: "> 0, usually 200 to 12000".
  [[nodiscard]] std::string full_text() const;
};
inline Limits any() { return {}; }
inline Limits filled() {
  Limits l;
  l.filled = true;
  return l;
}
inline Limits above(double low) {
  Limits l;
  l.low = low, l.low_open = true;
  return l;
}
inline Limits at_least(double low) {
  Limits l;
  l.low = low;
  return l;
}
/// [low, high)
inline Limits from_below(double low, double high) {
  Limits l;
  l.low = low, l.high = high, l.high_open = true;
  return l;
}
/// (low, high)
inline Limits inside(double low, double high) {
  Limits l = from_below(low, high);
  l.low_open = true;
  return l;
}
/// [low, high]
inline Limits within(double low, double high) {
  Limits l;
  l.low = low, l.high = high;
  return l;
}

/// What is known of a key besides its value.
struct KeyInfo {
  std::string name, unit, sentence;
  Limits limits;
  std::string shape;  // "number", "[number, number]", "a | b"
  bool required = false;
};

/// One fault of a case.
struct Fault {
  Source source;
  std::string key, value, problem;
};

/// "key = value: problem", joined so that it reads as a sentence.
std::string sentence_of(const std::string& key, const std::string& value, const std::string& problem);

/// The state of reading one document: where the keys stand, and the first fault in file order.
class Reading {
 public:
  struct Known {
    Source source;
    std::string value;
  };

  void fault(Fault fault);
  /// A value of the wrong type or out of range: "found ..., wanted ...".
  void wrong_type(const Node& node, const std::string& path, const KeyInfo& info);
  void bad_value(const Node& node, const std::string& path, const KeyInfo& info, const std::string& problem);
  void unknown_key(const Entry& entry, const std::string& table_path, const std::vector<std::string>& allowed);
  /// A value that is let through, but is likely a slip.
  void doubt(Fault doubt) { doubts_.push_back(std::move(doubt)); }
  void missing_key(const Node& table, const std::string& table_path, const KeyInfo& info);
  void know(const std::string& path, const Node& node, const std::string& unit);
  /// The entries of a table; otherwise a fault, and nullptr.
  const Node::Table* table_of(const Node& node, const std::string& path);
  const Node::Array* array_of(const Node& node, const std::string& path);

  [[nodiscard]] int faults() const noexcept { return count_; }
  [[nodiscard]] const std::optional<Fault>& first() const noexcept { return first_; }
  /// In the order of reading.
  [[nodiscard]] const std::vector<Fault>& doubts() const noexcept { return doubts_; }
  [[nodiscard]] const std::map<std::string, Known>& known() const noexcept { return known_; }

 private:
  std::map<std::string, Known> known_;
  std::optional<Fault> first_;
  std::vector<Fault> doubts_;
  int count_ = 0;
};

/// Shortest text that reads back as the same double, always with a point or an exponent.
std::string toml_number(double v);
/// A string in quotes, escaped.
std::string toml_string(std::string_view text);
/// A key, in quotes where it must be.
std::string toml_key(std::string_view name);
/// A value as found, for messages: cut short if long.
std::string short_text(const Node& node);
/// Whether a node is the value of that TOML text; 90.0 is 90.
bool same_word(const Node& node, std::string_view toml);
/// The name nearest to a misspelt one, or empty if none is near.
std::string nearest(std::string_view name, const std::vector<std::string>& names);
/// "a, b, c"
std::string joined(const std::vector<std::string>& names, std::string_view separator = ", ");
/// "table.name"
std::string path_to(const std::string& table_path, const std::string& name);
std::string path_to(const std::string& array_path, std::size_t index);

/// Reads a value of the given type; false after a fault. Integers are taken for numbers, nothing else is converted.
bool read_value(const Node& node, double& out, const KeyInfo& info, Reading& reading, const std::string& path);
bool read_value(const Node& node, int& out, const KeyInfo& info, Reading& reading, const std::string& path);
bool read_value(const Node& node, bool& out, const KeyInfo& info, Reading& reading, const std::string& path);
bool read_value(const Node& node, std::string& out, const KeyInfo& info, Reading& reading, const std::string& path);

}  // namespace voussoir::io
