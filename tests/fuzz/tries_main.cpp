// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/common_interface_defs.h>
#endif

// A fuzz target without libFuzzer, for every compiler: reads all inputs of the folders, then random changes of them. It does not look at
// which lines an input reaches, so it finds less than scripts/fuzz; it needs no other build than that of the sanitizers. usage:
// READER_tries SECONDS SEED LONGEST FINDING FOLDER...    An input that ends it is written to the file FINDING.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr time_t kLongest = 10;  // s of processor time for one input
const Bytes* current = nullptr;
const char* finding = nullptr;

void keep_finding() {
  if (current == nullptr) return;
  const int file = ::open(finding, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0 || ::write(file, current->data(), current->size()) < 0) return;
  ::close(file);
}

void on_signal(int number) {
  keep_finding();
  std::signal(number, SIG_DFL);
  ::raise(number);
}

class Tries {
 public:
  Tries(std::uint64_t seed, std::size_t longest) : random_(seed), longest_(longest) {}

  void add(const std::filesystem::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.file_size() <= longest_) files.push_back(entry.path().string());
    std::ranges::sort(files);  // the order of a folder is no one's
    for (const std::string& file : files) {
      std::ifstream in(file, std::ios::binary);
      inputs_.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
  }
  [[nodiscard]] const std::vector<Bytes>& inputs() const { return inputs_; }

  Bytes changed() {
    Bytes b = any();
    for (std::size_t n = 1 + below(4); n > 0; --n) change(b);
    if (b.size() > longest_) b.resize(longest_);
    return b;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  const Bytes& any() { return inputs_[below(inputs_.size())]; }

  static bool in_number(std::uint8_t c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }

  /// Exchanges a number of a text.
  void put_number(Bytes& b) {
    static constexpr std::array kNumbers{"0",   "-1", "1e308", "1e-320", "nan", "inf", "2147483648", "99999999999999999999",
                                         "1.5", "",   "7e",    "-"};
    const std::size_t from =
        static_cast<std::size_t>(std::find_if(b.begin() + static_cast<std::ptrdiff_t>(below(b.size())), b.end(), in_number) - b.begin());
    std::size_t end = from;
    while (end < b.size() && in_number(b[end])) ++end;
    const std::string text = kNumbers[below(kNumbers.size())];
    b.erase(b.begin() + static_cast<std::ptrdiff_t>(from), b.begin() + static_cast<std::ptrdiff_t>(end));
    b.insert(b.begin() + static_cast<std::ptrdiff_t>(from), text.begin(), text.end());
  }

  /// Puts a piece of another input into this one.
  void put_piece(Bytes& b, const Bytes& other) {
    if (other.empty()) return;
    const std::size_t from = below(other.size()), size = 1 + below(std::min<std::size_t>(other.size() - from, 64));
    const std::size_t at = below(b.size() + 1), gone = below(2) == 0 ? 0 : std::min(size, b.size() - at);
    b.erase(b.begin() + static_cast<std::ptrdiff_t>(at), b.begin() + static_cast<std::ptrdiff_t>(at + gone));
    b.insert(b.begin() + static_cast<std::ptrdiff_t>(at), other.begin() + static_cast<std::ptrdiff_t>(from),
             other.begin() + static_cast<std::ptrdiff_t>(from + size));
  }

  void change(Bytes& b) {
    static constexpr std::array<std::uint8_t, 12> kOdd{0, 1, 0x7f, 0x80, 0xff, ' ', '\n', '\r', '"', '0', '9', '-'};
    if (b.empty()) return b.push_back(static_cast<std::uint8_t>(random_()));
    const std::size_t at = below(b.size());
    const auto place = b.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(9)) {
      case 0:
        b[at] ^= static_cast<std::uint8_t>(1U << below(8));
        return;
      case 1:
        b[at] = static_cast<std::uint8_t>(random_());
        return;
      case 2:
        b[at] = kOdd[below(kOdd.size())];
        return;
      case 3:
        b.insert(place, kOdd[below(kOdd.size())]);
        return;
      case 4:
        b.erase(place, place + static_cast<std::ptrdiff_t>(1 + below(std::min<std::size_t>(b.size() - at, 32))));
        return;
      case 5:
        b.resize(at);
        return;
      case 6:
        return put_number(b);
      case 7:
        return put_piece(b, Bytes(b));
      default:
        return put_piece(b, any());
    }
  }

  std::mt19937_64 random_;
  std::size_t longest_;
  std::vector<Bytes> inputs_;
};

void set_timer(time_t seconds) {
  const itimerval most{{0, 0}, {seconds, 0}};
  ::setitimer(ITIMER_PROF, &most, nullptr);
}

void run(const Bytes& input) {
  current = &input;
  set_timer(kLongest);
  LLVMFuzzerTestOneInput(input.data(), input.size());
  set_timer(0);
  current = nullptr;
}

}  // namespace

int main(int count, char** words) {
  constexpr int kFolders = 5;
  if (count <= kFolders) return 2;
  finding = words[4];
  for (const int number : {SIGABRT, SIGPROF, SIGSEGV, SIGFPE}) std::signal(number, on_signal);
#if defined(__SANITIZE_ADDRESS__)
  __sanitizer_set_death_callback(keep_finding);
#endif
  Tries tries(std::stoull(words[2]), std::stoul(words[3]));
  for (int i = kFolders; i < count; ++i) tries.add(words[i]);
  if (tries.inputs().empty()) return 2;
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  std::size_t done = 0;
  for (const Bytes& input : tries.inputs()) run(input), ++done;
  for (const double most = std::stod(words[1]); seconds() < most; ++done) run(tries.changed());
  std::printf("%zu executions in %.0f s\n", done, seconds());
  return 0;
}
