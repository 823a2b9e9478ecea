// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/input_error.h"
#include "io/input/case_file/case_document.h"
#include "io/input/case_file/case_file.h"
#include "io/input/case_file/case_paths.h"
#include "io/input/files/errors.h"

// The case file: any text is a case or a fault with a message (an `include` is looked for beside the process). A case that is taken writes
// itself as a text that reads as the same case. What follows a character of number zero is an override (--set), up to the next.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace voussoir;
  const std::string all(reinterpret_cast<const char*>(data), size);
  const std::string text = all.substr(0, all.find('\0'));
  std::vector<std::string> overrides;
  for (std::size_t at = all.find('\0'); at != std::string::npos && overrides.size() < 8; at = all.find('\0', at + 1))
    overrides.push_back(all.substr(at + 1, all.find('\0', at + 1) - at - 1));
  try {
    const io::LoadedCase c = io::read_case({"fuzz.toml", text}, overrides);
    std::vector<cases::InputError> faults{{"", "of no key"}, {"nowhere[2].x", "of a key that is not there"}};
    for (const auto& [key, known] : c.keys) faults.emplace_back(key, "of a key"), faults.emplace_back(key + "[0].x", "within it");
    if (c.describe(cases::InputErrors(faults)).empty()) std::abort();
    io::Document document = io::read_document({"fuzz.toml", text});
    io::for_each_path(document.root, [](std::string& path) { path += "/x"; });
    cases::Case elsewhere = c.value;
    io::for_each_path(elsewhere, [](std::string& path) { path += "/x"; });
    const std::string resolved = io::resolved_toml(c.value);
    if (io::resolved_toml(io::read_case({"resolved.toml", resolved}).value) != resolved) std::abort();
  } catch (const cases::InputError&) {
  } catch (const io::FileError&) {  // it includes a file that is not there
  }
  return 0;
}
