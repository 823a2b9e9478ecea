// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cases/names.h"
#include "io/input/document/case_values.h"
#include "io/input/document/toml_shapes.h"

/// One option table per struct of the case: name, unit, allowed values, a sentence, and the location of the value. The table serves to
/// read, to check, to write the resolved case and to print the key reference.
namespace voussoir::io {

// ---- Values of composed types: read_value (node to value), value_text (value to TOML, empty: absent), shape_of (words for messages).

inline std::string value_text(double v) { return toml_number(v); }
inline std::string value_text(int v) { return std::to_string(v); }
inline std::string value_text(bool v) { return v ? "true" : "false"; }
inline std::string value_text(const std::string& v) { return toml_string(v); }

std::string value_text(Vec3 v);
template <class T, std::size_t N>
std::string value_text(const std::array<T, N>& v);
template <class T>
std::string value_text(const std::vector<T>& v);

template <class T>
std::string list_text(const T& values) {
  std::vector<std::string> texts;
  for (const auto& v : values) texts.push_back(value_text(v));
  return "[" + joined(texts) + "]";
}
inline std::string value_text(Vec3 v) { return list_text(std::array{v.x, v.y, v.z}); }
template <class T, std::size_t N>
std::string value_text(const std::array<T, N>& v) {
  return list_text(v);
}
template <class T>
std::string value_text(const std::vector<T>& v) {
  return v.empty() ? "" : list_text(v);
}
template <class T>
std::string value_text(const std::optional<T>& v) {
  return v ? value_text(*v) : "";
}

template <class T, std::size_t N>
bool read_value(const Node& node, std::array<T, N>& out, const KeyInfo& info, Reading& reading, const std::string& path);
bool read_value(const Node& node, Vec3& out, const KeyInfo& info, Reading& reading, const std::string& path);

/// Reads an element of an array like a plain value; a fault names the element.
template <class T>
bool read_element(const Node& node, T& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  KeyInfo element = info;
  element.shape = TomlShape<T>::text();
  return read_value(node, out, element, reading, path);
}
template <class T, std::size_t N>
bool read_value(const Node& node, std::array<T, N>& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  const auto* array = node.as<Node::Array>();
  if (array == nullptr) {
    reading.wrong_type(node, path, info);
    return false;
  }
  if (array->size() != N) {
    reading.bad_value(node, path, info, "has " + std::to_string(array->size()) + " values, wanted " + info.shape);
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < N; ++i) good = read_element((*array)[i], out[i], info, reading, path_to(path, i)) && good;
  return good;
}
inline bool read_value(const Node& node, Vec3& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  std::array<double, 3> v{};
  if (!read_value(node, v, info, reading, path)) return false;
  out = {v[0], v[1], v[2]};
  return true;
}
template <class T>
bool read_value(const Node& node, std::vector<T>& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  const auto* array = node.as<Node::Array>();
  if (array == nullptr) {
    reading.wrong_type(node, path, info);
    return false;
  }
  bool good = true;
  out.assign(array->size(), T{});
  for (std::size_t i = 0; i < out.size(); ++i) good = read_element((*array)[i], out[i], info, reading, path_to(path, i)) && good;
  return good;
}
template <class T>
bool read_value(const Node& node, std::optional<T>& out, const KeyInfo& info, Reading& reading, const std::string& path) {
  T v{};
  if (!read_value(node, v, info, reading, path)) return false;
  out = std::move(v);
  return true;
}

// ---- Tables.

/// The name of a table in text: "house.opening" for headers, with <name> or [[ ]] for the reference.
struct Header {
  std::string path;
  bool array = false;
  [[nodiscard]] std::string text() const { return path.empty() ? "" : (array ? "[[" + path + "]]" : "[" + path + "]"); }
};

/// A table of the key reference, for programs.
struct ListedTable {
  struct Row {
    KeyInfo info;
    std::string default_text;  // TOML; empty: none
  };
  Header at;
  std::string sentence;
  std::vector<Row> keys{};
  std::vector<ValueType> in_place{};  // values that may stand in place of the table
};

/// Collects the lines of a resolved case or of the key reference (plain, or as Markdown tables), or its tables themselves.
struct Lines {
  std::string out;
  bool markdown = false;
  std::vector<ListedTable>* tables = nullptr;  // null: lines
  void header(const Header& at, const std::string& sentence);
  void absent_table(const Header& at, const std::string& sentence);
  /// Appends "name = text # comment"; for an empty text, the comment only.
  void key(const KeyInfo& info, const std::string& text);
  void reference(const KeyInfo& info, const std::string& default_text);
  /// A value that may stand in place of the table with that path.
  void in_place_of(const std::string& path, const KeyInfo& info) const;
};

/// A key of struct S: a value (`text`), or a table or tables (`write` and `list`).
template <class S>
struct Key {
  KeyInfo info;
  std::function<void(const Node&, S&, Reading&, const std::string& path)> read;
  std::function<std::string(const S&)> text;
  std::function<void(const S&, Lines&, const std::string& path)> write;
  std::function<void(Lines&, const std::string& path)> list;
};

/// Queries and reports for the rules of a table; keys are relative to the table.
struct RuleCheck {
  const Node& table;
  Reading& reading;
  const std::string& path;

