// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/checkpoint_stones.h"

#include <algorithm>
#include <cstddef>

namespace voussoir::io {
namespace {

std::int32_t count_of(std::size_t n) { return static_cast<std::int32_t>(n); }

void pack_piece(const cases::StonePiece& piece, PackedStones& out) {
  const auto& faces = piece.shape.faces;
  out.numbers.insert(out.numbers.end(), {count_of(piece.shape.vertices.size()), count_of(faces.size()), count_of(piece.beds.size())});
  out.numbers.insert(out.numbers.end(), piece.beds.begin(), piece.beds.end());
  for (const auto& loop : faces) {
    out.numbers.push_back(count_of(loop.size()));
    out.numbers.insert(out.numbers.end(), loop.begin(), loop.end());
  }
  for (const Vec3& v : piece.shape.vertices) out.vertices.insert(out.vertices.end(), {v.x, v.y, v.z});
}

/// Reads items from the lists in order; `good` becomes false once an item is missing or out of range.
class Unpacker {
 public:
  explicit Unpacker(const PackedStones& packed) : in_(packed) {}

  std::optional<StoneTables> unpack() {
    StoneTables tables;
    for (std::int32_t t = number(0, left()); t > 0 && good_; --t) {
      auto& stones = tables.emplace_back();
      for (std::int32_t s = number(0, left()); s > 0 && good_; --s) stones.push_back(stone());
    }
    if (!good_ || number_ != in_.numbers.size() || vertex_ != in_.vertices.size() || text_ != in_.texts.size()) return std::nullopt;
    return tables;
  }

 private:
  [[nodiscard]] std::int32_t left() const { return count_of(in_.numbers.size() - number_); }
  std::int32_t number(std::int32_t least, std::int32_t most) {
    if (!good_ || number_ >= in_.numbers.size() || in_.numbers[number_] < least || in_.numbers[number_] > most) {
      good_ = false;
      return least;
    }
    return in_.numbers[number_++];
  }
  std::string text() {
    if (text_ < in_.texts.size()) return in_.texts[text_++];
    good_ = false;
    return "";
  }

  cases::Stone stone() {
    cases::Stone s;
    s.name = text();
    s.fixed = number(0, 1) != 0;
    for (std::int32_t g = number(0, count_of(in_.texts.size())); g > 0 && good_; --g) s.groups.push_back(text());
    for (std::int32_t p = number(1, std::max(1, left())); p > 0 && good_; --p) s.pieces.push_back(piece());
    return s;
  }

  cases::StonePiece piece() {
    cases::StonePiece out;
    const std::int32_t vertices = number(4, std::max(4, count_of((in_.vertices.size() - vertex_) / 3)));
    const std::int32_t faces = number(4, std::max(4, left())), beds = number(0, faces);
    for (std::int32_t b = 0; b < beds && good_; ++b) out.beds.push_back(number(0, faces - 1));
    for (std::int32_t f = 0; f < faces && good_; ++f) {
      auto& loop = out.shape.faces.emplace_back();
      for (std::int32_t k = number(3, std::max(3, left())); k > 0 && good_; --k) loop.push_back(number(0, vertices - 1));
    }
    if (in_.vertices.size() - vertex_ < 3 * static_cast<std::size_t>(vertices)) good_ = false;
    for (std::int32_t v = 0; v < vertices && good_; ++v, vertex_ += 3)
      out.shape.vertices.push_back({in_.vertices[vertex_], in_.vertices[vertex_ + 1], in_.vertices[vertex_ + 2]});
    return out;
  }

  const PackedStones& in_;
  std::size_t number_ = 0, vertex_ = 0, text_ = 0;
  bool good_ = true;
};

}  // namespace

PackedStones packed_stones(const StoneTables& tables) {
  PackedStones out;
  out.numbers.push_back(count_of(tables.size()));
  for (const auto& stones : tables) {
    out.numbers.push_back(count_of(stones.size()));
    for (const cases::Stone& s : stones) {
      out.texts.push_back(s.name);
      out.texts.insert(out.texts.end(), s.groups.begin(), s.groups.end());
      out.numbers.insert(out.numbers.end(), {s.fixed ? 1 : 0, count_of(s.groups.size()), count_of(s.pieces.size())});
      for (const cases::StonePiece& p : s.pieces) pack_piece(p, out);
    }
  }
  return out;
}

std::optional<StoneTables> unpacked_stones(const PackedStones& packed) { return Unpacker(packed).unpack(); }

}  // namespace voussoir::io
