// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/messages/messages.h"

#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

bool as_json = false;

void print(const char* name, const std::string& text) { std::fprintf(stderr, "%s%s\n", name, text.c_str()); }

void print_json(const Json& object) { say_json(object.dump(-1, ' ', false, Json::error_handler_t::replace)); }

Json or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

void print_error(int code, const Message& m) {
  print_json({{"kind", "error"},
              {"code", code},
              {"text", m.text},
              {"file", or_null(m.file)},
              {"line", m.line > 0 ? Json(m.line) : Json(nullptr)},
              {"key", or_null(m.key)},
              {"value", or_null(m.value)},
              {"allowed", or_null(m.allowed)}});
}

}  // namespace

void say_as_json(bool json) noexcept {
  as_json = json;
  if (json) std::signal(SIGPIPE, SIG_IGN);  // a run goes on when whoever listened is gone
}
bool says_json() noexcept { return as_json; }

void say_error(int code, const Message& message) { as_json ? print_error(code, message) : print(kProgramName, message.text); }

void say_errors(int code, const std::vector<Message>& messages) {
  for (const Message& m : messages) {
    if (as_json) {
      print_error(code, m);
      continue;
    }
    std::istringstream lines(m.text);
    for (std::string line; std::getline(lines, line);) print(kProgramName, line);
  }
}

void say_warning(const std::string& text, const char* name) {
  as_json ? print_json({{"kind", "warning"}, {"text", text}}) : print(name, "warning: " + text);
}

void say_note(const std::string& text) { as_json ? print_json({{"kind", "note"}, {"text", text}}) : print(kProgramName, "note: " + text); }

void say_info(const std::string& text) { as_json ? print_json({{"kind", "info"}, {"text", text}}) : print(kProgramName, text); }

void say_lines(const std::string& lines) {
  if (lines.empty()) return;
  if (as_json)
    say_info(lines.substr(0, lines.find_last_not_of('\n') + 1));
  else
    std::fputs(lines.c_str(), stderr);
}

void say_error_without_memory(int code, const char* beginning, const char* details) noexcept {
  if (as_json)
    std::fprintf(stderr, R"({"kind":"error","code":%d,"text":"%s%s"})", code, beginning, details);
  else
    std::fprintf(stderr, "%s%s%s", kProgramName, beginning, details);
  std::fputs("\n", stderr);
}

void say_json(const std::string& line) {
  if (!as_json) return;
  const std::string whole = line + "\n";  // in one piece
  std::fwrite(whole.data(), 1, whole.size(), stderr);
}

}  // namespace voussoir::io
