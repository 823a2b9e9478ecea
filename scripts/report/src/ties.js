// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Rods and anchors, and the bars of decks and meshes, as lines between what they hold; a broken one is gone.

const ends = ({ ends, elements }, i, house) => [0, 1].map((k) => {
  const point = [...ends.subarray(6 * i + 3 * k, 6 * i + 3 * k + 3)], element = elements[2 * i + k];
  return element < 0 ? point : house.carried(element, point);
});

const length = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/** Ends of all ties that hold at a time [s], m. @returns list of pairs of points */
function rodsAt({ ties }, house, t) {
  const out = [];
  for (let i = 0; i < ties.lives.length; ++i) if (ties.lives[i] > t) out.push(ends(ties, i, house));
  return out;
}

/** Ends of all bars of decks and meshes that are not longer than they can be, m: when a bar has broken is not in the file. */
function barsAt({ bars }, house) {
  const out = [];
  for (let i = 0; i < bars.breaking.length; ++i) {
    const now = ends(bars, i, house), at = 6 * i, before = length(bars.ends.subarray(at, at + 3), bars.ends.subarray(at + 3, at + 6));
    if (!(length(...now) - before > bars.breaking[i])) out.push(now);
  }
  return out;
}

/** What is to be drawn at a time [s]. @returns {{rods: number[][][], bars: number[][][]}}, or null without ties, decks and meshes */
export function tiesAt({ run, house }, t) {
  if (!run.ties && !run.bars) return null;
  return { rods: run.ties ? rodsAt(run, house, t) : [], bars: run.bars ? barsAt(run, house) : [] };
}
