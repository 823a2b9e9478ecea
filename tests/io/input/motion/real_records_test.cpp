// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cases/motion.h"
#include "cases/tables/motion.h"
#include "io/input/files/errors.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"

using namespace voussoir;

// Real records are not part of the project; where they are absent these tests say so and pass.
namespace {

const std::string kRecords = std::string(VOUSSOIR_SOURCE_DIR) + "/../shared/records/";

bool present() {
  if (std::filesystem::exists(kRecords)) return true;
  MESSAGE("skipped: no real records in ", kRecords);
  return false;
}

struct Expected {
  const char* file;
  std::size_t samples;
  double dt, peak, peak_time;  // s, m/s2, s
  const char* component;
};
constexpr Expected kExpected[] = {
    {"northridge1994_rinaldi/RSN1063_NORTHR_RRS228.AT2", 1991, 0.01, 0.874060 * 9.80665, 2.560, ", 228"},
    {"northridge1994_rinaldi/RSN1063_NORTHR_RRS318.AT2", 1991, 0.01, 0.472348 * 9.80665, 4.220, ", 318"},
    {"northridge1994_rinaldi/RSN1063_NORTHR_RRS-UP.AT2", 1991, 0.01, 0.958169 * 9.80665, 2.970, ", UP"},
    {"landers1992_lucerne/RSN879_LANDERS_LCN260.AT2", 9625, 0.005, 0.725165 * 9.80665, 10.470, ", 260"},
    {"landers1992_lucerne/RSN879_LANDERS_LCN345.AT2", 9625, 0.005, 0.788760 * 9.80665, 14.860, ", 345"},
    {"landers1992_lucerne/RSN879_LANDERS_LCN-UP.AT2", 9625, 0.005, 0.823257 * 9.80665, 9.590, ", UP"},
    {"manjil1990_abbar/RSN1633_MANJIL_ABBAR--L.AT2", 2676, 0.02, 0.514564 * 9.80665, 10.900, ", L"},
    {"manjil1990_abbar/RSN1633_MANJIL_ABBAR--T.AT2", 2300, 0.02, 0.496868 * 9.80665, 12.360, ", T"},
    {"manjil1990_abbar/RSN1633_MANJIL_ABBAR--V.AT2", 2671, 0.02, 0.538042 * 9.80665, 9.060, ", V"},
};

}  // namespace

TEST_CASE("real AT2 files: count, step, peak and its time") {
  if (!present()) return;
  for (const Expected& e : kExpected) {
    CAPTURE(e.file);
    const cases::Accelerogram a = io::read_accelerogram(kRecords + e.file, {});
    const io::MotionFigures f = io::figures(a);
    CHECK(a.acceleration.size() == e.samples);
    CHECK(a.dt == e.dt);
    CHECK(f.peak_acceleration == doctest::Approx(e.peak).epsilon(2e-6));
    CHECK(f.peak_time == doctest::Approx(e.peak_time).epsilon(1e-9));
    CHECK(a.name.ends_with(e.component));
  }
}

TEST_CASE("real AT2 files: the velocity is that of the VT2 file beside it") {
  if (!present()) return;
  // Peaks of the VT2 files in cm/s; they were integrated with g = 980.5 cm/s2.
  const double g = 980.665 / 980.5;
  const auto pgv = [](const std::string& file) { return 100.0 * io::figures(io::read_accelerogram(kRecords + file, {})).peak_velocity; };
  CHECK(pgv(kExpected[0].file) == doctest::Approx(147.9228 * g).epsilon(1e-4));
  CHECK(pgv(kExpected[1].file) == doctest::Approx(74.7325 * g).epsilon(1e-4));
  CHECK(pgv(kExpected[2].file) == doctest::Approx(42.16624 * g).epsilon(1e-4));
}

TEST_CASE("real files of the older and the NGA-East form") {
  if (!present()) return;
  const cases::Accelerogram old = io::read_accelerogram(kRecords + "formats/peer_old/PEandA_ElCentroArray4_140.AT2", {});
  CHECK(old.acceleration.size() == 7818);
  CHECK(old.dt == 0.005);
  CHECK(io::figures(old).peak_acceleration == doctest::Approx(0.48431 * 9.80665).epsilon(2e-5));  // PGA of its header
  const cases::Accelerogram east = io::read_accelerogram(kRecords + "formats/peer_nga_east/RSN10590_ComalTX11-10-20_IU.CCM.BHZ.00.AT2", {});
  CHECK(east.acceleration.size() == 15306);
  CHECK(east.dt == 0.05);
}

