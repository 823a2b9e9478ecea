// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Table [contact] of the case file.
namespace voussoir::cases {

enum class ContactNormal { slave, master };
enum class Dashpots { bounded, unbounded };  // unbounded: dashpots may make a contact pull, and exceed friction
struct ContactRule {
  std::array<std::string, 2> materials;  // "base" counts as a material
  double friction = 0.0;                 // degrees
};
struct Contact {
  double friction = 32.0;            // degrees, of all pairs of materials not in `between`
  std::vector<ContactRule> between;  // each pair of materials at most once
  double damping = 1.0;              // h_n = h_s
  Dashpots dashpots = Dashpots::bounded;
  std::optional<double> restitution;  // of free bodies; none: that of the dashpots
  ContactNormal normal = ContactNormal::slave;
  double compression = 0.0;           // Pa; 0: contacts bear any pressure
  double crushing_energy = 0.0;       // J/m2, beyond the work of the residual; 0: the strength does not fall
  double residual_compression = 0.0;  // Pa
  double crushing_depth = 0.01;       // m
};

}  // namespace voussoir::cases
