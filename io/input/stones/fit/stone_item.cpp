// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/fit/stone_item.h"

#include "geometry/message.h"

namespace voussoir::io {

std::string change_of(const StoneItem& item, const geometry::Flattened& done, std::size_t pieces, const std::string& law) {
  constexpr double kWarped = 1e-7;  // m: faces warped by less are not worth a word
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  if (item.raw.turned > 0) add(counted(item.raw.turned, "face") + " drawn inside out turned round");
  if (item.raw.merged > 0) add(counted(item.raw.merged, "face") + " merged into others in the same plane");
  if (item.nearly_flat > 0) add(counted(item.nearly_flat, "face") + " merged into others nearly in the same plane");
  if (item.in_triangles > 0) add(counted(item.in_triangles, "warped face") + " parted into triangles");
  if (!done.beds.empty()) add("grown to the middle of mortar on " + counted(done.beds.size(), "face"));
  if (done.warped > kWarped && done.moved > 0.0) add("faces warped by " + geometry::millimetres(done.warped) + " made plane");
  if (done.moved > 0.0) add("corners moved by up to " + geometry::millimetres(done.moved));
  if (item.dents > 0.0) add("dents shallower than " + geometry::millimetres(item.dents) + " left out");
  if (item.parted > 0.0) add("cut by " + geometry::millimetres(item.parted) + " where it lay in another stone or the base");
  if (!item.fitted.empty()) add(item.fitted);
  if (pieces > 1)
    add("not convex, cut into " + std::to_string(pieces) + " pieces " +
        (law.empty() ? "that never part" : "joined by the law \"" + law + "\""));
  return text;
}

}  // namespace voussoir::io
