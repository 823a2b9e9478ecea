// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// All that the program says on standard error: text for people, or, for other programs, one JSON object a line (io/README.md, Messages).
namespace voussoir::io {

/// What is said, and what it is about. Empty, and line 0: not known, or about nothing of that kind.
struct Message {
  std::string text{};            // complete, without the name of the program
  std::string file{};            // as named in the text
  long line = 0;                 // from 1
  std::string key{};             // path in the case file: "house.opening[1].width"
  std::string value{}, allowed{};  // in words, with units
};

/// Chooses the form of all that follows; text at first.
void say_as_json(bool json) noexcept;
[[nodiscard]] bool says_json() noexcept;

inline constexpr const char* kProgramName = "voussoir: ";

/// A failure that ends the command. \param code  its exit code
void say_error(int code, const Message& message);
/// Several, in the order given. As text each line of each has the name of the program before it.
void say_errors(int code, const std::vector<Message>& messages);
/// A likely mistake. \param name  what stands before it as text
void say_warning(const std::string& text, const char* name = kProgramName);
/// Something to know about results or files.
void say_note(const std::string& text);
/// What is being done.
void say_info(const std::string& text);
/// The same, as lines that have no name before them. \param lines  each with its end
void say_lines(const std::string& lines);
/// Where memory has ended: the error "BEGINNING; DETAILS", which takes none. \param details  of what is in use; may be empty
void say_error_without_memory(int code, const char* beginning, const char* details) noexcept;

/// A line that is a JSON object already; nothing where messages are text.
void say_json(const std::string& line);

}  // namespace voussoir::io
