// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// A TOML document as a plain tree in file order, which the option tables read. Only one source includes the TOML library.
namespace voussoir::io {

/// The place of a node: line and column from 1 in a file, or, if set >= 0, the index of an override.
struct Source {
  int line = 0, column = 0;
  int set = -1;
  int file = 0;  // index among the files of the case

  /// Whether this place precedes `o`: file order; overrides come after the file.
  [[nodiscard]] bool before(const Source& o) const noexcept {
    if ((set < 0) != (o.set < 0)) return set < 0;
    if (set != o.set) return set < o.set;
    if (file != o.file) return file < o.file;
    return line != o.line ? line < o.line : column < o.column;
  }
};

struct Entry;

/// A value of the document. Its source is the place of its key (in an array, of the value itself).
struct Node {
  struct Removed {};  // removed by an override
  struct Date {};     // a TOML date or time, which no key accepts
  using Array = std::vector<Node>;
  using Table = std::vector<Entry>;

  std::variant<Removed, Date, bool, std::int64_t, double, std::string, Array, Table> value;
  Source source;

  template <class T>
  [[nodiscard]] const T* as() const noexcept {
    return std::get_if<T>(&value);
  }
  template <class T>
  [[nodiscard]] T* as() noexcept {
    return std::get_if<T>(&value);
  }
  [[nodiscard]] bool removed() const noexcept { return std::holds_alternative<Removed>(value); }
};

struct Entry {
  std::string name;
  Node node;
};

/// The entry with that name, or nullptr.
const Entry* find_entry(const Node::Table& table, std::string_view name) noexcept;
Entry* find_entry(Node::Table& table, std::string_view name) noexcept;

/// A syntax error in a TOML text.
class SyntaxError : public std::runtime_error {
 public:
  SyntaxError(const std::string& reason, int line, int column) : std::runtime_error(reason), line_(line), column_(column) {}
  [[nodiscard]] int line() const noexcept { return line_; }
  [[nodiscard]] int column() const noexcept { return column_; }

 private:
  int line_, column_;
};

/// Parses a document; the result is a table with its entries in file order.
/// \throw SyntaxError for invalid TOML, and for more than 64 dots in one key (which limits the depth of nesting).
Node parse_document(std::string_view text);

/// Parses the value of an override: a TOML value, else the text itself as a string.
Node parse_value(const std::string& text);

/// Whether the text is valid UTF-8, as TOML strings must be.
bool is_utf8(std::string_view text);

/// Applies overrides "a.b[0].c=value" to the document. A number may stand for an index (a.b.0.c); missing tables are created, an index one
/// past the end appends, and an empty value removes the key. A source of the motion (motion.record, .x, ..., .V) replaces the other sources
/// in the document.
/// \return notes for the user: whole arrays of tables that were removed
/// \throw CaseFileError naming the override that cannot be applied.
std::vector<std::string> apply_overrides(Node& document, const std::vector<std::string>& overrides);

}  // namespace voussoir::io
