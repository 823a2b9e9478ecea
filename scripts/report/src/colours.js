// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What the colours of elements mean.
import { Color } from "three";

const linear = (hex) => new Color(hex).toArray();
const css = (hex) => "#" + hex.toString(16).padStart(6, "0");
const mix = (a, b, w) => [a[0] + (b[0] - a[0]) * w, a[1] + (b[1] - a[1]) * w, a[2] + (b[2] - a[2]) * w];

const kIntact = 0xe4e2dc, kBroken = 0xc8201a, kStill = 0xf2f0e6, kFar = 0x08407c;
const kParts = [0xd9c7a3, 0x8fb3c9, 0xb5cf9a, 0xe0a58c, 0x8c6239, 0xc6a4cf, 0xe3d06f, 0x9a9a9a];
const kLongest = 1; // m; displacements beyond have the last colour

/** {of: (frame, element) => linear [r, g, b], legend: HTML} by the name of the choice. */
export function colourings({ frames, parts, facts }) {
  const intact = linear(kIntact), broken = linear(kBroken), still = linear(kStill), far = linear(kFar), of = kParts.map(linear);
  const bar = (from, to, low, high) => `${low}<span class="bar" style="background:linear-gradient(90deg,${css(from)},${css(to)})"></span>${high}`;
  const chip = (name, i) => Object.assign(document.createElement("span"), { textContent: name }).outerHTML.replace(/^/, `<span class="chip" style="background:${css(kParts[i % kParts.length])}"></span>`);
  return {
    broken: { of: (f, e) => mix(intact, broken, frames.broken(f, e)), legend: bar(kIntact, kBroken, "no bond broken", "all") },
    displacement: {
      of: (f, e) => mix(still, far, Math.sqrt(Math.min(1, frames.distance(f, e) / kLongest))),
      legend: bar(kStill, kFar, "displacement 0", `${kLongest} m and more (by its root)`),
    },
    part: { of: (f, e) => of[parts[e] % of.length], legend: facts.parts.map(chip).join("") },
  };
}
