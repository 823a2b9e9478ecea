// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What the colours of elements mean. Red is for cracks and broken faces alone.
import { kColour, kStride } from "./brick.js";
import { kClasses } from "./cracks.js";

/** Red, green and blue from 0 to 1, as the screen shows them (sRGB). */
export const rgb = (hex) => [hex >> 16, (hex >> 8) & 255, hex & 255].map((c) => c / 255);
export const css = (hex) => "#" + hex.toString(16).padStart(6, "0");
/** 256 colours from one to another, three numbers each. */
const ramp = (a, b) => Float32Array.from({ length: 768 }, (_, i) => a[i % 3] + ((b[i % 3] - a[i % 3]) * Math.floor(i / 3)) / 255);

const kIntact = 0xe4e2dc, kBroken = 0xd31515, kStill = 0xf2f0e6, kFar = 0x08407c, kPale = 0xf4f2ee;
const kParts = [
  0xd9c7a3, 0x8fb3c9, 0xb5cf9a, 0xe0b48c, 0x8c6239, 0xc6a4cf, 0xe3d06f, 0x9a9a9a, 0x4f7f8f, 0x6f8f4f, 0xa5805a, 0x5c4a72, 0xc9b037, 0x4d4d4d, 0xd8c6d8, 0x7fd1c2,
]; // a house has up to thirteen
const kBodies = [0x4c78a8, 0xf2b134, 0x59a14f, 0x9467bd, 0x17a2a8, 0x8c6d31, 0xe7a1c4, 0x6b8ba4, 0xa3c96b, 0x3d5a80, 0xd9bf77, 0x7b6888];
const kMaterials = [[/wood|timber|beam/i, 0x8a5f38], [/adobe|earth|mud/i, 0xcbb389], [/brick|clay/i, 0xb98d70], [/concrete|ring/i, 0xa9adb0], [/stone/i, 0xb4b1a8], [/soft/i, 0xd6cda8]];
const kOthers = [0xbfb8a5, 0x9fb0ba, 0xa8b59a, 0xb9a8b5];
const kNamed = 6; // bodies in the legend
const kLongest = 1; // m; displacements beyond have the last colour

const kLaws = [0x777777, 0x1f77b4, 0xd95f02, 0x1b9e77, 0x7570b3, 0xc51b7d, 0x66a61e, 0xa6761d];
const kFixed = 0x55585c, kFree = 0xe4dcc8, kFault = kBroken;
/** Red, green and blue of a row of /model/law; 0 is dry. */
export const lawColour = (law) => rgb(kLaws[law % kLaws.length]);

/** Of cracks, and of faces on which a joint has come open. */
export const kRed = rgb(kBroken);
const colourOf = (name, i) => (kMaterials.find(([known]) => known.test(name)) ?? [0, kOthers[i % kOthers.length]])[1];
export const bodyColour = (id) => kBodies[(id - 1) % kBodies.length];

const mm = (x) => (x === 0 ? "< 0.1 mm" : `≥ ${x} mm`);
const lines = () => [{ head: "joint open" }, ...kClasses.map((c) => ({ line: c.pixels, strength: c.strength, colour: css(kBroken), text: mm(c.mm) }))];
const chip = (hex, text) => ({ chip: css(hex), text });
const bar = (from, to, low, high) => ({ from: css(from), to: css(to), low, high });

/** By the name of the choice: {opened: whether faces that have come open are red, lines: whether cracks are drawn, edges: how dark bricks are
 *  outlined, steady: whether colours are the same in all frames, paint: writes the colours of all elements at a frame into the state of brick.js, legend: entries for legend.js}. */
