// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What the colours of elements mean.
import { kColour, kStride } from "./brick.js";

/** Red, green and blue from 0 to 1, as the screen shows them (sRGB). */
const rgb = (hex) => [hex >> 16, (hex >> 8) & 255, hex & 255].map((c) => c / 255);
const css = (hex) => "#" + hex.toString(16).padStart(6, "0");
/** 256 colours from one to another, three numbers each. */
const ramp = (a, b) => Float32Array.from({ length: 768 }, (_, i) => a[i % 3] + ((b[i % 3] - a[i % 3]) * Math.floor(i / 3)) / 255);

const kIntact = 0xe4e2dc, kBroken = 0xc8201a, kStill = 0xf2f0e6, kFar = 0x08407c;
const kParts = [
  0xd9c7a3, 0x8fb3c9, 0xb5cf9a, 0xe0a58c, 0x8c6239, 0xc6a4cf, 0xe3d06f, 0x9a9a9a, 0x4f7f8f, 0x6f8f4f, 0xb5654a, 0x5c4a72, 0xc9b037, 0x4d4d4d, 0xf2c6d0, 0x7fd1c2,
]; // a house has up to thirteen
const kLongest = 1; // m; displacements beyond have the last colour

/** Of faces on which a joint has come open. */
export const kRed = rgb(kBroken);

/** {opened: whether faces that have come open are red, paint: writes the colours of all elements at a frame into the state of brick.js, legend: HTML} by the name of the choice. */
export function colourings({ frames, parts, facts }) {
  const damage = ramp(rgb(kIntact), rgb(kBroken)), way = ramp(rgb(kStill), rgb(kFar)), of = kParts.map(rgb);
  const paint = (state, e, colours, i) => {
    for (let k = 0; k < 3; ++k) state[kStride * e + kColour + k] = colours[3 * i + k];
  };
  const bar = (from, to, low, high) => `${low}<span class="bar" style="background:linear-gradient(90deg,${css(from)},${css(to)})"></span>${high}`;
  const chip = (name, i) => Object.assign(document.createElement("span"), { textContent: name }).outerHTML.replace(/^/, `<span class="chip" style="background:${css(kParts[i % kParts.length])}"></span>`);
  const sample = (hex, name) => `<span class="chip" style="background:${css(hex)}"></span>${name}`;
  return {
    faces: {
      opened: true,
      paint: (at, state) => parts.forEach((_, e) => paint(state, e, damage, 0)),
      legend: sample(kBroken, "a joint on the face has come open by half") + sample(kIntact, "not"),
    },
    broken: {
      paint: (at, state) => frames.broken(at).forEach((byte, e) => paint(state, e, damage, byte)),
      legend: bar(kIntact, kBroken, "no bond broken", "all"),
    },
    displacement: {
      paint(at, state) {
        for (let e = 0; e < frames.n; ++e) paint(state, e, way, Math.round(255 * Math.sqrt(Math.min(1, frames.distance(at, e) / kLongest))));
      },
      legend: bar(kStill, kFar, "displacement 0", `${kLongest} m and more (by its root)`),
    },
    part: { paint: (at, state) => parts.forEach((part, e) => paint(state, e, of[part % of.length], 0)), legend: facts.parts.map(chip).join("") },
  };
}
