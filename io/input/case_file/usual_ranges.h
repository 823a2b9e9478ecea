// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/input/document/case_values.h"

/// Usual ranges of values of the case file, by key, and their sources. Values outside are accepted, but reported as a probable mistake of
/// unit: the ranges are wide, so that no real building is reported, while a factor of 1,000 (kPa, MPa, g/cm3, mm) mostly is. Signs do not
/// count, 0 is always usual. Values a thousand times beyond, or beyond the second pair of numbers where it stands, are refused as
/// impossible. Sources: EN 1991-1-1 (Annex A: densities), EN 1996-1-1 (3.7.2: E is about 1000 f_k; Table 3.4: f_vk0 of 0.1 to 0.4 MPa;
/// 3.6.2: tan phi of 0.4), EN 1998-1 (3.2.2.2: periods up to 4 s), quoted from general knowledge, not from the texts. Ranges without a
/// source are assumed.
namespace voussoir::io::usual {

// Materials.
inline constexpr Usual kDensity{200.0, 12000.0, 0.1, 1e5};  // kg/m3; EN 1991-1-1, Annex A: timber from 350, lead 11,400
inline constexpr Usual kYoung{1e6, 5e11, 1.0, 1e14};  // Pa; from wet earth to above steel (2.1e11, EN 1993-1-1, 3.2.6); diamond: 1.2e12
inline constexpr Usual kPoisson{0.01, 0.49};          // EN 1993-1-1: steel 0.3; else assumed
inline constexpr Usual kStrength{100.0, 1e13, 1e-3,
                                 1e20};  // Pa, of a bond: far below EN 1996-1-1's 1e5; unbreakable bonds are often given 1e12
inline constexpr Usual kCompression{1e4, 1e13, 1e-3, 1e20};  // Pa, upper end as kStrength
inline constexpr Usual kFriction{5.0, 75.0};     // degrees; EN 1996-1-1: 22; slips of radians (0.6) and of tangents (0.4) lie below
inline constexpr Usual kDilatancy{0.5, 45.0};    // degrees
inline constexpr Usual kCap{0.1, 1000.0};        // C_s; 9 in the paper
inline constexpr Usual kMortar{1e-4, 0.1};       // m, thickness of a bed; EN 1996-1-1, 8.1.5: 0.5 to 15 mm
inline constexpr Usual kMortarYoung{1e5, 1e11};  // Pa
inline constexpr Usual kFracture{0.1, 1e5};      // J/m2; 1 N/mm is 1000 J/m2
inline constexpr Usual kJointStiffness{1e6, 1e14, 1.0, 1e17};  // Pa/m; 1 N/mm3 is 1e9 Pa/m
inline constexpr Usual kClosure{1e-7, 0.02, 1e-10, 20.0};      // m
inline constexpr Usual kEccentricity{0.001, 0.3};              // of the plan's width; EN 1998-1, 4.3.2: 0.05
inline constexpr Usual kVariation{0.005, 1.0};                 // a ratio, no per cent
inline constexpr Usual kCrushing{1.0, 1e8};                    // J/m2
inline constexpr Usual kCrushed{1e-5, 0.2};                    // m
inline constexpr Usual kDashpot{0.001, 10.0};                  // of critical
inline constexpr Usual kRestitution{0.05, 1.0};                // below, the springs of a contact are 400 times softer than its elements

// Time and damping.
inline constexpr Usual kRatio{1e-4, 0.2};      // fraction of critical, no per cent
inline constexpr Usual kFrequency{0.02, 1e4};  // Hz; EN 1998-1: periods of buildings up to 4 s, 50 s is beyond; single blocks ring high
inline constexpr Usual kDecay{1e-4, 1e4};      // 1/s
inline constexpr Usual kStep{1e-9, 0.01, 0.0, 10.0};      // s
inline constexpr Usual kWait{1e-3, 1000.0};               // s: ramps, waiting times, windows, tapers
inline constexpr Usual kDuration{1e-3, 2000.0};           // s; no shaking lasts longer
inline constexpr Usual kInterval{1e-6, 10.0, 1e-9, 1e4};  // s, between rows or frames
inline constexpr Usual kFrames{1e-5, 1e6, 1e-9, 1e9};     // s, between frames; longer than the run: one
inline constexpr Usual kSample{1e-4, 0.1};                // s, between samples of a record
inline constexpr Usual kFactor{1e-3, 50.0};               // on a motion
inline constexpr Usual kSpectral{0.01, 200.0};            // m/s2

// Loads and motions of supports.
inline constexpr Usual kForce{1e-3, 1e9};      // N, N m: a thousand tons at most, 1e4 kN is 1e7 N
inline constexpr Usual kSpeed{1e-9, 100.0};    // m/s
inline constexpr Usual kSpin{1e-6, 1000.0};    // rad/s
inline constexpr Usual kAmplitude{1e-7, 1.0};  // m, of cycles
inline constexpr Usual kTilt{1e-3, 60.0};      // degrees
inline constexpr Usual kAreaLoad{2.0, 700.0};  // kg/m2; EN 1991-1-1, 6.3: 1.5 to 7.5 kN/m2 live; values in kPa or kN/m2 are below

// Sizes.
inline constexpr Usual kHouse{0.1, 100.0};               // m, in plan; also a place along a wall
inline constexpr Usual kHeight{0.1, 60.0};               // m, of a storey
inline constexpr Usual kLevel{1e-3, 60.0};               // m, above a foot
inline constexpr Usual kBrick{0.02, 3.0};                // m, an edge
inline constexpr Usual kThickness{0.05, 5.0};            // m, of a wall
inline constexpr Usual kOpening{0.05, 20.0};             // m, clear
inline constexpr Usual kSection{0.01, 2.0};              // m, of timber, lintels, arches and plates
inline constexpr Usual kMember{0.02, 30.0};              // m, along timber, lintels, springers, spans
inline constexpr Usual kBeamSpacing{0.1, 3.0};           // m, of the axes of floor beams
inline constexpr Usual kRadius{0.2, 60.0};               // m, of a vault
inline constexpr Usual kGround{1e-3, 9000.0, 0.0, 1e9};  // m, above or below zero: no house is higher
inline constexpr Usual kSegment{1e-3, 2.0};              // m

// Ties, meshes and decks.
inline constexpr Usual kBarArea{1e-7, 0.1};         // m2; 100 mm2 is 1e-4 m2
inline constexpr Usual kBarYoung{1e7, 1e12};        // Pa; EN 1993-1-1: 2.1e11
inline constexpr Usual kYield{1e5, 5e9};            // Pa; EN 1993-1-1: 2.35e8
inline constexpr Usual kHardening{1e4, 1e12};       // Pa
inline constexpr Usual kElongation{1e-3, 1.0};      // a strain, no per cent
inline constexpr Usual kPretension{50.0, 1e7};      // N
inline constexpr Usual kStripStiffness{1e2, 1e10};  // N/m
inline constexpr Usual kStripStrength{10.0, 1e8};   // N/m

// Bounds without a usual range.
inline constexpr double kFarthest = 1e9;  // m, of any coordinate; what is built lies within 1e7 m of the origin (cases/solids/origin.h)
inline constexpr double kMostTurn = 1e6;  // degrees

}  // namespace voussoir::io::usual
