// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

/// What tests of commands share. The program and the sources may lie in folders with spaces.
namespace shell {

/// One word of a command, whatever it holds.
inline std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  return result + "'";
}

inline const std::string kProgram = quoted(VOUSSOIR_PROGRAM);
/// A file of the project.
inline std::string source(const std::string& path) { return quoted(VOUSSOIR_SOURCE_DIR "/" + path); }

// Whether the tests, and so the program, are built with a sanitizer that reserves terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool kSanitizer = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitizer = false;
#endif

struct Outcome {
  int code = -1;  // 1000 and its number if a signal ended it
  std::string text;
};
/// Runs a command; what it says on its standard output.
inline Outcome run(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  Outcome o;
  if (pipe == nullptr) return o;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) o.text.append(buffer.data(), n);
  const int status = pclose(pipe);
  o.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  return o;
}
/// The program; both of its streams. \param before  commands of the shell that come first
inline Outcome voussoir(const std::string& words, const std::string& before = "") { return run(before + kProgram + " " + words + " 2>&1"); }
inline int code_of(const std::string& command) { return run(command).code; }

inline std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace shell