  [[nodiscard]] bool given(std::string_view key) const;
  /// Whether both keys are given in one file (possibly an included one): neither is an override or inherited from another file.
  [[nodiscard]] bool given_together(std::string_view key, std::string_view other) const;
  /// Reports a fault of the key, or of the table if key is empty.
  void fault(const std::string& key, const std::string& problem) const;
  /// Reports an accepted value that is probably a mistake.
  void doubt(const std::string& key, const std::string& problem) const;

 private:
  [[nodiscard]] Fault at(const std::string& key, const std::string& problem) const;
};

/// All keys of struct S, and the rules between keys (called only when each single key is valid).
template <class S>
struct Table {
  std::string sentence;
  std::vector<Key<S>> keys;
  std::function<void(const S&, const RuleCheck&)> rules;

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Key<S>& key : keys) all.push_back(key.info.name);
    return all;
  }
};

template <class S>
void read_table(const Table<S>& table, const Node& node, S& out, Reading& reading, const std::string& path) {
  const Node::Table* entries = reading.table_of(node, path);
  if (entries == nullptr) return;
  const int before = reading.faults();
  bool misspelt = false;
  for (const Entry& entry : *entries) {
    const auto key = std::find_if(table.keys.begin(), table.keys.end(), [&](const Key<S>& k) { return k.info.name == entry.name; });
    if (key == table.keys.end()) {
      reading.unknown_key(entry, path, table.names());
      misspelt = true;
    } else if (!entry.node.removed()) {
      const std::string key_path = path_to(path, entry.name);
      reading.know(key_path, entry.node, key->info.unit);
      key->read(entry.node, out, reading, key_path);
    }
  }
  const RuleCheck check{node, reading, path};
  for (const Key<S>& key : table.keys) {
    // A misspelt key is a better message than the missing key that it causes.
    if (!misspelt && key.info.required && !check.given(key.info.name)) reading.missing_key(node, path, key.info);
  }
  if (table.rules && reading.faults() == before) table.rules(out, check);
}

template <class S>
void write_table(const Table<S>& table, const S& value, Lines& lines, const std::string& path) {
  for (const Key<S>& key : table.keys) {
    if (key.text) lines.key(key.info, key.text(value));
  }
  for (const Key<S>& key : table.keys) {
    if (key.write) key.write(value, lines, path_to(path, key.info.name));
  }
}

template <class S>
void list_table(const Table<S>& table, Lines& lines, const Header& at) {
  lines.header(at, table.sentence);
  const S defaults{};
  for (const Key<S>& key : table.keys) {
    if (key.text) lines.reference(key.info, key.text(defaults));
  }
  for (const Key<S>& key : table.keys) {
    if (key.list) key.list(lines, path_to(at.path, key.info.name));
    if (key.list && !key.info.types.empty()) lines.in_place_of(path_to(at.path, key.info.name), key.info);
  }
}

// ---- Multiplicity of a table in its parent: always, optional, several in an array, several by name.

template <class S>
struct SubTable {
  static void read(const Table<S>& t, const Node& node, S& out, Reading& reading, const std::string& path) {
    read_table(t, node, out, reading, path);
  }
  static void write(const Table<S>& t, const S& value, Lines& lines, const std::string& path) {
    lines.header({path}, t.sentence);
    write_table(t, value, lines, path);
  }
  static void list(const Table<S>& t, Lines& lines, const std::string& path) { list_table(t, lines, {path}); }
};
template <class S>
struct SubTable<std::optional<S>> {
  static void read(const Table<S>& t, const Node& node, std::optional<S>& out, Reading& reading, const std::string& path) {
    read_table(t, node, out.emplace(), reading, path);
  }
  static void write(const Table<S>& t, const std::optional<S>& value, Lines& lines, const std::string& path) {
    if (value) return SubTable<S>::write(t, *value, lines, path);
    lines.absent_table({path}, t.sentence);
  }
  static void list(const Table<S>& t, Lines& lines, const std::string& path) { list_table(t, lines, {path}); }
};
template <class S>
struct SubTable<std::vector<S>> {
  static void read(const Table<S>& t, const Node& node, std::vector<S>& out, Reading& reading, const std::string& path) {
    const Node::Array* nodes = reading.array_of(node, path);
    if (nodes == nullptr) return;
    for (std::size_t i = 0; i < nodes->size(); ++i) {
      reading.know(path_to(path, i), (*nodes)[i], "");
      read_table(t, (*nodes)[i], out.emplace_back(), reading, path_to(path, i));
    }
  }
  static void write(const Table<S>& t, const std::vector<S>& values, Lines& lines, const std::string& path) {
    for (const S& value : values) {
      lines.header({path, true}, t.sentence);
      write_table(t, value, lines, path);
    }
    if (values.empty()) lines.absent_table({path, true}, t.sentence);
  }
  static void list(const Table<S>& t, Lines& lines, const std::string& path) { list_table(t, lines, {path, true}); }
};
template <class S>
struct SubTable<std::map<std::string, S>> {
  static void read(const Table<S>& t, const Node& node, std::map<std::string, S>& out, Reading& reading, const std::string& path) {
    const Node::Table* entries = reading.table_of(node, path);
    if (entries == nullptr) return;
    for (const Entry& entry : *entries) {
      if (entry.node.removed()) continue;
      reading.know(path_to(path, entry.name), entry.node, "");
      read_table(t, entry.node, out[entry.name], reading, path_to(path, entry.name));
    }
  }
  static void write(const Table<S>& t, const std::map<std::string, S>& values, Lines& lines, const std::string& path) {
    for (const auto& [name, value] : values) {
      lines.header({path_to(path, toml_key(name))}, t.sentence);
      write_table(t, value, lines, path_to(path, toml_key(name)));
    }
    if (values.empty()) lines.absent_table({path_to(path, "<name>")}, t.sentence);
  }
  static void list(const Table<S>& t, Lines& lines, const std::string& path) { list_table(t, lines, {path_to(path, "<name>")}); }
};

