// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_paths.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "cases/case.h"
#include "io/input/motion/motion_files.h"

namespace voussoir::io {
namespace {

using cases::Case;

void change_if(std::optional<std::string>& path, const PathChange& change) {
  if (path) change(*path);
}

void change_record(std::string& record, const PathChange& change) {
  if (!is_built_in_record(record)) change(record);
}

template <class Files, class Change>
void of_motion(Case& c, Files files, std::size_t axis, const Change& change) {
  if (c.motion) change_if(std::invoke(files, *c.motion)[axis], change);
}

/// A key with a path: its name in a document (in an array of tables, for each of them), and its member in a case.
struct PathKey {
  std::string_view key;
  void (*in_case)(Case&, const PathChange&);
};

constexpr std::string_view kRecord = "motion.record";

constexpr std::array<PathKey, 13> kPaths{{
    {kRecord,
     [](Case& c, const PathChange& change) {
       if (c.motion && c.motion->record) change_record(*c.motion->record, change);
     }},
    {"motion.x", [](Case& c, const PathChange& change) { of_motion(c, &cases::Motion::xyz, 0, change); }},
    {"motion.y", [](Case& c, const PathChange& change) { of_motion(c, &cases::Motion::xyz, 1, change); }},
    {"motion.z", [](Case& c, const PathChange& change) { of_motion(c, &cases::Motion::xyz, 2, change); }},
    {"motion.L", [](Case& c, const PathChange& change) { of_motion(c, &cases::Motion::ltv, 0, change); }},
    {"motion.T", [](Case& c, const PathChange& change) { of_motion(c, &cases::Motion::ltv, 1, change); }},
    {"motion.V", [](Case& c, const PathChange& change) { of_motion(c, &cases::Motion::ltv, 2, change); }},
    {"stones.file",
     [](Case& c, const PathChange& change) {
       for (cases::StonesSpec& spec : c.stones) change(spec.file);
     }},
    {"block.motion.file",
     [](Case& c, const PathChange& change) {
       for (cases::BlockSpec& block : c.blocks)
         if (block.motion) change_if(block.motion->file, change);
     }},
    {"stones.motion.file",
     [](Case& c, const PathChange& change) {
       for (cases::StonesSpec& spec : c.stones)
         if (spec.motion) change_if(spec.motion->file, change);
     }},
    {"base.part.motion.file",
     [](Case& c, const PathChange& change) {
       if (!c.base) return;
       for (cases::BasePart& part : c.base->parts)
         if (part.motion) change_if(part.motion->file, change);
     }},
    {"load.history",
     [](Case& c, const PathChange& change) {
       for (cases::Load& load : c.loads) change_if(load.history, change);
     }},
    {"load.path",
     [](Case& c, const PathChange& change) {
       for (cases::Load& load : c.loads) change_if(load.path, change);
     }},
}};

void change_at(Node& node, std::string_view key, const PathChange& change) {
  if (key.empty()) {
    if (auto* path = node.as<std::string>(); path != nullptr && !path->empty()) change(*path);
    return;
  }
  if (auto* array = node.as<Node::Array>()) {
    for (Node& n : *array) change_at(n, key, change);
  }
  auto* table = node.as<Node::Table>();
  if (table == nullptr) return;
  const std::size_t dot = std::min(key.find('.'), key.size());
  if (Entry* entry = find_entry(*table, key.substr(0, dot))) change_at(entry->node, key.substr(std::min(dot + 1, key.size())), change);
}

}  // namespace

void for_each_path(Case& value, const PathChange& change) {
  for (const PathKey& path : kPaths) path.in_case(value, change);
}

void for_each_path(Node& document, const PathChange& change) {
  const PathChange record = [&](std::string& path) { change_record(path, change); };
  for (const PathKey& path : kPaths) change_at(document, path.key, path.key == kRecord ? record : change);
}

}  // namespace voussoir::io
