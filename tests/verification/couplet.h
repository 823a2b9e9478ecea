// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/verification/fixture.h"

/// The couplet of V5: two bricks, the lower one fixed.
namespace voussoir::testing {

inline constexpr double kTension = 1.27e5, kCohesion = 3.04e4, kCompression = 4.9e5, kCap = 9.0;  // Pa, law "normal"
inline const double kTanPhi = std::tan(radians(32.0));
inline constexpr double kWidth = 0.2, kDepth = 0.1, kArea = kWidth * kDepth;

inline std::int64_t events(const solver::Damage& d) { return d.tension + d.shear + d.compression + d.slipped; }

/// The couplet by imposed displacement: uniform stress, however far it goes.
class Press {
 public:
  explicit Press(const std::vector<std::string>& overrides = {}) : run_(unloaded(overrides)) {}
  /// Moves the upper brick by `by` in even steps with `speed` [m/s]; `each` sees the force of the joint on the brick after each step.
  template <class Each>
  void move(Vec3 by, double speed, const Each& each) {
    const double step = speed * run_.sim().dt();
    const int steps = std::max(1, static_cast<int>(std::ceil(norm(by) / step)));
    const Vec3 part = (1.0 / steps) * by;
    for (int i = 0; i < steps; ++i) {
      u_ += part;
      place(run_, 1, u_, part / run_.sim().dt());
      run_.cycle({true, false});
      each(run_.sim().forces().base_shear);
    }
  }
  /// The force on the brick at rest where it is.
  Vec3 hold() {
    place(run_, 1, u_, {});
    run_.cycle({true, false});
    return run_.sim().forces().base_shear;
  }
  [[nodiscard]] solver::Damage damage() const { return run_.sim().damage(); }
  /// J, lost by breaking so far.
  [[nodiscard]] double fracture() const {
    double sum = 0.0;
    for (const double of_side : run_.sim().world().sides.fracture) sum += of_side;
    return sum;
  }
  [[nodiscard]] bool failed() const { return events(damage()) > 0; }
  [[nodiscard]] double u() const { return u_.z; }

 private:
  static cases::Case unloaded(const std::vector<std::string>& overrides) {
    cases::Case c = load("couplet", overrides).value;
    c.loads.clear();
    return c;
  }
  Run run_;
  Vec3 u_;
};

inline constexpr double kStiffness = Adobe::plane / 0.1,
                        kShearStiffness = Adobe::shear / 0.1;  // Pa/m: E'/(2ℓ), G/(2ℓ); the mortar has the bricks' moduli

}  // namespace voussoir::testing
