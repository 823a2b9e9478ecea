// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/child_input.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "io/input/files/errors.h"

extern char** environ;

namespace voussoir::io {

ChildInput::ChildInput(std::vector<std::string> words, std::string log, const std::string& hint)
    : words_(std::move(words)), log_(std::move(log)) {
  std::array<int, 2> ends{};  // a socket, since SIGPIPE can be suppressed for writes to a closed socket
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw FileError(words_.front(), std::generic_category().message(errno));
  std::vector<char*> argv;
  for (std::string& w : words_) argv.push_back(w.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 1, log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::posix_spawn_file_actions_adddup2(&actions, 1, 2);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
  const int fault = ::posix_spawnp(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  input_ = ends[0];
  if (fault == 0) return;
  ::close(input_);
  throw FileError(words_.front(), "cannot start (" + std::generic_category().message(fault) + "): " + hint);
}

ChildInput::~ChildInput() {
  if (input_ >= 0) ::close(input_);
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void ChildInput::fail(const std::string& what) {
  std::ifstream file(log_);
  std::string line, last;
  while (std::getline(file, line))
    if (!line.empty()) last = line;
  throw FileError(words_.front(), what + (last.empty() ? "" : "; its last words: " + last));
}

void ChildInput::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail("takes no more");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
}

void ChildInput::finish() {
  ::close(std::exchange(input_, -1));
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail("has failed");
}

}  // namespace voussoir::io
