// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Rods and anchors as lines between what they hold; a broken one is gone. Bars of decks and meshes are not in the file.

/** Ends of all ties that hold at a time [s], m. @returns list of pairs of points, or null without ties */
export function tiesAt({ run, house }, t) {
  if (!run.ties) return null;
  const { ends, elements, lives } = run.ties, out = [];
  for (let i = 0; i < lives.length; ++i) {
    if (lives[i] <= t) continue;
    out.push([0, 1].map((k) => {
      const point = [...ends.subarray(6 * i + 3 * k, 6 * i + 3 * k + 3)], element = elements[2 * i + k];
      return element < 0 ? point : house.carried(element, point);
    }));
  }
  return out;
}