export function colourings({ frames, parts, materials, facts, model, fixed }) {
  const damage = ramp(rgb(kIntact), rgb(kBroken)), way = ramp(rgb(kStill), rgb(kFar)), of = kParts.map(rgb), body = kBodies.map(rgb);
  const stuff = facts.materials.map((name, i) => rgb(colourOf(name, i))), pale = rgb(kPale), grey = rgb(kIntact);
  const paint = (state, e, colours, i) => {
    for (let k = 0; k < 3; ++k) state[kStride * e + kColour + k] = colours[3 * i + k];
  };
  const used = [...new Set(materials)].sort((a, b) => a - b);
  const shows = chip(kBroken, "broken face, once 5 mm open");
  const all = {
    cracks: {
      opened: true, lines: true, steady: true, edges: 0.22,
      paint: (at, state) => materials.forEach((m, e) => paint(state, e, stuff[m], 0)),
      legend: () => [...lines(), shows, ...used.map((m) => chip(colourOf(facts.materials[m], m), facts.materials[m]))],
    },
    only: {
      opened: true, lines: true, steady: true, edges: 0.05,
      paint: (at, state) => materials.forEach((_, e) => paint(state, e, pale, 0)),
      legend: () => [...lines(), shows],
    },
    broken: {
      edges: 0.35,
      paint: (at, state) => frames.broken(at).forEach((byte, e) => paint(state, e, damage, byte)),
      legend: () => [bar(kIntact, kBroken, "no bond broken", "all")],
    },
    displacement: {
      edges: 0.35,
      paint(at, state) {
        for (let e = 0; e < frames.n; ++e) paint(state, e, way, Math.round(255 * Math.sqrt(Math.min(1, frames.distance(at, e) / kLongest))));
      },
      legend: () => [bar(kStill, kFar, "displacement 0", `${kLongest} m and more (by its root)`)],
    },
    part: { edges: 0.35, lines: true, steady: true, paint: (at, state) => parts.forEach((part, e) => paint(state, e, of[part % of.length], 0)), legend: () => facts.parts.map((name, i) => chip(kParts[i % kParts.length], name)) },
  };
  if (model) {
    const faults = new Set(model.faults ?? []), at_fault = rgb(kFault), held = rgb(kFixed), free = rgb(kFree);
    const marked = (entries) => (faults.size > 0 ? [chip(kFault, "at fault"), ...entries] : entries);
    const laws = model.laws.map(({ name, joints }, i) => ({ line: 2, strength: 1, colour: css(kLaws[i % kLaws.length]), text: `${name}: ${joints}`, joints })).filter(({ joints }) => joints > 0);
    all.material = { steady: true, edges: 0.3, paint: (at, state) => materials.forEach((m, e) => (faults.has(e) ? paint(state, e, at_fault, 0) : paint(state, e, stuff[m], 0))), legend: () => marked(used.map((m) => chip(colourOf(facts.materials[m], m), facts.materials[m]))) };
    all.law = { steady: true, edges: 0.05, laws: true, paint: (at, state) => materials.forEach((_, e) => paint(state, e, faults.has(e) ? at_fault : pale, 0)), legend: () => marked([{ head: "joints by law" }, ...laws]) };
    all.support = { steady: true, edges: 0.3, paint: (at, state) => materials.forEach((_, e) => paint(state, e, faults.has(e) ? at_fault : fixed[e] ? held : free, 0)), legend: () => marked([chip(kFixed, "fixed"), chip(kFree, "free to move")]) };
  }
  if (frames.bodies) {
    all.bodies = {
      edges: 0.2, lines: true,
      paint: (at, state) => frames.bodies.at(at).forEach((id, e) => paint(state, e, id === 0 ? grey : body[(id - 1) % body.length], 0)),
      legend: (at) => {
        const count = new Map(), all = frames.bodies.names(at);
        for (const id of frames.bodies.at(at)) count.set(id, (count.get(id) ?? 0) + 1);
        const large = all.sort((a, b) => count.get(b.id) - count.get(a.id)).slice(0, kNamed).map(({ id, name }) => chip(bodyColour(id), name));
        return [...large, ...(all.length > kNamed ? [{ head: `and ${all.length - kNamed} smaller` }] : []), chip(kIntact, "loose")];
      },
    };
  }
  return all;
}
