// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// How much motion is magnified if nobody says: until the first joint opens, so much that it is seen; from then on not at all.

const kSeen = 0.02; // of the house's size
const kSteps = [1, 2, 5, 10, 20, 50, 100];
const kFades = 0.3; // s, in which it comes down to 1

/** A function that gives the factor at a time. @param size  of the house, m */
export function magnification(run, size) {
  const { frames, cracks, facts } = run, open = (f) => cracks.at(f).reduce((n, level) => n + (level > 0 ? 1 : 0), 0), first = open(0);
  let crack = 0;
  while (crack < frames.count && open(crack) === first) ++crack;
  const largest = frames.largest(Math.max(0, Math.min(crack, frames.count) - 1)), factor = kSteps.findLast((m) => m * largest <= kSeen * size) ?? 1;
  const from = crack < frames.count ? facts.times[crack] : Infinity;
  return (t) => (t >= from ? 1 : t > from - kFades ? factor ** ((from - t) / kFades) : factor);
}
