// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Check whether the processor supports the instructions of this build. A program with unsupported instructions would end by SIGILL without
/// a message, so the check precedes all other code (refuse_old_processor.cpp).
///
/// processor.cpp and refuse_old_processor.cpp are compiled for the oldest x86-64, and use no template or inline function that another
/// source may contain, compiled for newer processors: the linker keeps an arbitrary one of such copies.
namespace voussoir::io {

/// Results of the instructions CPUID and XGETBV.
struct ProcessorWords {
  std::uint32_t leaf1_ecx = 0;     // CPUID 1
  std::uint32_t leaf7_ebx = 0;     // CPUID 7, subleaf 0
  std::uint32_t extended_ecx = 0;  // CPUID 80000001h
  std::uint32_t xcr0 = 0;          // register sets saved by the system; 0 if XGETBV is absent
};

/// A set of features; bit i is feature i of the table in processor.cpp.
using Features = std::uint32_t;
enum Feature : unsigned {
  kSse3,
  kSsse3,
  kCx16,
  kSse41,
  kSse42,
  kPopcnt,
  kLahf,  // x86-64-v2
  kAvx,
  kAvx2,
  kBmi1,
  kBmi2,
  kF16c,
  kFma,
  kLzcnt,
  kMovbe,  // x86-64-v3
  kAvx512f,
  kAvx512bw,
  kAvx512cd,
  kAvx512dq,
  kAvx512vl,  // x86-64-v4
  kFeatures
};

/// Reads the words of the current processor.
ProcessorWords read_processor() noexcept;

/// Features that a processor has and its system supports (AVX needs both).
Features features_of(const ProcessorWords& words) noexcept;

/// Features of the table that the compiler could use in this build. Empty on processors other than x86-64.
extern const Features kNeededFeatures;

/// The reason why a program with these needs cannot run: one line, truncated to `size` - 1 characters and terminated by 0. \return its
/// length, 0 if no feature is missing. \param built_for  the name of the instruction set, as given to -march
std::size_t processor_fault(Features needed, Features present, const char* built_for, char* text, std::size_t size) noexcept;

}  // namespace voussoir::io
