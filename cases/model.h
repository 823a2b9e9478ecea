// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/loads/support_history.h"
#include "cases/solids/stones.h"
#include "cases/tables/blocks.h"
#include "cases/tables/joint_laws.h"
#include "cases/tables/materials.h"
#include "geometry/assembly.h"

/// The model of a case: every block with its material, and the law of every joint.
namespace voussoir::cases {

/// The role of a block in a house; decides the law of its joints.
enum class PartKind : std::uint8_t { block, brick, lintel, beam, voussoir, column, ring_beam, floor_beam, walling, arch_stone };
/// The usual name: "brick", "ring beam".
const char* name(PartKind kind) noexcept;

/// Floors, roofs and vaults of a case.
WallSpans spans_of(const Case& c);

/// One future element, in order of element numbers.
struct Block {
  Block();  // this and the next five are in compiled_once.cpp
  Block(const Block&);
  Block(Block&&) noexcept;
  Block& operator=(const Block&);
  Block& operator=(Block&&) noexcept;
  ~Block();

  std::string name;            // of a free [[block]]; empty in houses
  std::string tag;             // "front wall", "roof beam 12", "lintel 0", ...; for output
  std::int32_t material = 0;   // index into Model::materials
  geometry::Polyhedron shape;  // global axes, m
  double segment_size = 0.0;   // m
  PartKind kind = PartKind::block;
  std::int32_t house = -1;   // copy number of the house, −1: a free block
  std::int32_t member = -1;  // timber member in its house, or among those between walls (shared by the elements of one beam), −1: none
  std::int32_t floor = -1;   // index into House::floors, of a floor beam
  std::int32_t built = -1;   // position in the building order of the house, −1: a free block
  std::int32_t leaf = -1;    // of a wall of two leaves: 2 * wall, + 1 for the inner leaf; −1: no leaf, or through both
  bool whole = true;         // false: a cut brick
  bool fixed = false, free = false;
  Vec3 velocity, angular_velocity;   // initial, m/s and rad/s
  std::int32_t support_motion = -1;  // index into Model::support_motions
  std::int32_t given = -1;           // index into Case::blocks; −1: of a house or of a file
  std::int32_t wall = -1;            // index into Case::walls; −1: not of [[wall]]
  std::int32_t span = -1;            // of a floor beam index into Case::floors, of a rafter into Case::roofs; −1: of neither
  std::int32_t vault = -1;           // index into Case::vaults; −1: not of one
  CellCounts cells{1, 1, 1};         // into which it will be divided, along the edges at its first vertex; of a hexahedron
  std::int32_t unit = -1;            // number of the unit of which it is a cell; −1: in one piece
  std::int32_t ground = -1;          // index into Base::parts; −1: not ground
  std::int32_t set = -1;             // index into Case::stones; −1: not from a file
  std::int32_t stone = -1;           // number of the stone in the model, shared by all its pieces; −1: not from a file
  std::string part_of;               // name of the stone or unit, if this is a piece or a cell of it
  std::vector<std::string> groups;   // of the file
  std::vector<std::int32_t> beds;    // faces that lie on a mortar bed (StonesSpec::gap)
};

struct NamedMaterial {
  std::string name;
  Material value;
  std::int32_t made_from = -1;  // material whose joint and contact rules apply; −1: its own
  bool is_ground = false;       // of parts of the ground: the rules of the base apply
};
struct NamedLaw {
  std::string name;  // "dry" is always law 0: no bond
  JointLaw value;
  std::int32_t made_from = -1;  // law of which this is a copy with the mortar of a gap between stones; −1: original
  bool never_breaks = false;    // within a stone in pieces
};

/// Share of the force of a tie's end on one element (geometry::kBase: the base), at a point fixed to the element.
struct TieHold {
  std::int32_t element = 0;
  double share = 1.0;
  Vec3 point;  // m, at the start
};

/// A tie with its ends attached to elements; lengths and forces are those of the whole bar.
struct TieBar {
  std::string name;
  std::array<std::vector<TieHold>, 2> ends;  // the shares of an end sum to 1
  double length = 0.0;                       // m, between the initial positions of the ends
  double stiffness = 0.0;                    // N/m, E A / length
  double yield = 0.0;                        // N; infinite: elastic
  double hardening = 0.0;                    // N/m, of the yield force over the plastic elongation
  double breaking = 0.0;                     // m, elongation; infinite: never
  double pretension = 0.0;                   // N
  bool compression = false;
  std::int32_t mesh = -1;  // index into House::meshes, followed by the decks of House::floors and of the roof; −1: a separate tie
};

/// Material needed for strengthening by one [[tie]], [[house.tie]] or [[house.mesh]].
struct TieBill {
  std::string name;
  std::int64_t ties = 0, anchors = 0;  // anchors: plates, and ends of connectors
  double length = 0.0;                 // m of rod
  double area = 0.0;                   // m2 of mesh
};

struct Model {
  Model();  // this and the next five are in compiled_once.cpp
  Model(const Model&);
  Model(Model&&) noexcept;
  Model& operator=(const Model&);
  Model& operator=(Model&&) noexcept;
  ~Model();

