// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Results of a run with faults that no seal tells, since they are put in before the file is sealed.
namespace voussoir::fuzz {

/// Bytes of an edit: kind, object (two), place (three), value (eight).
inline constexpr std::size_t kEdit = 14;

/// A run.h5, its seal removed, and the names of all that can be edited in it.
class RunImage {
 public:
  /// \param path  of a run.h5, sealed or not
  explicit RunImage(const std::string& path);

  /// Writes the file after some edits, made through HDF5's own functions: values, types, shapes, links and attributes become others,
  /// HDF5's structure stays whole. What cannot be edited so is left as it was. A sealed one has to be sealed again.
  /// \param part_seals  if not empty, how the file names its parts (Hdf5File::name_parts)
  void write_edited(const std::string& path, std::span<const std::uint8_t> edits, const std::string& part_seals = {}) const;
  [[nodiscard]] bool sealed() const noexcept { return sealed_; }

 private:
  struct Attribute {
    std::string object, name;
  };
  std::vector<std::byte> bytes_;
  std::vector<std::string> datasets_;
  std::vector<Attribute> attributes_;
  bool sealed_ = false;
};

}  // namespace voussoir::fuzz
