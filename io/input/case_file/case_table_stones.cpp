// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/usual_ranges.h"

namespace voussoir::io {
namespace {

using namespace cases;

/// Key `turn`: a number of degrees about z, or a table.
Key<StonesSpec> turn_key() {
  using S = StoneTurn;
  const Table<S> turn{"turns the stones about an axis, before they are moved by place; a number: degrees about the file's z axis",
                      {value<S>("axis", &S::axis, "", any(), "direction of the axis; need not be a unit vector"),
                       value<S>("angle", &S::angle, "degrees", any().possibly(0.0, usual::kMostTurn), "angle, by the right hand"),
                       value<S>("about", &S::about, "m", any().possibly(0.0, usual::kFarthest), "a point of the axis")},
                      [](const S& s, const RuleCheck& check) {
                        if (norm(s.axis) < kShortestVector) check.fault("axis", "has no direction");
                      }};
  Key<StonesSpec> key = table<StonesSpec>("turn", &StonesSpec::turn, turn);
  key.info.types = {{"number", {}}};
  key.read = [as_table = key.read, info = key.info](const Node& node, StonesSpec& s, Reading& reading, const std::string& path) {
    if (node.as<Node::Table>() != nullptr) return as_table(node, s, reading, path);
    KeyInfo number = info;
    number.unit = "degrees", number.shape = "a number (degrees about z) or a table";
    read_value(node, s.turn.angle, number, reading, path);
  };
  return key;
}

/// Key `supports`: a word, a level, or names.
Key<StonesSpec> supports_key() {
  Key<StonesSpec> key;
  key.info = {"supports",
              "",
              "stones that are fixed: all that touch the lowest level of the file (\"ground\"), none of them (\"none\"), all that "
              "reach below a height [m], or those of the names and groups in an array; none: those that the file marks as supports, and if "
              "it marks none and the case has neither [base] nor a fixed block: \"ground\"",
              any().possibly(0.0, usual::kFarthest),
              "\"ground\" | \"none\", a number or an array of names",
              false,
              {{"number", {}}, {"string", {-1}}},
              {"\"ground\"", "\"none\""}};
  key.read = [info = key.info](const Node& node, StonesSpec& s, Reading& reading, const std::string& path) {
    using Kind = StoneSupports::Kind;
    if (same_word(node, "\"ground\"") || same_word(node, "\"none\"")) {
      s.supports.kind = same_word(node, "\"none\"") ? Kind::none : Kind::ground;
    } else if (node.as<Node::Array>() != nullptr) {
      s.supports.kind = Kind::named;
      read_value(node, s.supports.names, info, reading, path);
    } else if (!reading.mistyped(node, path, info, {"ground", "none"}) && read_value(node, s.supports.level, info, reading, path)) {
      s.supports.kind = Kind::below;
    }
  };
  key.text = [](const StonesSpec& s) -> std::string {
    using Kind = StoneSupports::Kind;
    switch (s.supports.kind) {
      case Kind::ground:
        return "\"ground\"";
      case Kind::none:
        return "\"none\"";
      case Kind::below:
        return value_text(s.supports.level);
      case Kind::named:
        return list_text(s.supports.names);
      case Kind::automatic:
        break;
    }
    return "";
  };
  return key;
}

}  // namespace

Table<StonesSpec> stones_table() {
  using S = StonesSpec;
  const std::vector<std::pair<std::string, std::string>> units{{"m", "m"}, {"cm", "cm"}, {"mm", "mm"}, {"in", "in"}, {"ft", "ft"}};
  const std::vector<std::pair<std::string, WarpedFaces>> warped{{"refuse", WarpedFaces::refuse}, {"triangles", WarpedFaces::triangles}};
  const std::vector<std::pair<std::string, StoneFit>> fits{{"snap", StoneFit::snap}, {"planes", StoneFit::planes}};
  return {
      "stones out of a file: every closed body in it is one",
      {required(value<S>("file", &S::file, "", filled(), "OBJ, PLY, STL, VTU or COMPAS JSON; or a folder, each such file in it a stone")),
       required(choice<S>("unit", &S::unit, "", units, "of lengths in the file; none of these formats says it")),
       value<S>("name", &S::name, "", any(), "goes before the names of its stones: \"name/stone\""),
       value<S>("only", &S::only, "", any(), "names and groups of the file that are taken; none: all"),
       value<S>("place", &S::place, "m", any(), "by which the stones are moved, after they were turned"), turn_key(),
       value<S>("material", &S::material, "", any(), "a name of materials; none: the only one"),
       value<S>("part", &S::part, "", any(), "the part of a building that its stones are of, as block.part; none: no part"),
       value<S>("joint", &S::joint, "", filled(), "law between stones of this table: a name of joint_laws, or \"dry\"; none: [joints]"),
       value<S>(
           "snap", &S::snap, "m", within(0.0, 0.05),
           "faces nearer than this, or as much inside each other, are put into one plane and are in contact; faces that are warped by no "
           "more are made plane; what else of a stone lies in another one or under the base by no more is cut off"),
       value<S>(
           "gap", &S::gap, "m", within(1e-4, 0.2),
           "faces so far apart (within snap) have a bed of mortar between them: both stones are grown to its middle, and its thickness "
           "enters Eq. 3 in place of the law's; none: they do not touch"),
       choice<S>(
           "warped", &S::warped, "", warped,
           "faces that are warped by more than snap: refused, or parted into triangles along their shortest diagonals, after which the "
           "stone is cut along its reflex edges"),
       choice<S>(
           "fit", &S::fit, "", fits,
           "how stones are made to touch: within snap; or, for stones drawn with gaps, overlaps and warped faces, by one plane for each "
           "pair that touches, the best fit of both faces, to which both are cut and filled. The same in all tables of a case"),
       value<S>("fit_limit", &S::fit_limit, "m", above(0.0).possibly(1e-6, 10.0),
                "with fit = \"planes\": how far the surface of a stone may move; overlaps of two stones up to the sum of their limits, and "
                "gaps up to half of it, are mended; none: a quarter of the least width of each stone"),
       supports_key(), table<S>("motion", &S::motion, support_motion_table())},
      [](const S& s, const RuleCheck& check) {
        if (s.gap && *s.gap <= 2.0 * s.snap) check.fault("gap", "must be above twice snap, or a bed cannot be told from a contact");
        if (s.fit == StoneFit::planes && s.gap) check.fault("gap", "cannot be used with fit = \"planes\", which closes gaps");
        if (s.fit == StoneFit::planes && s.warped != WarpedFaces::refuse)
          check.fault("warped", "cannot be \"triangles\" with fit = \"planes\", which makes warped faces plane");
        if (s.fit == StoneFit::snap && s.fit_limit) check.fault("fit_limit", "is used with fit = \"planes\" alone");
        if (s.name.find('/') != std::string::npos) check.fault("name", "cannot hold '/': it parts a stone's name from its table's");
      }};
}

}  // namespace voussoir::io
