// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/browser.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>
#include <vector>

#include "io/input/files/errors.h"

extern char** environ;

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPatience = 300000;  // ms to wait for one answer: a large page on a busy machine takes half a minute
constexpr int kAgony = 50;         // tenths of a second to wait for the end of the process

std::string system_words(int error) { return std::generic_category().message(error); }

std::vector<std::string> programs() {
  const char* chosen = std::getenv("CHROMIUM");
  if (chosen != nullptr && *chosen != '\0') return {chosen};
  return {"chromium", "chromium-browser", "google-chrome"};
}

std::vector<std::string> arguments(const std::string& program, const std::string& scratch) {
  std::vector<std::string> all{program,
                               "--headless",
                               "--remote-debugging-pipe",
                               "--user-data-dir=" + scratch + "/profile",
                               "--no-first-run",
                               "--disable-background-networking",
                               "--use-gl=angle",
                               "--use-angle=swiftshader",
                               "--enable-unsafe-swiftshader"};
  if (::geteuid() == 0) all.emplace_back("--no-sandbox");  // Chromium refuses to run as root without it
  all.emplace_back("about:blank");
  return all;
}

/// Actions of posix_spawn between fork and exec: the socket becomes descriptors 3 and 4, as the DevTools protocol requires.
class FileActions {
 public:
  FileActions(int socket, const std::string& log) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_adddup2(&actions_, 1, 2);
    for (const int number : {3, 4}) ::posix_spawn_file_actions_adddup2(&actions_, socket, number);
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const noexcept { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Starts the process. \return 0 or an error number
int spawn(pid_t& pid, const std::vector<std::string>& words, int socket, const std::string& log) {
  std::vector<char*> argv;
  for (const std::string& w : words) argv.push_back(const_cast<char*>(w.c_str()));
  argv.push_back(nullptr);
  const FileActions actions(socket, log);
  return ::posix_spawnp(&pid, argv[0], actions.get(), nullptr, argv.data(), environ);
}

/// URL of a file: "file:///a%20b.html".
std::string address_of(const std::string& path) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string url = "file://";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || std::string("/-_.~").find(c) != std::string::npos;
    plain ? url += c : (url += '%', url += kDigits[byte >> 4U], url += kDigits[byte & 15U]);
  }
  return url;
}

}  // namespace

/// The process and its connection: JSON messages, each terminated by a zero byte.
struct Browser::Process {
  pid_t pid = -1;
  int socket = -1;
  std::string program, log, received, session;
  int calls = 0;
  bool loaded = false;

  Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (socket >= 0) ::close(socket);  // also ends the process
    if (pid < 0) return;
    for (int i = 0; i < kAgony && ::waitpid(pid, nullptr, WNOHANG) == 0; ++i) {
      if (i + 1 == kAgony) ::kill(pid, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    std::ifstream file(log);
    std::string line, last;
    while (std::getline(file, line)) last = line;
    throw FileError(program, what + (last.empty() ? "" : "; its last words: " + last));
  }

  void send(const Json& message) {
    std::string text = message.dump();
    text += '\0';
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t n = ::send(socket, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) fail("has ended");
      sent += static_cast<std::size_t>(n);
    }
  }

  Json receive() {
    for (std::size_t looked = 0;;) {
      const std::size_t end = received.find('\0', looked);
      if (end != std::string::npos) {
        Json message = Json::parse(received.substr(0, end));
        received.erase(0, end + 1);
        return message;
      }
      looked = received.size();
      pollfd ready{socket, POLLIN, 0};
      const int answer = ::poll(&ready, 1, kPatience);
      if (answer < 0 && errno == EINTR) continue;
      if (answer <= 0) fail("does not answer");
      std::array<char, 65536> buffer;
      const ssize_t n = ::recv(socket, buffer.data(), buffer.size(), 0);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) fail("has ended");
      received.append(buffer.data(), static_cast<std::size_t>(n));
    }
  }

  /// The next message; records the event that the page is loaded.
  Json next() {
    Json message = receive();
    loaded = loaded || message.value("method", "") == "Page.loadEventFired";
    return message;
  }

  Json call(const char* method, const Json& parameters) {
    Json message{{"id", ++calls}, {"method", method}, {"params", parameters}};
    if (!session.empty()) message["sessionId"] = session;
    send(message);
    for (;;) {
      const Json answer = next();
      if (answer.value("id", 0) != calls) continue;
      if (answer.contains("error")) fail(std::string(method) + ": " + answer["error"].value("message", ""));
      return answer.at("result");
    }
  }
};

Browser::Browser(const std::string& scratch) : process_(std::make_unique<Process>()) {
  Process& p = *process_;
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw FileError("socket", system_words(errno));
  p.socket = ends[0];
  p.log = scratch + "/log";
  int fault = ENOENT;
  for (const std::string& program : programs()) {
    p.program = program;
    fault = spawn(p.pid, arguments(program, scratch), ends[1], p.log);
    if (fault == 0) break;
    p.pid = -1;
  }
  ::close(ends[1]);
  if (fault != 0) {
    throw NoBrowser(programs().front(),
                    "cannot start (" + system_words(fault) +
                        "): films and pictures with their words are drawn by Chromium; install it (Debian: chromium), or "
                        "name its program in the environment variable CHROMIUM");
  }
  const Json target = p.call("Target.createTarget", {{"url", "about:blank"}});
  p.session = p.call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}}).at("sessionId").get<std::string>();
  p.call("Page.enable", Json::object());
}

Browser::~Browser() = default;

void Browser::open(const std::string& file, const std::string& fragment) {
  process_->loaded = false;
  const Json answer = process_->call("Page.navigate", {{"url", address_of(file) + "#" + fragment}});
  if (answer.contains("errorText")) process_->fail("cannot open " + file + ": " + answer["errorText"].get<std::string>());
  while (!process_->loaded) process_->next();
}

std::string Browser::evaluate(const std::string& expression) {
  const Json answer = process_->call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails"))
    process_->fail("the page fails: " +
                   answer["exceptionDetails"].value(Json::json_pointer("/exception/description"), std::string("no reason given")));
  const Json value = answer.at("result").value("value", Json());
  if (!value.is_string()) process_->fail("the page gives no text for " + expression);
  return value.get<std::string>();
}

}  // namespace voussoir::io
