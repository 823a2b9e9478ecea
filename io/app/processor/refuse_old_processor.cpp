// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include "io/app/processor/processor.h"

// Part of the executable, not of a library. .preinit_array runs before the constructors of the program and of its libraries, the first code
// that may use newer instructions.
namespace voussoir::io {
namespace {

constexpr int kProcessorTooOld = 4;  // exit code, see io/README.md

void refuse_old_processor() {
  char text[600];
  const std::size_t length = processor_fault(kNeededFeatures, features_of(read_processor()), VOUSSOIR_ARCH, text, sizeof text);
  if (length == 0) return;
  if (write(STDERR_FILENO, text, length) < 0) _exit(kProcessorTooOld);  // the message cannot be printed
  _exit(kProcessorTooOld);
}

[[gnu::used, gnu::section(".preinit_array")]] void (*const kFirst)() = refuse_old_processor;

}  // namespace
}  // namespace voussoir::io
