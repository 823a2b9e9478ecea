// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"

// The case file: any text is a case or a fault with a message (an `include` is looked for beside the process). A case that is taken writes
// itself as a text that reads as the same case.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace voussoir;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const io::LoadedCase c = io::read_case({"fuzz.toml", text});
    const std::string resolved = io::resolved_toml(c.value);
    if (io::resolved_toml(io::read_case({"resolved.toml", resolved}).value) != resolved) std::abort();
  } catch (const cases::InputError&) {
  } catch (const io::FileError&) {  // it includes a file that is not there
  }
  return 0;
}