// ---- Makers of keys. `get` is a member pointer or a function from S& to the value.

template <class S, class Get>
using Member = std::remove_cvref_t<std::invoke_result_t<Get, S&>>;

/// A key for a number, an array of numbers, a truth value, a string, ...
template <class S, class Get>
Key<S> value(std::string name, Get get, std::string unit, Limits limits, std::string sentence) {
  KeyInfo info{std::move(name), std::move(unit), std::move(sentence), limits,
               TomlShape<Member<S, Get>>::text(), false, {TomlShape<Member<S, Get>>::type()}};
  return {info,
          [=](const Node& node, S& s, Reading& reading, const std::string& path) {
            read_value(node, std::invoke(get, s), info, reading, path);
          },
          [=](const S& s) { return value_text(std::invoke(get, s)); }, nullptr, nullptr};
}

/// A key for a number, or the word "auto" for none.
template <class S>
Key<S> auto_or_number(std::string name, std::optional<double> S::*get, std::string unit, Limits limits, std::string sentence) {
  Key<S> key = value<S>(std::move(name), get, std::move(unit), limits, std::move(sentence));
  key.info.shape = "\"auto\" or a number", key.info.words = {"\"auto\""};
  key.read = [get, info = key.info](const Node& node, S& s, Reading& reading, const std::string& path) {
    if (same_word(node, "\"auto\"")) {
      (s.*get).reset();
    } else if (!reading.mistyped(node, path, info, {"auto"})) {
      read_value(node, s.*get, info, reading, path);
    }
  };
  key.text = [get](const S& s) { return s.*get ? value_text(*(s.*get)) : "\"auto\""; };
  return key;
}

template <class T>
std::vector<std::string> names_of(const std::vector<std::pair<std::string, T>>& words) {
  std::vector<std::string> names;
  for (const auto& word : words) names.push_back(word.first);
  return names;
}

/// A key with a choice of words, each with its value; words for a number are the number itself, without quotes.
template <class S, class Get, class T>
Key<S> choice(std::string name, Get get, std::string unit, std::vector<std::pair<std::string, T>> words, std::string sentence) {
  const auto toml = [](const std::string& word) { return std::is_same_v<T, double> || std::is_same_v<T, int> ? word : toml_string(word); };
  std::vector<std::string> texts;
  for (const auto& word : words) texts.push_back(toml(word.first));
  KeyInfo info{std::move(name), std::move(unit), std::move(sentence), any(), joined(texts, " | "), false, {}, texts};
  const auto read = [=](const Node& node, S& s, Reading& reading, const std::string& path) {
    for (const auto& [word, meaning] : words) {
      if (same_word(node, toml(word))) {
        std::invoke(get, s) = meaning;
        return;
      }
    }
    if (!reading.mistyped(node, path, info, names_of(words))) reading.bad_value(node, path, info, "must be " + info.shape);
  };
  const auto text = [=](const S& s) -> std::string {
    for (const auto& [word, meaning] : words) {
      if (std::invoke(get, s) == meaning) return toml(word);
    }
    return "";
  };
  return {info, read, text, nullptr, nullptr};
}

/// A key for a table, possibly optional, or for tables in an array or by name.
template <class S, class Get, class T>
Key<S> table(std::string name, Get get, Table<T> of) {
  using Sub = SubTable<Member<S, Get>>;
  const auto t = std::make_shared<const Table<T>>(std::move(of));
  return {
      {std::move(name), "", t->sentence, any(), "a table", false},
      [=](const Node& node, S& s, Reading& reading, const std::string& path) { Sub::read(*t, node, std::invoke(get, s), reading, path); },
      nullptr,
      [=](const S& s, Lines& lines, const std::string& path) { Sub::write(*t, std::invoke(get, s), lines, path); },
      [=](Lines& lines, const std::string& path) { Sub::list(*t, lines, path); }};
}

template <class S>
Key<S> required(Key<S> key) {
  key.info.required = true;
  return key;
}

}  // namespace voussoir::io
