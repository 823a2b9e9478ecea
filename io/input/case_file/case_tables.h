// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "cases/house/house_case.h"
#include "cases/solids/stones.h"
#include "cases/tables/analysis.h"
#include "cases/tables/blocks.h"
#include "cases/tables/joint_laws.h"
#include "cases/tables/loads.h"
#include "cases/tables/motion.h"
#include "cases/tables/output.h"
#include "cases/walls/wall_case.h"
#include "io/input/case_file/case_keys.h"

/// The option tables of the case file; `case_table` is the root and contains the others.
namespace voussoir::io {

inline constexpr double kShortestVector = 1e-100;  // shorter vectors have no direction, since their square is 0

const Table<cases::Case>& case_table();
Table<cases::JointLaw> joint_law_table();
Table<cases::House> house_table();
Table<cases::Motion> motion_table();
Table<cases::Output> output_table();
Table<cases::BlockSpec> block_table();
Table<cases::SupportMotion> support_motion_table();
Table<cases::StonesSpec> stones_table();
Table<cases::WallSpec> wall_table();
Table<cases::WallFloor> wall_floor_table();
Table<cases::WallRoof> wall_roof_table();
Table<cases::WallVault> wall_vault_table();
Table<cases::Load> load_table();
Table<cases::Analysis> analysis_table();
/// Checks the keys of the case that [analysis] requires.
void check_analysis(const cases::Case& c, const RuleCheck& check);
Table<cases::Tie> tie_table();
Table<cases::HouseTie> house_tie_table();
Table<cases::HouseTie> wall_tie_table();
Table<cases::HouseMesh> house_mesh_table();
Table<cases::Floor> house_floor_table();
Table<cases::Tie> roof_tie_table();
Table<cases::Deck> deck_table();

}  // namespace voussoir::io
