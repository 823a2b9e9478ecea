// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace voussoir::geometry {

/// Faces of a polyhedron as loops of vertex indices. Used like a vector of loops; copies share their loops until one of them is written to,
/// since thousands of bricks have the same.
class FaceLoops {
 public:
  using Loop = std::vector<std::int32_t>;
  using Loops = std::vector<Loop>;
  using value_type = Loop;

  FaceLoops() = default;
  FaceLoops(std::initializer_list<Loop> loops) : FaceLoops(Loops(loops)) {}
  FaceLoops(Loops loops) : loops_(std::make_shared<Loops>(std::move(loops))) {}  // NOLINT(google-explicit-constructor)
  operator const Loops&() const noexcept { return all(); }                       // NOLINT(google-explicit-constructor)

  [[nodiscard]] std::size_t size() const noexcept { return all().size(); }
  [[nodiscard]] bool empty() const noexcept { return all().empty(); }
  [[nodiscard]] auto begin() const noexcept { return all().begin(); }
  [[nodiscard]] auto end() const noexcept { return all().end(); }
  const Loop& operator[](std::size_t i) const noexcept { return all()[i]; }
  [[nodiscard]] const Loop& back() const noexcept { return all().back(); }
  friend bool operator==(const FaceLoops& a, const FaceLoops& b) { return a.loops_ == b.loops_ || a.all() == b.all(); }

  // To write: from then on these loops belong to this polyhedron alone.
  [[nodiscard]] auto begin() { return own().begin(); }
  [[nodiscard]] auto end() { return own().end(); }
  Loop& operator[](std::size_t i) { return own()[i]; }
  void push_back(Loop loop) { own().push_back(std::move(loop)); }
  template <class... Arguments>
  Loop& emplace_back(Arguments&&... arguments) {
    return own().emplace_back(std::forward<Arguments>(arguments)...);
  }
  template <class... Arguments>
  void insert(Loops::const_iterator at, Arguments&&... arguments) {
    own().insert(at, std::forward<Arguments>(arguments)...);
  }
  void pop_back() { own().pop_back(); }
  void resize(std::size_t count) { own().resize(count); }

 private:
  [[nodiscard]] const Loops& all() const noexcept {
    static const Loops kNone;
    return loops_ ? *loops_ : kNone;
  }
  Loops& own() {
    if (!loops_ || loops_.use_count() > 1) loops_ = std::make_shared<Loops>(all());
    return *loops_;
  }

  std::shared_ptr<Loops> loops_;
};

}  // namespace voussoir::geometry
