// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The forces of loads at the moment shown (io/output/report/damage/report_loads.h): their arrows, as long as the force is large.

const kLongest = 0.16; // of the house's size: the arrow of the largest force of the run

const size = ([, , , , x, y, z]) => Math.hypot(x, y, z);
/** "1.2 kN", "350 N" */
const words = (n) => (n >= 1e6 ? `${+(n / 1e6).toPrecision(3)} MN` : n >= 1e3 ? `${+(n / 1e3).toPrecision(3)} kN` : `${+n.toPrecision(3)} N`);

/** For each load that acts now: {from, to: ends of its arrow, whose head is where it acts, m; text}. */
export function loadsAt({ run, house }) {
  if (!run.loads) return null;
  run.mostLoad ??= run.loads.flatMap(({ frames }) => frames).reduce((most, f) => (f ? Math.max(most, size(f)) : most), 0);
  return run.loads.flatMap(({ name, frames }) => {
    const f = frames[Math.min(Math.floor(house.at), frames.length - 1)];
    if (!f) return [];
    const to = house.carried(f[0], f.slice(1, 4)), long = Math.max(0.25, size(f) / run.mostLoad) * kLongest * house.size;
    return [{ from: to.map((x, k) => x - (long * f[4 + k]) / size(f)), to, text: `${name}: ${words(size(f))}` }];
  });
}