TEST_CASE("real files of velocity are refused") {
  if (!present()) return;
  for (const char* file : {"northridge1994_rinaldi/RSN1063_NORTHR_RRS228.VT2", "manjil1990_abbar/RSN1633_MANJIL_ABBAR--V.VT2"}) {
    CHECK_THROWS_WITH_AS(io::read_accelerogram(kRecords + file, {}), doctest::Contains(":3: the file holds velocity"), io::FileError);
  }
}

namespace {

/// A file of a network: its components, and by how much the peak may differ from the one its header states: half of that one's last digit.
struct NetworkFile {
  const char* file;
  std::vector<std::string> components;
  std::vector<std::size_t> samples;
  double dt, last_digit;  // s, m/s2
};
const NetworkFile kNetworkFiles[] = {
    {"cosmos/Cosmos12TimeSeriesTest_glued8F10.5.v1", {"340 deg"}, {7000}, 0.01, 1e-5},
    {"cosmos/us1000hyfh_AKBMR_BNZ.acc.V2c", {"BNZ"}, {42000}, 0.005, 1e-8},
    {"csmip/ce36456p_CE36456.V2", {"90 DEG", "UP", "0 DEG"}, {3251, 3250, 3250}, 0.02, 1e-5},
    {"esm/AFAD_20101114230825_3104_ap_RawAcc_E.asc", {"HNE"}, {5600}, 0.01, 1e-5},
    {"esm/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", {"HNE"}, {19128}, 0.005, 1e-8},
    {"esm/HI.ARS1..HNN.D.20190728.160908.C.ACC.ASC", {"HNN"}, {19128}, 0.005, 1e-8},
    {"esm/HI.ARS1..HNZ.D.20190728.160908.C.ACC.ASC", {"HNZ"}, {19128}, 0.005, 1e-8},
    {"geonet/20180212_211557_WPWS_20_glued.V2A", {"S16W", "S74E", "Up"}, {5800, 5800, 5800}, 0.02, 1e-4},
    {"knet/AOM0011801241951.EW", {"E-W"}, {10200}, 0.01, 1e-5},
    {"knet/AOM0011801241951.NS", {"N-S"}, {10200}, 0.01, 1e-5},
    {"knet/AOM0011801241951.UD", {"U-D"}, {10200}, 0.01, 1e-5},
};

}  // namespace

TEST_CASE("real files of networks: components, counts, steps, and the peak that the header states") {
  if (!present()) return;
  for (const NetworkFile& e : kNetworkFiles) {
    CAPTURE(e.file);
    const auto channels = io::read_motion_file(kRecords + "formats/" + e.file, {});
    REQUIRE(channels.size() == e.components.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
      CHECK(channels[i].component == e.components[i]);
      CHECK(channels[i].motion.acceleration.size() == e.samples[i]);
      CHECK(channels[i].motion.dt == doctest::Approx(e.dt).epsilon(1e-12));
      REQUIRE(channels[i].stated_peak);
      CHECK(std::abs(io::figures(channels[i].motion).peak_acceleration - *channels[i].stated_peak) <= 0.5001 * e.last_digit);
    }
  }
}

TEST_CASE("a real BHRC file: three components of a record") {
  if (!present()) return;
  const io::Record r = io::read_record_file(kRecords + "formats/bhrc/5528-1.V1", {});
  for (const auto& a : r.ltv) {
    CHECK(a.acceleration.size() == 15360);
    CHECK(a.dt == doctest::Approx(0.005).epsilon(1e-12));
  }
  // The first value of each block, in tenths of g.
  CHECK(r.ltv[0].acceleration[0] == doctest::Approx(0.1 * 0.648367e-3 * 9.80665).epsilon(1e-12));
  CHECK(r.ltv[1].name == "Basmanj, 2012/08/11   12:23:16, T");
}

TEST_CASE("Rinaldi scaled has the peaks of the record that bam-like stands in for") {
  if (!present()) return;
  cases::Motion m;
  m.ltv = {kExpected[0].file, kExpected[1].file, kExpected[2].file};
  m.scale = {0.908, 1.346, 1.043};
  m.direction = "TLV";
  const cases::GroundMotion got = io::load_motion(m, kRecords);
  CHECK(io::figures(got.axis[0]).peak_acceleration == doctest::Approx(6.2344).epsilon(1e-3));
  CHECK(io::figures(got.axis[1]).peak_acceleration == doctest::Approx(7.7828).epsilon(1e-3));
  CHECK(io::figures(got.axis[2]).peak_acceleration == doctest::Approx(9.7995).epsilon(1e-3));
}
