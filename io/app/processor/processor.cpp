// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/processor/processor.h"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace voussoir::io {
namespace {

enum class Word : unsigned char { kLeaf1Ecx, kLeaf7Ebx, kExtendedEcx };

struct Row {
  const char* name;
  Word word;
  unsigned char bit;
  std::uint32_t saved;  // bits of XCR0 that must be set by the system
};

constexpr std::uint32_t kYmm = 0x6, kZmm = 0xe6;  // XMM and YMM; these with mask registers and ZMM

// In the order of `Feature`. Sources: Intel's manual, volume 2, CPUID; AMD's, volume 3, appendix E.
constexpr Row kRows[kFeatures] = {
    {"SSE3", Word::kLeaf1Ecx, 0, 0},         {"SSSE3", Word::kLeaf1Ecx, 9, 0},        {"CMPXCHG16B", Word::kLeaf1Ecx, 13, 0},
    {"SSE4.1", Word::kLeaf1Ecx, 19, 0},      {"SSE4.2", Word::kLeaf1Ecx, 20, 0},      {"POPCNT", Word::kLeaf1Ecx, 23, 0},
    {"LAHF", Word::kExtendedEcx, 0, 0},      {"AVX", Word::kLeaf1Ecx, 28, kYmm},      {"AVX2", Word::kLeaf7Ebx, 5, kYmm},
    {"BMI1", Word::kLeaf7Ebx, 3, 0},         {"BMI2", Word::kLeaf7Ebx, 8, 0},         {"F16C", Word::kLeaf1Ecx, 29, kYmm},
    {"FMA", Word::kLeaf1Ecx, 12, kYmm},      {"LZCNT", Word::kExtendedEcx, 5, 0},     {"MOVBE", Word::kLeaf1Ecx, 22, 0},
    {"AVX512F", Word::kLeaf7Ebx, 16, kZmm},  {"AVX512BW", Word::kLeaf7Ebx, 30, kZmm}, {"AVX512CD", Word::kLeaf7Ebx, 28, kZmm},
    {"AVX512DQ", Word::kLeaf7Ebx, 17, kZmm}, {"AVX512VL", Word::kLeaf7Ebx, 31, kZmm}};

std::uint32_t word_of(const ProcessorWords& words, Word word) noexcept {
  if (word == Word::kLeaf1Ecx) return words.leaf1_ecx;
  return word == Word::kLeaf7Ebx ? words.leaf7_ebx : words.extended_ecx;
}

/// Text in a buffer of fixed size.
struct Line {
  char* text;
  std::size_t size, length = 0;
  void put(const char* words) noexcept {
    for (; *words != 0 && length + 1 < size; ++words) text[length++] = *words;
    if (size > 0) text[length] = 0;
  }
};

}  // namespace

ProcessorWords read_processor() noexcept {
  ProcessorWords words;
#if defined(__x86_64__)
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (__get_cpuid(1, &a, &b, &c, &d) != 0) words.leaf1_ecx = c;
  if (__get_cpuid_count(7, 0, &a, &b, &c, &d) != 0) words.leaf7_ebx = b;
  if (__get_cpuid(0x80000001U, &a, &b, &c, &d) != 0) words.extended_ecx = c;
  constexpr std::uint32_t kXgetbv = 1U << 27;  // OSXSAVE: XGETBV is enabled by the system
  if ((words.leaf1_ecx & kXgetbv) != 0) {
    asm("xgetbv" : "=a"(a), "=d"(d) : "c"(0));
    words.xcr0 = a;
  }
#endif
  return words;
}

Features features_of(const ProcessorWords& words) noexcept {
  Features present = 0;
  for (unsigned i = 0; i < kFeatures; ++i) {
    const Row& row = kRows[i];
    if ((word_of(words, row.word) >> row.bit & 1U) != 0 && (words.xcr0 & row.saved) == row.saved) present |= 1U << i;
  }
  return present;
}

std::size_t processor_fault(Features needed, Features present, const char* built_for, char* text, std::size_t size) noexcept {
  const Features lacking = needed & ~present;
  if (lacking == 0) return 0;
  Line line{text, size};
  line.put("voussoir: this processor, or the system on it, lacks ");
  for (unsigned i = 0, count = 0; i < kFeatures; ++i) {
    if ((lacking >> i & 1U) == 0) continue;
    line.put(count++ == 0 ? "" : ", ");
    line.put(kRows[i].name);
  }
  line.put("; the program was built for ");
  line.put(built_for);
  line.put(". Use a newer machine, or build the program from its sources on this one (scripts/build)\n");
  return line.length;
}

}  // namespace voussoir::io
