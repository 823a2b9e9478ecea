// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/io/shell.h"

/// Tables of studies, as tests of scripts/study write them.
namespace study {

/// A script of scripts/study, to be followed by its words.
inline std::string script(const char* name) { return "/usr/bin/python3 " + shell::source(std::string("scripts/study/") + name) + " "; }

/// A table of runs: columns that a statement may ask for, and rows that fill some of them.
class Table {
 public:
  using Values = std::map<std::string, std::string>;

  void add(const std::string& house, const std::string& record, Values values) {
    values.insert({{"run", "r" + std::to_string(rows_.size())},
                   {"case", house},
                   {"direction", "TLV"},
                   {"record", record},
                   {"status", "done"},
                   {"collapsed", "0"},
                   {"end_time", "10.0"},
                   {"options", ""}});
    for (const auto& [column, value] : values) columns_.insert(column);
    rows_.push_back(std::move(values));
  }
  [[nodiscard]] std::string text() const {
    std::string out;
    for (const std::string& column : columns_) out += (out.empty() ? "" : ",") + column;
    for (const Values& row : rows_) {
      std::string line;
      for (const std::string& column : columns_) line += (line.empty() ? "\n" : ",") + (row.contains(column) ? row.at(column) : "");
      out += line;
    }
    return out + "\n";
  }

 private:
  std::set<std::string> columns_;
  std::vector<Values> rows_;
};

/// Of the front and the rear wall, and of both side walls: what has fallen of them. What is left is upright.
inline Table::Values walls(const std::string& front, const std::string& rear, const std::string& sides = "0.0") {
  const std::string fallen = " wall: fallen_mass_fraction", drift = " wall: residual_drift";
  return {{"front" + fallen, front}, {"rear" + fallen, rear}, {"left" + fallen, sides}, {"right" + fallen, sides},
          {"front" + drift, "0.0"},  {"rear" + drift, "0.0"}, {"left" + drift, "0.0"},  {"right" + drift, "0.0"}};
}

inline Table::Values with(Table::Values values, const Table::Values& more) {
  for (const auto& [column, value] : more) values[column] = value;
  return values;
}

inline const Table::Values kStands = walls("0.0", "0.02");
inline Table::Values collapsed_at(double time, double end) {
  return with(walls("0.6", "0.9"), {{"collapsed", "1"}, {"collapse_time", std::to_string(time)}, {"end_time", std::to_string(end)}});
}

}  // namespace study
