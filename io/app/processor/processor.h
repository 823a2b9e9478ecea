// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Can this processor run this program? A program built for newer instructions than the processor has dies by SIGILL somewhere, without a
/// word. So the program asks the processor before it does anything else (refuse_old_processor.cpp).
///
/// processor.cpp and refuse_old_processor.cpp are compiled for the oldest x86-64, and use no template or inline function that another
/// source might have compiled for a newer one: of such copies the linker keeps one, whichever comes first.
namespace voussoir::io {

/// What the instructions CPUID and XGETBV say of a processor.
struct ProcessorWords {
  std::uint32_t leaf1_ecx = 0;     // CPUID 1
  std::uint32_t leaf7_ebx = 0;     // CPUID 7, subleaf 0
  std::uint32_t extended_ecx = 0;  // CPUID 80000001h
  std::uint32_t xcr0 = 0;          // registers that the system saves; 0 where XGETBV is absent
};

/// Bit i is feature i of the table in processor.cpp.
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

/// Of the processor that this runs on.
ProcessorWords read_processor() noexcept;

/// Those that a processor has and its system supports (AVX needs both).
Features features_of(const ProcessorWords& words) noexcept;

/// Those that the compiler was allowed to use in this build; of those that the table knows. Nothing on other processors than x86-64.
extern const Features kNeededFeatures;

/// Why a program with these needs cannot run: one line, cut at `size` - 1 characters and ended by 0. \return its length, 0 if nothing
/// lacks. \param built_for  the name of the instruction set, as given to -march
std::size_t processor_fault(Features needed, Features present, const char* built_for, char* text, std::size_t size) noexcept;

}  // namespace voussoir::io
