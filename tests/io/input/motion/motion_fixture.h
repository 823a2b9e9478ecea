// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "io/input/files/errors.h"
#include "io/input/motion/formats/read_motion.h"
#include "tests/io/temp_folder.h"

/// What tests of the formats of ground motion share: small files made here, and ways to spoil them.
namespace motion_fixture {

using voussoir::io::Channel;
using Reader = std::vector<Channel> (*)(const std::string& path);

constexpr double kG = 9.80665;  // m/s2

inline std::string with_crlf(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return out;
}

/// The text with its first `from` replaced, which must be there.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t found = text.find(from);
  REQUIRE(found != std::string::npos);
  return text.replace(found, from.size(), to);
}

/// The text up to the first `mark`, which must be there.
inline std::string before(const std::string& text, const std::string& mark) {
  const std::size_t found = text.find(mark);
  REQUIRE(found != std::string::npos);
  return text.substr(0, found);
}

/// Values in Fortran's columns: printed by `format`, `per_line` on a line.
inline std::string columns(const std::vector<double>& values, int per_line, const char* format) {
  std::string out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    char number[64];
    std::snprintf(number, sizeof number, format, values[i]);
    out += number;
    if ((i + 1) % static_cast<std::size_t>(per_line) == 0 || i + 1 == values.size()) out += '\n';
  }
  return out;
}

/// One component of a BHRC V1 file; values in tenths of g.
inline std::string bhrc_component(char letter, const std::vector<double>& values, double duration) {
  char counts[80];
  std::snprintf(counts, sizeof counts, "NO. OF POINTS = %6zu      DURATION = %7.3f\n", values.size(), duration);
  std::string text = "* VOL1DS FILE:  1234/01\nInst Type = SSA-2\nOrigin Time : 2001/02/03   12:00:00\n\n" + std::string(1, letter) +
                     "\n\nCOMP " + letter + "1\nTown                      Station   30.0 N 50.0 E   Altitude 1m   Azimuth L 316   T 46\n" +
                     "Epicenter 30.0 N 50.0 E\nINSTR PERIOD =  .019 SEC   DAMPING =  .640\n" + counts + "UNITS ARE SECONDS AND G/10\n\n";
  for (int i = 0; i < 7; ++i) text += "    0    0    015360    0\n";
  for (int i = 0; i < 7; ++i) text += "  .000000E+00  .000000E+00  .00\n";
  return text + columns(values, 10, "%13.6E") + "/&\n";
}

inline std::vector<Channel> read_text(Reader read, const std::string& text) {
  const TempFolder folder;
  return read(folder.write("quake.dat", text));
}

/// Expects a refusal whose message, after the path, begins with this.
inline void check_fault(Reader read, const std::string& text, const std::string& message) {
  const TempFolder folder;
  const std::string path = folder.write("quake.dat", text);
  CAPTURE(message);
  try {
    read(path);
    FAIL("no error");
  } catch (const voussoir::io::FileError& e) {
    CHECK(e.path() == path);
    const std::string what = e.what();
    CHECK(what.substr(0, path.size() + message.size()) == path + message);
  }
}

/// The text cut after every byte is refused, or read as what stands before the cut, whole components. Never other values or counts, never a
/// crash.
inline void check_cuts(Reader read, const std::string& text) {
  const auto whole = read_text(read, text);
  int refused = 0;
  for (std::size_t size = 0; size < text.size(); ++size) {
    CAPTURE(size);
    try {
      const auto cut = read_text(read, text.substr(0, size));
      REQUIRE(cut.size() <= whole.size());
      for (std::size_t i = 0; i < cut.size(); ++i) {
        auto a = cut[i].motion.acceleration, b = whole[i].motion.acceleration;
        REQUIRE(a.size() == b.size());
        a.pop_back();
        b.pop_back();
        REQUIRE(a == b);
      }
    } catch (const voussoir::io::FileError&) {
      ++refused;
    }
  }
  CHECK(refused > static_cast<int>(text.size() / 2));
}

}  // namespace motion_fixture
