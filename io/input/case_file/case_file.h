// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/case.h"
#include "io/input/document/case_tree.h"
#include "io/input/messages/messages.h"

/// Reading of case files (TOML) to plain data, and writing. SI units, degrees.
namespace voussoir::io {

/// What is at fault in a case, found while reading it. what() is the complete message, "house.toml:14: house.height = -1 m: must be > 0";
/// several faults have a line each, in file order, and the other fields are those of the first.
class CaseFileError : public cases::InputError {
 public:
  /// \param faults  one or more, whose texts are the lines of the message \param problem  of the first
  CaseFileError(std::vector<Message> faults, const std::string& problem);
  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }
  /// Line number from 1; 0: an override or the whole file.
  [[nodiscard]] int line() const noexcept { return static_cast<int>(faults_.front().line); }
  [[nodiscard]] const std::vector<Message>& faults() const noexcept { return faults_; }

 private:
  std::vector<Message> faults_;
  std::string message_;
};

/// The text of a case from any source. `path` is its name in messages; relative files in the case start at `folder`.
struct CaseText {
  std::string path, text;
  std::string folder = ".";
  bool built_in = false;  // includes are looked up among the built-in parts first
};

/// The place of a key of a case, and its value there.
struct KeyPlace {
  Source source;
  std::string where;      // "house.toml:14" or "--set house.height=7"
  std::string file;       // empty: an override
  std::string value;      // "7 m"; empty: the key is a table
  bool included = false;  // from an included case, or from a ready case under overrides
};

/// A case, and the places of its keys.
struct LoadedCase {
  cases::Case value;
  std::string path;                      // as in CaseText
  std::map<std::string, KeyPlace> keys;  // by the path of InputError: "house.opening[1].width"; only keys that are given
  std::vector<std::string> notes;        // side effects of overrides
  std::vector<std::string> findings;     // accepted input that is probably a mistake: unusual values, keys without effect

  /// The complete message of a fault found later: "house.toml:14: house.opening[1].width = 7 m is wider than the wall (5.4 m)". If the key
  /// itself is not given, file and line are those of the nearest enclosing table.
  /// Several errors (cases::InputErrors) have a line each, in file order.
  [[nodiscard]] std::string describe(const cases::InputError& error) const;
  /// The same, error by error, with what each is about.
  [[nodiscard]] std::vector<Message> messages(const cases::InputError& error) const;
};

/// Finds a case and reads it: a name without '/' and without ".toml" is first looked up in the catalogue, anything else is a path.
/// Overrides are "a.b[0].c=value", as after --set: a TOML value, else a string; an empty value removes the key.
/// \throw FileError if the file cannot be read or is larger than 16 MB.
/// \throw CaseFileError for all faults in the file (then in the overrides): syntax, unknown or missing key, type, range, rule of a
/// table, or a name that is neither in the catalogue nor a file.
LoadedCase load_case(const std::string& name_or_path, const std::vector<std::string>& overrides = {});

/// Reads a case from memory; its includes are read from files. \throw FileError, CaseFileError as load_case.
LoadedCase read_case(const CaseText& text, const std::vector<std::string>& overrides = {});

/// A copy of the case with absolute paths to its files, so that its text can be stored anywhere. A path that is not UTF-8, which TOML
/// requires, stays unchanged.
cases::Case anchored(cases::Case value);

/// A copy of the case with file names without folders, to compare cases whose files are in different folders.
cases::Case without_folders(cases::Case value);

/// Every key with its value, defaults included, each with unit, allowed values and a sentence as comment; keys without a value appear as
/// comments. Coordinates are those of the file, whatever the origin of the case. Reading the text gives an equal case, bit for bit (except
/// `folder` and `origin`, which are no keys).
std::string resolved_toml(const cases::Case& value);

/// The reference of all keys of the case file by table, as plain text: name, unit, default, allowed values, a sentence.
std::string key_reference();

/// The key reference as Markdown, one table each: cases/KEYS.md.
std::string key_reference_markdown();

/// The key reference as JSON, for programs: an array of tables, each with its keys (io/README.md, Keys in JSON).
std::string key_reference_json();

}  // namespace voussoir::io
