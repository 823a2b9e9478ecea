// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voussoir::io {

/// The arrays of an unstructured grid of VTK (XML): ASCII, base64 within the elements, or appended as base64 or raw; plain or deflated.
class VtuArrays {
 public:
  /// \throw FileError if the text is no VTU file, has several pieces, or an unsupported byte order or compression
  VtuArrays(const std::string& path, std::string_view text);

  /// Values of an array of any type. \throw FileError if the array is damaged, or (except for cell_data) missing
  [[nodiscard]] std::vector<double> points() const;
  [[nodiscard]] std::vector<double> cell_part(const std::string& name) const;
  [[nodiscard]] std::vector<double> cell_data(const std::string& name) const;  // empty: no such array

 private:
  struct Array {
    std::string type, format;
    std::size_t offset = 0;  // in the appended data
    std::string_view text;   // within the element
  };
  [[nodiscard]] std::vector<double> values(const Array& a, const std::string& name) const;
  [[nodiscard]] std::string bytes(const Array& a, const std::string& name) const;
  [[nodiscard]] std::string blocks(std::string_view coded, bool raw, const std::string& name) const;
  void take_array(const std::string& section, std::string_view tag, std::string_view content);

  std::string path_;
  std::map<std::string, Array> arrays_;  // "Points/..", "Cells/connectivity", "CellData/element"
  std::string_view appended_;
  bool appended_raw_ = false, deflated_ = false, long_heads_ = false;
};

}  // namespace voussoir::io
