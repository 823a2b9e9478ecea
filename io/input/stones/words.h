// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/input/files/text_file.h"

namespace voussoir::io {

/// Words of a text, separated by blanks and line ends.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}
  /// The next word; empty after the last.
  std::string_view next() {
    const std::size_t first = rest_.find_first_not_of(kBlank);
    if (first == std::string_view::npos) {
      rest_ = {};
      return {};
    }
    rest_.remove_prefix(first);
    const std::size_t length = std::min(rest_.find_first_of(kBlank), rest_.size());
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  static constexpr std::string_view kBlank = " \t\r\n\v\f";
  std::string_view rest_;
};

/// Lines of a file that its format does not know.
class UnknownLines {
 public:
  void add(long line, std::string_view word) {
    if (count_++ == 0) first_ = line, word_ = word;
  }
  /// \param format  "OBJ" \param doubts  a line is appended if there were any
  void tell(const std::string& format, std::vector<std::string>& doubts) const {
    if (count_ == 0) return;
    doubts.push_back("left out: " + std::to_string(count_) + (count_ == 1 ? " line that is" : " lines that are") + " not of " + format +
                     ", the first with " + shown(word_) + " in line " + std::to_string(first_) + "; the file may be damaged");
  }

 private:
  long count_ = 0, first_ = 0;
  std::string word_;
};

inline std::string quoted_word(std::string_view name) { return '"' + std::string(name) + '"'; }

}  // namespace voussoir::io
