// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/process.h"

#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "io/app/session/exit_code.h"
#include "io/input/messages/messages.h"

namespace voussoir::io {
namespace {

/// Raises the limit of open files: the rows of a long unfinished run are in many files, and a virtual dataset holds each of them open.
void open_many_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

constexpr rlim_t kLeastStack = 1U << 20U, kUsualStack = 8U << 20U;  // bytes

/// Raises a small limit of the stack, for this thread and those to come, as far as may be.
void take_stack() {
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= kLeastStack) return;
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? kUsualStack : std::min(limit.rlim_max, kUsualStack);
  if (limit.rlim_cur < kLeastStack || setrlimit(RLIMIT_STACK, &limit) != 0) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "the stack is limited to %llu kB (ulimit -s); 1024 kB at least are needed",
                  static_cast<unsigned long long>(before >> 10U));
    say_error_without_memory(kFileFault, text.data(), "");
    std::_Exit(kFileFault);
  }
  pthread_attr_t usual;
  if (pthread_attr_init(&usual) != 0) return;
  if (pthread_attr_setstacksize(&usual, limit.rlim_cur) == 0) pthread_setattr_default_np(&usual);
  pthread_attr_destroy(&usual);
}

std::atomic<const char*> doing{"starting"};

/// Pages of memory that the program has; 0: not known. Allocates no memory; std::fopen would.
unsigned long long pages_in_use() {
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  std::array<char, 100> text{};
  const ssize_t length = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  return length > 0 ? std::strtoull(text.data(), nullptr, 10) : 0;
}

/// Writes "; 388 MB are in use, ulimit -v allows 400 MB": what is known without memory.
void describe_memory(char* text, std::size_t size) {
  const unsigned long long pages = pages_in_use();
  const double used = 1e-6 * static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit limit{};
  int written = 0;
  if (pages > 0) written = std::snprintf(text, size, "; %.0f MB are in use", used);
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    std::snprintf(text + written, size - static_cast<std::size_t>(written), "%s ulimit -v allows %.0f MB", pages > 0 ? "," : ";",
                  1e-6 * static_cast<double>(limit.rlim_cur));
}

/// Number of threads that the system gives at a time, at most `wanted`. \param why  receives the error that refused the next one
int threads_given(int wanted, std::string& why) {
  std::vector<std::thread> given;
  given.reserve(static_cast<std::size_t>(wanted));
  std::atomic<bool> go{false};
  try {
    while (static_cast<int>(given.size()) < wanted) given.emplace_back([&] { go.wait(false); });
  } catch (const std::system_error& e) {
    why = e.code().message();
  } catch (const std::bad_alloc&) {
    why = "out of memory";
  }
  go = true;
  go.notify_all();
  for (std::thread& t : given) t.join();
  return static_cast<int>(given.size());
}

std::terminate_handler handler_before = nullptr;

[[noreturn]] void end_by_terminate() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc& e) {
    std::_Exit(end_unexpectedly(e));
  } catch (...) {  // a fault of the program: end as without this handler, with a core dump
  }
  handler_before();
  std::abort();
}

}  // namespace

void prepare_process() {
  take_stack();
  handler_before = std::set_terminate(end_by_terminate);
  std::signal(SIGXFSZ, SIG_IGN);
  open_many_files();
  rlimit memory{};
  // Each thread would set aside 64 MB of addresses to allocate from.
  if (getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY) mallopt(M_ARENA_MAX, 1);
}

void give_memory_back() noexcept {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

int code_after_output(int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return code;
  say_error(kFileFault, {.text = "standard output cannot be written"});
  return code == kDone ? kFileFault : code;
}

void now_doing(const char* what) { doing = what; }

int threads_to_be_had(int wanted) {
  std::string why;
  const int given = threads_given(wanted - 1, why);
  if (given == wanted - 1) return wanted;
  const int taken = 1 + given / 4;
  say_warning("of " + std::to_string(wanted) + " threads the system gives " + std::to_string(1 + given) + " (" + why +
              "; ulimit -v, -u); going on with " + std::to_string(taken));
  return taken;
}

int end_unexpectedly(const std::exception& e) {
  // A length_error is a size that is beyond any memory.
  const bool memory = dynamic_cast<const std::bad_alloc*>(&e) != nullptr || dynamic_cast<const std::length_error*>(&e) != nullptr;
  if (!memory) {
    say_error(kFileFault, {.text = e.what()});
    return kFileFault;
  }
  std::array<char, 200> beginning{}, used{};
  std::snprintf(beginning.data(), beginning.size(), "out of memory while %s", doing.load());
  describe_memory(used.data(), used.size());
  say_error_without_memory(kFileFault, beginning.data(), used.data());
  return kFileFault;
}

}  // namespace voussoir::io
