// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/case.h"

/// The case file: TOML in, plain data out, and the way back. SI units, degrees.
namespace voussoir::io {

/// A fault found while reading a case. what() is the whole message: "house.toml:14: house.height = -1 m: must be > 0".
class CaseFileError : public cases::InputError {
 public:
  CaseFileError(std::string message, const std::string& key, const std::string& problem, int line)
      : InputError(key, problem), message_(std::move(message)), line_(line) {}
  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }
  /// From 1; 0: an override or the whole file.
  [[nodiscard]] int line() const noexcept { return line_; }

 private:
  std::string message_;
  int line_;
};

/// The text of a case, wherever it came from. `path` names it in messages; relative files in the case start at `folder`.
struct CaseText {
  std::string path, text;
  std::string folder = ".";
  bool built_in = false;  // what it includes is looked for among the built-in parts first
};

/// Where a key of a case was written, and as what.
struct KeyPlace {
  std::string where;      // "house.toml:14" or "--set house.height=7"
  std::string value;      // "7 m"; empty: a table
  bool included = false;  // written in a case that this one includes, or in a ready case that overrides are laid over
};

/// A case, and where each of its keys was written.
struct LoadedCase {
  cases::Case value;
  std::string path;                      // as in CaseText
  std::map<std::string, KeyPlace> keys;  // by the path of InputError: "house.opening[1].width"; only keys that are given
  std::vector<std::string> notes;        // what overrides did beside what they say
  std::vector<std::string> findings;     // what is let through, but is likely a slip: unusual values, keys without effect

  /// The whole message of a fault found later: "house.toml:14: house.opening[1].width = 7 m is wider than the wall (5.4 m)".
  /// If the key itself is not given, file and line are those of the nearest table around it.
  [[nodiscard]] std::string describe(const cases::InputError& error) const;
};

/// Finds a case and reads it: a name without '/' and without ".toml" is first looked up in the catalogue, anything else is a path.
/// Overrides are "a.b[0].c=value", as after --set: a TOML value, else a string; an empty value takes the key away.
/// \throw FileError if the file cannot be read or is larger than 16 MB.
/// \throw CaseFileError for the first fault in the file (then in the overrides): syntax, unknown or missing key, type, range, rule of a
/// table, or a name that is neither in the catalogue nor a file.
LoadedCase load_case(const std::string& name_or_path, const std::vector<std::string>& overrides = {});

/// Reads a case that is already in memory; what it includes is read from files. \throw FileError, CaseFileError as load_case.
LoadedCase read_case(const CaseText& text, const std::vector<std::string>& overrides = {});

/// The same case with absolute paths to the files that it names, so that it means the same wherever its text lies. A path that would not be
/// UTF-8, which TOML cannot hold, stays as it is.
cases::Case anchored(cases::Case value);

/// The same case with the names of these files alone: does another case mean the same, wherever its files lie?
cases::Case without_folders(cases::Case value);

/// Every key with its value, defaults included, each with unit, allowed values and a sentence as comment; keys without a value stand as
/// comments. Reading it gives an equal case, bit for bit (but for `folder`, which is no key).
std::string resolved_toml(const cases::Case& value);

/// All keys of the case file by table: name, unit, default, allowed values, a sentence. For printing.
std::string key_reference();

/// The same as Markdown, a table each: cases/KEYS.md.
std::string key_reference_markdown();

}  // namespace voussoir::io
