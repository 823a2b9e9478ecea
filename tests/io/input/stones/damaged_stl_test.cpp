// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>

#include "tests/io/input/stones/written_files.h"

using namespace stones;

namespace {

const std::vector<Mesh> kTwo{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};  // 24 triangles

std::string with_count(std::string binary, std::uint32_t count) {
  for (std::size_t i = 0; i < 4; ++i) binary[80 + i] = static_cast<char>(count >> (8 * i) & 255U);
  return binary;
}

std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

bool says(const std::string& message, const std::string& words) {
  CAPTURE(message);
  return message.find(words) != std::string::npos;
}

bool has_doubt(const voussoir::cases::Case& c, const std::string& words) {
  return std::ranges::any_of(c.stones[0].doubts, [&](const std::string& doubt) { return doubt.find(words) != std::string::npos; });
}

std::string in_utf16(const std::string& ascii) {
  std::string out = "\xFF\xFE";
  for (const char c : ascii) (out += c) += '\0';
  return out;
}

}  // namespace

TEST_CASE("STL, ASCII: capitals, blanks, byte order marks and UTF-16 are read") {
  const TempFolder folder;
  const std::string plain = stl(kTwo, true);
  for (const std::string& text : {plain, in_capitals(plain), "\n\n   " + plain, "\xEF\xBB\xBF" + plain, in_utf16(plain)}) {
    const auto c = load(folder.write("a.stl", text));
    CHECK(c.stones[0].stones.size() == 2);
    CHECK(c.stones[0].doubts.empty());
  }
  const auto cut = load(folder.write("a.stl", plain.substr(0, plain.rfind("endsolid"))));
  CHECK(has_doubt(cut, "ends without 'endsolid'"));
  const std::size_t end = plain.rfind("endsolid");
  const auto torn =
      load(folder.write("a.stl", stl({kTwo[0]}, true).substr(0, stl({kTwo[0]}, true).rfind("endsolid")) + stl({kTwo[1]}, true)));
  CHECK(has_doubt(torn, "before 'endsolid' of the last: lines may be missing"));
  const auto odd = load(folder.write("a.stl", plain.substr(0, end) + "vortex 1 2 3\n" + plain.substr(end)));
  CHECK(has_doubt(odd, "left out: 1 line that is not of STL, the first with 'VORTEX' in line "));
}

TEST_CASE("STL, binary: what head and length disagree on is taken with a doubt where all is there") {
  const TempFolder folder;
  const std::string plain = stl(kTwo, false);
  for (const std::uint32_t count : {0U, 4294967295U}) {
    const auto c = load(folder.write("a.stl", with_count(plain, count)));
    CHECK(c.stones[0].stones.size() == 2);
    CHECK(has_doubt(c, "its head says " + std::to_string(count) + " triangles, its length holds 24: taken are the 24"));
  }
  const auto c = load(folder.write("a.stl", plain + "0123456789"));
  CHECK(c.stones[0].stones.size() == 2);
  CHECK(has_doubt(c, "its length holds 24 and 10 bytes: the bytes behind the last triangle are passed over"));
}

TEST_CASE("STL, binary: a file that was cut or damaged is refused with both counts") {
  const TempFolder folder;
  const std::string plain = stl(kTwo, false);
  const auto refused = [&](const std::string& bytes) { return refusal(folder.write("a.stl", bytes)); };
  CHECK(says(refused(plain.substr(0, plain.size() - 20)),
             "a.stl: its head says 24 triangles, its length holds 23 and 30 bytes: it was cut; export it again"));
  CHECK(says(refused(with_count(plain, 12)), "its head says 12 triangles, its length holds 24: it was damaged; export it again"));
  CHECK(says(refused(with_count(plain, 0).substr(0, plain.size() - 20)), "its length holds 23 and 30 bytes: it was damaged"));
  CHECK(says(refused(plain.substr(0, 60) + std::string(1, '\0')), "it was cut; export it again"));
}

TEST_CASE("OBJ, PLY: names in Latin-1 are UTF-8 afterwards; a byte order mark and UTF-16 are read") {
  const TempFolder folder;
  const std::string text = obj({{"Pfeiler_\xFC", kTwo[0]}, {"b", kTwo[1]}});
  const auto c = load(folder.write("a.obj", text));
  REQUIRE(c.stones[0].stones.size() == 2);
  CHECK(c.stones[0].stones[0].name == "Pfeiler_\xC3\xBC");
  const std::string ascii = obj({{"a", kTwo[0]}, {"b", kTwo[1]}});
  CHECK(load(folder.write("b.obj", in_utf16(ascii))).stones[0].stones.size() == 2);
  const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  CHECK(says(refusal(folder.write("e.stl", in_utf16(stl).substr(2))), "e.stl:4"));  // read as text: its last line is told
  CHECK(load(folder.write("b.obj", in_utf16(ascii).substr(2))).stones[0].stones.size() == 2);
  CHECK(load(folder.write("c.obj", "\xEF\xBB\xBF" + ascii)).stones[0].stones.size() == 2);
  for (const Ply kind : {Ply::ascii, Ply::little}) {
    CHECK(load(folder.write("d.ply", "\xEF\xBB\xBF" + ply(kTwo[0], kind))).stones[0].stones.size() == 1);
  }
}
