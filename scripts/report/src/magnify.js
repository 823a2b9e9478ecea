// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// How much motion is magnified if nobody says: until the first joint opens, so much that it is seen; from then on not at all. Slow loading is
// about the displaced shape: there up to the largest multiplier, cracks or not; what moves more after it is magnified less.

const kSeen = 0.02; // of the house's size
const kSteps = [1, 2, 5, 10, 20, 50, 100];
const kFades = 0.3; // s, in which it comes down to 1

/** Of a run that loads slowly. @param last  frame until which the shape is to be seen as well as it can */
function ofAnalysis({ frames, facts }, size, last) {
  const seen = (f) => (kSeen * size) / (frames.largest(f) || 1e-9), factor = kSteps.findLast((m) => m <= seen(last)) ?? 1;
  let most = 0;
  const factors = facts.times.map((t, f) => {
    most = Math.max(most, frames.largest(f, f));
    return Math.max(1, Math.min(factor, (kSeen * size) / (most || 1e-9)));
  });
  return (t) => factors[Math.max(0, facts.times.findLastIndex((x) => x <= t + 1e-9))];
}

/** A function that gives the factor at a time. @param size  of the house, m */
export function magnification(run, size) {
  const { frames, cracks, facts } = run, open = (f) => cracks.at(f).reduce((n, level) => n + (level > 0 ? 1 : 0), 0), first = open(0);
  const peak = facts.capacity?.kind === "cyclic" ? Infinity : facts.capacity?.multiplier_time;
  if (peak !== undefined && frames.count > 0) return ofAnalysis(run, size, Math.max(0, facts.times.findLastIndex((t) => t <= peak)));
  let crack = 0;
  while (crack < frames.count && open(crack) === first) ++crack;
  const largest = frames.largest(Math.max(0, Math.min(crack, frames.count) - 1)), factor = kSteps.findLast((m) => m * largest <= kSeen * size) ?? 1;
  const from = crack < frames.count ? facts.times[crack] : Infinity;
  return (t) => (t >= from ? 1 : t > from - kFades ? factor ** ((from - t) / kFades) : factor);
}
