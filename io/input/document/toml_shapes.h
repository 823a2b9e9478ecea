// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/vec3.h"
#include "io/input/document/case_values.h"

/// What values of a C++ type look like in a case file: in words for messages, and as types for programs.
namespace voussoir::io {

inline ValueType array_of(ValueType type, int extent) {
  type.extents.insert(type.extents.begin(), extent);
  return type;
}

template <class T>
struct TomlShape;
template <>
struct TomlShape<double> {
  static std::string text() { return "a number"; }
  static ValueType type() { return {"number", {}}; }
};
template <>
struct TomlShape<int> {
  static std::string text() { return "an integer"; }
  static ValueType type() { return {"integer", {}}; }
};
template <>
struct TomlShape<bool> {
  static std::string text() { return "true or false"; }
  static ValueType type() { return {"boolean", {}}; }
};
template <>
struct TomlShape<std::string> {
  static std::string text() { return "a string in quotes"; }
  static ValueType type() { return {"string", {}}; }
};
template <>
struct TomlShape<Vec3> {
  static std::string text() { return "an array [x, y, z]"; }
  static ValueType type() { return {"number", {3}}; }
};
template <class T, std::size_t N>
struct TomlShape<std::array<T, N>> {
  static std::string text() { return "an array of " + std::to_string(N) + ", each " + TomlShape<T>::text(); }
  static ValueType type() { return array_of(TomlShape<T>::type(), static_cast<int>(N)); }
};
template <class T>
struct TomlShape<std::vector<T>> {
  static std::string text() { return "an array, each " + TomlShape<T>::text(); }
  static ValueType type() { return array_of(TomlShape<T>::type(), -1); }
};
template <class T>
struct TomlShape<std::optional<T>> : TomlShape<T> {};

}  // namespace voussoir::io
