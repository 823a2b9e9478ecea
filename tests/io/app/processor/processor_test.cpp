// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/processor/processor.h"

#include <doctest/doctest.h>

#include <array>
#include <regex>
#include <string>

#include "tests/io/shell.h"

// A program built for newer instructions than the processor has says so, instead of dying somewhere by SIGILL.
namespace {

using namespace voussoir::io;

constexpr Features kV3 = (1U << (kMovbe + 1)) - 1;

// What CPUID says of some processors, as far as it is asked.
constexpr std::uint32_t kV2Leaf1 = 1U << 0 | 1U << 9 | 1U << 13 | 1U << 19 | 1U << 20 | 1U << 23;
constexpr ProcessorWords kNehalem{.leaf1_ecx = kV2Leaf1, .leaf7_ebx = 0, .extended_ecx = 1, .xcr0 = 0};
constexpr ProcessorWords kIvyBridge{
    .leaf1_ecx = kV2Leaf1 | 1U << 26 | 1U << 27 | 1U << 28 | 1U << 29, .leaf7_ebx = 0, .extended_ecx = 1, .xcr0 = 7};
constexpr ProcessorWords kHaswell{.leaf1_ecx = kIvyBridge.leaf1_ecx | 1U << 12 | 1U << 22,
                                  .leaf7_ebx = 1U << 3 | 1U << 5 | 1U << 8,
                                  .extended_ecx = 1U << 0 | 1U << 5,
                                  .xcr0 = 7};

std::string fault(Features needed, const ProcessorWords& words) {
  std::array<char, 600> text{};
  const std::size_t length = processor_fault(needed, features_of(words), "x86-64-v3", text.data(), text.size());
  CHECK(std::string(text.data()).size() == length);
  return text.data();
}

}  // namespace

TEST_CASE("processor: an old one is refused by what it lacks") {
  CHECK(fault(kV3, kNehalem).find("lacks AVX, AVX2, BMI1, BMI2, F16C, FMA, LZCNT, MOVBE; the program was built for x86-64-v3") !=
        std::string::npos);
  CHECK(fault(kV3, kIvyBridge).find("lacks AVX2, BMI1, BMI2, FMA, LZCNT, MOVBE;") != std::string::npos);
  CHECK(fault(kV3, kHaswell).empty());
  CHECK(fault(kV3 | 1U << kAvx512f, kHaswell).find("lacks AVX512F;") != std::string::npos);
  CHECK(fault(0, ProcessorWords{}).empty());
}

TEST_CASE("processor: AVX counts only where the system saves its registers") {
  ProcessorWords words = kHaswell;
  words.xcr0 = 3;
  CHECK(fault(kV3, words).find("lacks AVX, AVX2, F16C, FMA;") != std::string::npos);
  words.leaf7_ebx |= 1U << 16;
  words.xcr0 = 7;  // but not the upper halves of ZMM
  CHECK(fault(kV3 | 1U << kAvx512f, words).find("lacks AVX512F;") != std::string::npos);
}

TEST_CASE("processor: the message is cut to its buffer") {
  std::array<char, 16> text{};
  CHECK(processor_fault(kV3, 0, "x86-64-v3", text.data(), text.size()) == 15);
  CHECK(std::string(text.data()) == "voussoir: this ");
}

TEST_CASE("processor: this program needs what it was compiled for, and this processor has it") {
#ifdef __AVX2__
  CHECK((kNeededFeatures >> kAvx2 & 1U) == 1);
#endif
  CHECK((kNeededFeatures & ~features_of(read_processor())) == 0);
}

TEST_CASE("processor: what asks the processor runs on the oldest one") {
#ifdef __x86_64__
  const std::regex newer(
      R"(^\s+[0-9a-f]+:\s+(v[a-z0-9]+|andn|bextr|bls[a-z]+|bzhi|mulx|pdep|pext|rorx|sarx|shlx|shrx|lzcnt|popcnt|movbe)\s)");
  const shell::Outcome o = shell::run("objdump -d --no-show-raw-insn " + shell::quoted(VOUSSOIR_PROCESSOR_OBJECT) + " " +
                                      shell::quoted(VOUSSOIR_REFUSAL_OBJECT));
  REQUIRE(o.code == 0);
  CHECK(o.text.find("xgetbv") != std::string::npos);
  std::istringstream lines(o.text);
  for (std::string line; std::getline(lines, line);) CHECK_MESSAGE(!std::regex_search(line, newer), line);
  // No code of a template or an inline function, which another source may have compiled for a newer processor.
  const shell::Outcome symbols =
      shell::run("nm -C " + shell::quoted(VOUSSOIR_PROCESSOR_OBJECT) + " " + shell::quoted(VOUSSOIR_REFUSAL_OBJECT));
  CHECK(symbols.text.find(" W ") == std::string::npos);
#endif
}

TEST_CASE("processor: the program refuses an emulated Nehalem") {
  if (shell::code_of("command -v qemu-x86_64 >/dev/null") != 0) {
    MESSAGE("skipped: no qemu-x86_64 (Debian: qemu-user)");
    return;
  }
  if ((kNeededFeatures >> kAvx & 1U) == 0) return;
  const shell::Outcome o = shell::run("qemu-x86_64 -cpu Nehalem " + shell::kProgram + " --version 2>&1");
  CHECK(o.code == 4);
  CHECK(o.text.find("lacks AVX, AVX2") != std::string::npos);
}
