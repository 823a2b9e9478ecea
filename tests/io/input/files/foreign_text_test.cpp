// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/foreign_text.h"

#include <doctest/doctest.h>

#include "io/input/files/errors.h"
#include "io/input/motion/formats/read_motion.h"
#include "tests/io/temp_folder.h"

using namespace voussoir::io;
using namespace std::string_literals;

TEST_CASE("foreign text: UTF-8 as it is, without its mark; else Windows-1252") {
  CHECK(as_utf8("f", "plain") == "plain");
  CHECK(as_utf8("f", "\xEF\xBB\xBFm\xC2\xB2") == "m\xC2\xB2");
  CHECK(as_utf8("f", "m\xB2 \x80") == "m\xC2\xB2 \xE2\x82\xAC");
  for (const char* wrong : {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\xE0\x80\x80", "\xFF"}) CHECK(!is_all_utf8(wrong));
  for (const char* right : {"\xF0\x9F\x98\x80", "\xED\x9F\xBF", "\xE2\x82\xAC", "a\xC3\xBC"}) CHECK(is_all_utf8(right));
}

TEST_CASE("foreign text: UTF-16 of either order; what is cut is refused") {
  CHECK(as_utf8("f",
                "\xFF\xFE"
                "a\0\xB2\0\x3D\xD8\x00\xDE"s) == "a\xC2\xB2\xF0\x9F\x98\x80");
  CHECK(as_utf8("f", "\xFE\xFF\0a\0\xB2"s) == "a\xC2\xB2");
  CHECK_THROWS_WITH_AS(as_utf8("f",
                               "\xFF\xFE"
                               "a\0b"s),
                       "f: is in UTF-16 and ends within a character; save it in UTF-8", FileError);
  CHECK_THROWS_WITH_AS(as_utf8("f", "\xFF\xFE\x3D\xD8"s), "f: is in UTF-16 and holds half a character; save it in UTF-8", FileError);
}

TEST_CASE("foreign text: UTF-16 without a byte order mark") {
  CHECK(as_utf8("f", "a\0\xB2\0"s) == "a\xC2\xB2");
  CHECK(as_utf8("f", "\0a\0\xB2"s) == "a\xC2\xB2");
  CHECK(as_utf8("f", "o\0 \0\xA0\x03\xAD\x03\xC4\x03"s) == "o \xCE\xA0\xCE\xAD\xCF\x84");
  for (const std::string& no : {"a\0\0\0b\0"s, "ab\0c"s, "a\0bcdefghijklmnopqrstuvwxyz"s, ""s, "a"s}) CHECK(utf16_of(no) == Utf16::no);
  CHECK_THROWS_WITH_AS(as_utf8("f", "a\0b\0c"s), "f: is in UTF-16 and ends within a character; save it in UTF-8", FileError);
}

TEST_CASE("foreign text: a record in UTF-16, and one whose station is in Latin-1") {
  const TempFolder folder;
  std::string wide = "\xFF\xFE";
  for (const char c : "t [s], a [m/s2]\n0,1\n0.5,2\n"s) (wide += c) += '\0';
  CHECK(read_accelerogram(folder.write("a.csv", wide), {}).acceleration == std::vector<double>{1.0, 2.0});
  CHECK(read_accelerogram(folder.write("b.csv", wide.substr(2)), {}).acceleration == std::vector<double>{1.0, 2.0});
  const std::string at2 = "PEER\nSt\xFCrze\nACCELERATION TIME SERIES IN UNITS OF G\n2 0.01 NPTS, DT\n 1.0 2.0\n";
  CHECK(read_accelerogram(folder.write("a.AT2", at2), {}).name == "St\xC3\xBCrze");
}
