// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "kernels/side.h"

/// Stiffness of a whole side against the motions of its two elements, for what needs the stiffness of the structure.
namespace voussoir::solver {

using Stiffness12 = Eigen::Matrix<double, 12, 12>;  // displacement and rotation of the master, then of the slave
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Σ Bᵀ D B dA over the contact points of a side (Eqs. 4, 11).
Stiffness12 side_stiffness(const kernels::Side& side, const kernels::PointsView& points);

/// x ↦ v × x
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v);

inline Eigen::Vector3d vector(Vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace voussoir::solver
