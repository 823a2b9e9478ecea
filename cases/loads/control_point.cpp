// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/control_point.h"

#include <algorithm>
#include <cctype>

#include "cases/case.h"
#include "cases/model.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr std::size_t kMostNames = 20;  // in a message

const char* const kKey = "analysis.control";

std::string label(const Block& b) { return b.tag.empty() ? b.name : b.tag; }

/// Names of blocks and of parts of houses, each once, in the order of the elements; walls before what has a number.
std::vector<std::string> names_in(const Model& model) {
  std::vector<std::string> names, numbered;
  for (const Block& b : model.blocks) {
    const std::string name = label(b);
    if (name.empty() || b.fixed) continue;
    std::vector<std::string>& to =
        b.house >= 0 && std::isdigit(static_cast<unsigned char>(name.back())) != 0 && name.find(',') == std::string::npos ? numbered
                                                                                                                          : names;
    if (std::ranges::find(to, name) == to.end()) to.push_back(name);
  }
  names.insert(names.end(), numbered.begin(), numbered.end());
  return names;
}

std::string shown(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) out += (i == 0 ? "" : "; ") + names[i];
  return names.size() > kMostNames ? out + "; and " + std::to_string(names.size() - kMostNames) + " more" : out;
}

}  // namespace

std::vector<std::int32_t> elements_called(const Model& model, const std::string& name) {
  std::vector<std::int32_t> out;
  for (const std::vector<std::int32_t>& part : parts_named(model, name)) out.insert(out.end(), part.begin(), part.end());
  if (!out.empty()) return out;
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (model.blocks[i].tag == name) out.push_back(static_cast<std::int32_t>(i));
  return out;
}

void check_control(const Case& c, const Model& model) {
  const std::string& name = c.analysis.control_name;
  if (name.empty()) return;
  const std::vector<std::int32_t> called = elements_called(model, name);
  if (called.empty()) {
    const std::vector<std::string> names = names_in(model);
    throw InputError(kKey, "= " + quoted(name) + " is the name of no part; " + did_you_mean(name, names) + "known: " + shown(names));
  }
  const auto fixed = [&](std::int32_t e) { return nth(model.blocks, e).fixed; };
  if (std::ranges::all_of(called, fixed)) throw InputError(kKey, "= " + quoted(name) + " is fixed: it shows no displacement");
  const auto house = [&](std::int32_t e) { return nth(model.blocks, e).house; };
  if (std::ranges::any_of(called, [&](std::int32_t e) { return house(e) != house(called.front()); }))
    throw InputError(kKey, "= " + quoted(name) + " is in several houses; give a point [x, y, z] (m)");
}

}  // namespace voussoir::cases
