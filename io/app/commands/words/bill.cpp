// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/bill.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "cases/names.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "io/app/session/progress.h"

namespace voussoir::io {

namespace {

constexpr std::size_t kMost = 20;  // lines, unless all are asked for

std::string dimensions(const cases::BillLine& line) {
  if (line.faces > 0) return "polyhedron of " + std::to_string(line.faces) + " faces";
  if (line.edges[0] == 0.0) return line.corners == 4 ? "hexahedron" : "prism of " + std::to_string(line.corners) + " corners";
  std::string text;
  for (const double edge : line.edges) text += (text.empty() ? "" : " x ") + cases::text(edge);
  return text + " m";
}

std::string line_of(const std::string& what, std::int64_t count, double volume) {
  return geometry::printed("%-52s %10s %12.4f\n", what.c_str(), format_count(count).c_str(), volume);
}

}  // namespace

std::string bill_words(const cases::Census& n, const cases::Model& m, bool all) {
  std::vector<cases::BillLine> lines = n.bill;
  const std::size_t shown = all || lines.size() <= kMost ? lines.size() : kMost;
  if (shown < lines.size()) std::ranges::stable_sort(lines, std::greater{}, &cases::BillLine::volume);
  std::string text = geometry::printed("\n%-52s %10s %12s\n", "bill of blocks", "count", "volume [m3]");
  cases::BillLine rest;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const cases::BillLine& line = lines[i];
    if (i >= shown) {
      rest.count += line.count, rest.volume += line.volume;
      continue;
    }
    const std::string material = nth(m.materials, line.material).name, kind = cases::name(line.kind);
    const std::string what = material == kind ? kind : material + " " + kind;
    text += line_of(what + (line.whole ? ", " : ", cut, ") + dimensions(line), line.count, line.volume);
  }
  if (rest.count > 0)
    text += line_of(format_count(static_cast<std::int64_t>(lines.size() - shown)) + " other kinds (--bill: all)", rest.count, rest.volume);
  return text;
}

}  // namespace voussoir::io
