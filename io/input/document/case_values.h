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

/// Elements of the option tables: limits, faults, and conversion of nodes to typed values and back to text.
namespace voussoir::io {

/// Usual range of the absolute value of a quantity in buildings, and the range beyond which it is impossible: unless given, a thousandth of
/// the lower end and a thousand times the upper one.
struct Usual {
  constexpr Usual(double from, double to) : Usual(from, to, from / 1e3, to * 1e3) {}
  constexpr Usual(double from, double to, double lowest, double highest) : low(from), high(to), least(lowest), most(highest) {}
  double low, high, least, most;
};

/// The allowed range of a number, or of each number of an array. Every number must also be finite.
struct Limits {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;
  bool filled = false;  // a string must not be empty
  // Usual absolute values; 0 is always usual, as it mostly means "none". Values outside are accepted but reported: their unit may be wrong.
  double usual_low = -std::numeric_limits<double>::infinity(), usual_high = std::numeric_limits<double>::infinity();
  // Possible absolute values; values outside are refused: no run with them makes sense, or ends.
  double least = 0.0, most = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool contains(double v) const noexcept { return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high); }
  [[nodiscard]] bool is_usual(double v) const noexcept { return v == 0.0 || (std::abs(v) >= usual_low && std::abs(v) <= usual_high); }
  [[nodiscard]] bool is_possible(double v) const noexcept { return std::abs(v) >= least && std::abs(v) <= most; }
  [[nodiscard]] Limits usually(Usual range) const {
    Limits l = possibly(range.least, range.most);
    l.usual_low = range.low, l.usual_high = range.high;
    return l;
  }
  /// \param lowest  counts only where 0 is not allowed: elsewhere what is next to nothing does no harm
  [[nodiscard]] Limits possibly(double lowest, double highest) const {
    Limits l = *this;
    l.least = low_open && low == 0.0 ? lowest : 0.0;
    if (!(high <= highest)) l.most = highest;
    return l;
  }
  /// Text such as ">= 0", "in [0, 0.5)"; empty: any value.
  [[nodiscard]] std::string text() const;
  /// Text such as "usually 200 to 12000"; empty: no usual range.
  [[nodiscard]] std::string usual_text() const;
  /// Text such as "0.1 to 1e5", "at most 1e7 in magnitude"; empty: no such range beyond that of text().
  [[nodiscard]] std::string possible_text() const;
  /// All of them: "> 0, usually 200 to 12000, possible 0.1 to 1e5".
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
/// (low, high]
inline Limits from_above(double low, double high) {
  Limits l;
  l.low = low, l.high = high, l.low_open = true;
  return l;
}
/// [low, high]
inline Limits within(double low, double high) {
  Limits l;
  l.low = low, l.high = high;
  return l;
}

/// A type that values of a key may have, for programs.
struct ValueType {
  std::string of;            // number, integer, boolean, string
  std::vector<int> extents;  // of an array, from without; -1: any
};

/// Properties of a key other than its value.
struct KeyInfo {
  std::string name, unit, sentence;
  Limits limits;
  std::string shape;  // "number", "[number, number]", "a | b"
  bool required = false;
  std::vector<ValueType> types{};    // what `shape` says; any of them
  std::vector<std::string> words{};  // as TOML has them, that may stand in place of such a value, or are all that may

  /// Text such as "a number, m, > 0, usually 0.1 to 60".
  [[nodiscard]] std::string allowed() const;
};

/// One fault of a case.
struct Fault {
  Source source;
  std::string key, value, problem;
  std::string allowed{};  // by the key itself, in words; empty: not known
};

/// The text "key = value: problem", joined to a sentence.
std::string sentence_of(const std::string& key, const std::string& value, const std::string& problem);

/// The state of reading one document: places of keys, and faults.
class Reading {
 public:
  struct Known {
    Source source;
    std::string value;
  };

  void fault(Fault fault);
  /// Reports a value of the wrong type or out of range: "found ..., wanted ...".
  void wrong_type(const Node& node, const std::string& path, const KeyInfo& info);
  void bad_value(const Node& node, const std::string& path, const KeyInfo& info, const std::string& problem);
  /// Whether a text is nearly one of some words; reports it then.
  bool mistyped(const Node& node, const std::string& path, const KeyInfo& info, const std::vector<std::string>& words);
  void unknown_key(const Entry& entry, const std::string& table_path, const std::vector<std::string>& allowed);
  /// Records an accepted value that is probably a mistake.
  void doubt(Fault doubt) { doubts_.push_back(std::move(doubt)); }
  void missing_key(const Node& table, const std::string& table_path, const KeyInfo& info);
  void know(const std::string& path, const Node& node, const std::string& unit);
  /// The entries of a table; for any other node records a fault and returns nullptr.
  const Node::Table* table_of(const Node& node, const std::string& path);
  const Node::Array* array_of(const Node& node, const std::string& path);

  [[nodiscard]] int faults() const noexcept { return count_; }
  /// The faults in file order, the first thousand that were found.
  [[nodiscard]] std::vector<Fault> all() const;
  /// In the order of reading.
  [[nodiscard]] const std::vector<Fault>& doubts() const noexcept { return doubts_; }
  [[nodiscard]] const std::map<std::string, Known>& known() const noexcept { return known_; }

 private:
  std::map<std::string, Known> known_;
  std::vector<Fault> all_;
  std::vector<Fault> doubts_;
  int count_ = 0;
};

/// The shortest text that reads back as the same double, always with a point or an exponent.
std::string toml_number(double v);
/// A quoted and escaped string.
std::string toml_string(std::string_view text);
/// A key, quoted where necessary.
std::string toml_key(std::string_view name);
/// A value as found, for messages: truncated if long.
std::string short_text(const Node& node);
/// Whether a node has the value of a TOML text; 90.0 equals 90.
bool same_word(const Node& node, std::string_view toml);
/// "a, b, c"
std::string joined(const std::vector<std::string>& names, std::string_view separator = ", ");
/// "table.name"
std::string path_to(const std::string& table_path, const std::string& name);
std::string path_to(const std::string& array_path, std::size_t index);

/// Reads a value of the given type; returns false after a fault. Integers are accepted as numbers; there is no other conversion.
bool read_value(const Node& node, double& out, const KeyInfo& info, Reading& reading, const std::string& path);
bool read_value(const Node& node, int& out, const KeyInfo& info, Reading& reading, const std::string& path);
bool read_value(const Node& node, bool& out, const KeyInfo& info, Reading& reading, const std::string& path);
bool read_value(const Node& node, std::string& out, const KeyInfo& info, Reading& reading, const std::string& path);

}  // namespace voussoir::io