  Vec3 origin;  // m, in the axes of the case file: all coordinates of the model are relative to it (Case::origin)
  std::vector<Block> blocks;
  std::int32_t units = 0;  // that are divided into cells
  std::vector<NamedMaterial> materials;
  std::vector<NamedLaw> laws;                   // laws[0] is "dry"
  std::vector<SupportHistory> support_motions;  // of fixed blocks, then of loads
  std::vector<std::int32_t> load_history;       // by load of the case: index into support_motions; −1: none
  std::vector<std::int32_t> load_path;          // likewise, of the places of a load that moves
  std::vector<std::vector<Stone>> stones;       // by table of the case
  geometry::Assembly assembly;                  // of all blocks, in order
  std::vector<std::int32_t> joint_law;          // by assembly joint: index into laws
  std::vector<double> contact_friction;         // degrees, see contact_friction in cases/rules/contact_rules.h
  std::vector<TieBar> ties;                     // separate ties before ties of meshes
  std::vector<TieBill> tie_bill;
  std::vector<double> joint_strength;  // by assembly joint: factor on f_t, c and f_m of its law (Case::scatter)
};

/// Builds blocks (houses first, then walls, numbered along their plan, then free blocks, then stones), assembles them and chooses the law
/// of every joint. A house stands on the base, so its walls begin at the height of Case::base (0 without a base, on fixed blocks). Motions
/// of supports given as files stay empty, with the name of the file; io reads them. \pre stones of files have been read
/// (StonesSpec::stones) by io The law is the first that applies of materials.<name>.inside (pieces of one stone, cells of one unit), the
/// house's own keys, stones.joint, joints.between, joints.default; between two beds of stones.gap it has mortar of that thickness. \param
/// threads  number of threads; the model does not depend on it \throw InputError with the key at fault; faults of geometry are reported by
/// the name or tag of the block.
Model build_model(const Case& c, int threads = 1);

/// Frees the joints and free patches of the assembly, which the steps of a run do not need: a fifth of the model.
/// \pre what is set up, or writes the model, has been
void forget_joints(Model& model) noexcept;

/// The element whose centroid is nearest to `point` [m, global]; the lowest number among elements equally near (to 1 nm).
/// \pre the model has an element
std::int32_t nearest_element(const Model& model, Vec3 point) noexcept;

/// Everything with this name, each as its elements: a block (all cells of a divided one), a cell of a block, a stone (all its pieces), a
/// piece of a stone, or all stones of a group. Empty if nothing has the name.
std::vector<std::vector<std::int32_t>> parts_named(const Model& model, const std::string& name);

/// Name of an element in messages: `front wall (element 12)`, with the house if there are several; `block "slider" (element 3)`.
std::string describe(const Block& block, std::size_t element);

}  // namespace voussoir::cases
