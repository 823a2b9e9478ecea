// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The data in the page; io/output/report/report_data.h and io/output/report/report_frames.h say how they are packed.

import { Modes } from "./modes.js";

async function inflate(id) {
  const element = document.getElementById(id);
  const text = atob(element.textContent);
  element.remove(); // the text is large and no longer needed
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

/** Adds up the steps of packed frames; positions are those of the run within half a quantum. */
export class Frames {
  constructor(buffer, count, centroids, quantum, shifts) {
    const n = centroids.length / 3;
    Object.assign(this, { n, count, centroids, quantum, shifts });
    const packed = new Uint8Array(buffer);
    this.values = new Int16Array(7 * n * count); // a frame: dx, dy, dz, w, x, y, z of all elements, one after the other
    this.brokenBytes = new Uint8Array(n * count);
    for (let f = 0; f < count && packed.length > 0; ++f) this.#add(packed, f);
    for (let f = 0; f < count && packed.length > 0; ++f) this.#scale(f);
    if (packed.length === 0) this.values.fill(32767, 3 * n, 4 * n); // the model alone, as it was built
  }

  #add(packed, f) {
    const { n, values, brokenBytes } = this;
    const from = 15 * n * f, to = 7 * n * f, before = to - 7 * n;
    for (let c = 0; c < 7; ++c) {
      const low = from + 2 * c * n, at = c * n;
      for (let i = 0; i < n; ++i) {
        const zigzag = packed[low + i] | (packed[low + n + i] << 8);
        values[to + at + i] = (f > 0 ? values[before + at + i] : 0) + ((zigzag >> 1) ^ -(zigzag & 1));
      }
    }
    for (let i = 0; i < n; ++i) brokenBytes[n * f + i] = (f > 0 ? brokenBytes[n * (f - 1) + i] : 0) + packed[from + 14 * n + i];
  }

  /** Quaternions in steps of 1/32767, whatever the steps were in which they came. */
  #scale(f) {
    const { n, values, shifts } = this;
    for (let c = 3, i = n * (7 * f + 3); c < 7; ++c) for (let e = 0; e < n; ++e, ++i) values[i] = Math.min(32767, values[i] << shifts[e]);
  }

  /** Component `c` of element `e` between frames; `at` is a frame number that need not be whole. */
  #between(at, c, e) {
    const f = Math.min(Math.floor(at), this.count - 1), g = Math.min(f + 1, this.count - 1), w = at - f;
    const stride = 7 * this.n, i = c * this.n + e;
    return (1 - w) * this.values[f * stride + i] + w * this.values[g * stride + i];
  }
  /** Displacement of element `e` along axis `k`, m. */
  displacement(at, e, k) { return this.quantum * this.#between(at, k, e); }
  distance(at, e) { return Math.hypot(this.displacement(at, e, 0), this.displacement(at, e, 1), this.displacement(at, e, 2)); }
  /** Largest displacement of all elements along an axis from frame `first` to frame `last`, m. */
  largest(last, first = 0) {
    let most = 0;
    for (let f = first; f <= last; ++f) {
      const from = 7 * this.n * f;
      for (let i = from; i < from + 3 * this.n; ++i) most = Math.max(most, Math.abs(this.values[i]));
    }
    return this.quantum * most;
  }
  /** Writes position and quaternion (x, y, z, w) of every element into `state`, every `stride` numbers one; displacements and rotations times
   *  `magnified`. */
  place(at, state, stride, magnified = 1) {
    const { n, values, centroids } = this, quantum = magnified * this.quantum;
    const f = Math.min(Math.floor(at), this.count - 1), g = Math.min(f + 1, this.count - 1), w = at - f, v = 1 - w;
    for (let e = 0, to = 0, a = 7 * n * f, b = 7 * n * g; e < n; ++e, ++a, ++b, to += stride) {
      for (let k = 0; k < 3; ++k) state[to + k] = centroids[3 * e + k] + quantum * (v * values[a + k * n] + w * values[b + k * n]);
      let qw = v * values[a + 3 * n] + w * values[b + 3 * n];
      let qx = v * values[a + 4 * n] + w * values[b + 4 * n], qy = v * values[a + 5 * n] + w * values[b + 5 * n], qz = v * values[a + 6 * n] + w * values[b + 6 * n];
      if (magnified !== 1) qx *= magnified, qy *= magnified, qz *= magnified; // small turns: half the angle is the length of the vector
      const length = Math.sqrt(qw * qw + qx * qx + qy * qy + qz * qz) || 1;
      state[to + 4] = qx / length, state[to + 5] = qy / length, state[to + 6] = qz / length, state[to + 7] = qw / length;
    }
  }
  /** Broken fraction of every element's bonds at the frame before, in 1/255. */
  broken(at) { return this.brokenBytes.subarray(Math.floor(at) * this.n, (Math.floor(at) + 1) * this.n); }
}

/** How wide open joints are: a level for each joint in each frame (io/output/replay/joint_cracks.h). */
class Cracks {
  constructor(elements, edges, ends, levels, count) {
    Object.assign(this, { elements, edges, ends, levels, joints: edges.length, count });
    for (let i = edges.length; i < levels.length; ++i) levels[i] += levels[i - edges.length];
  }
  /** Levels of all joints at the frame before. */
  at(at) { return this.levels.subarray(Math.floor(at) * this.joints, (Math.floor(at) + 1) * this.joints); }
}

/** Bodies that move as one: the number of each element's body in each frame, their names, hinges (io/output/report/report_bodies.h). */
class Bodies {
  constructor({ names, bodies, hinges }, ids, n) {
    Object.assign(this, { texts: names, bodies, lines: hinges, ids, n });
    for (let i = n; i < ids.length; ++i) ids[i] += ids[i - n];
  }
  at(at) { return this.ids.subarray(Math.floor(at) * this.n, (Math.floor(at) + 1) * this.n); }
  names(at) { return this.bodies[Math.floor(at)].map(([id, name]) => ({ id, name: this.texts[name] })); }
  /** Ends of hinges, and of lines along which bodies slide, where the elements are that they go with: halfway between where the two bodies take them.
   *  @param carried  where an element takes a point of the reference configuration: (element, point) => point */
  hinges(at, carried) {
    const middle = (p, elements) => elements.map((e) => carried(e, p)).reduce((a, b) => a.map((x, k) => 0.5 * (x + b[k])));
    return this.lines[Math.floor(at)].map((h) => ({ points: [middle(h.slice(0, 3), h.slice(6, 8)), middle(h.slice(3, 6), h.slice(8, 10))], slides: h[10] === 1 }));
  }
}

/** Faces of elements that no cell of the page is the shape of: rows of element, number of corners, corners. */
function loopsOf(rows) {
  const loops = new Map();
  for (let i = 0; i < rows.length; i += 2 + rows[i + 1]) {
    if (!loops.has(rows[i])) loops.set(rows[i], []);
    loops.get(rows[i]).push([...rows.subarray(i + 2, i + 2 + rows[i + 1])]);
  }
  return loops;
}

/** @param prefix  of the ids of its elements: "" the first run, "second-" the one beside it */
export async function loadRun(prefix = "") {
  const element = document.getElementById(`${prefix}facts`);
  if (!element) return null;
  const facts = JSON.parse(element.textContent);
  facts.model = facts.times.length === 0; // no frames yet
  if (facts.model) facts.times = [0];
  const get = (id) => inflate(prefix + id);
  facts.plots = JSON.parse(new TextDecoder().decode(await get("curves")));
  const run = {
    facts,
    vertices: new Float32Array(await get("vertices")),
    cells: new Int32Array(await get("cells")),
    cellTypes: new Uint8Array(await get("cell-types")),
    cellElements: new Int32Array(await get("cell-elements")),
    parts: new Int32Array(await get("parts")),
    materials: new Int32Array(await get("materials")),
    coveredElements: new Int32Array(await get("covered-elements")),
    coveredNormals: new Float32Array(await get("covered-normals")),
    openedElements: new Int32Array(await get("opened-elements")),
    openedNormals: new Float32Array(await get("opened-normals")),
    openedTimes: new Float32Array(await get("opened-times")),
  };
  if (document.getElementById(`${prefix}loops`)) run.loops = loopsOf(new Int32Array(await get("loops")));
  const centroids = new Float32Array(await get("centroids"));
  run.frames = new Frames(await get("frames"), facts.times.length, centroids, facts.quantum, new Uint8Array(await get("turn-shifts")));
  const edges = new Uint8Array(await get("crack-edges"));
  run.cracks = new Cracks(new Int32Array(await get("crack-elements")), edges, new Float32Array(await get("crack-ends")), facts.model ? new Uint8Array(edges.length) : new Uint8Array(await get("crack-levels")), facts.times.length);
  const modes = document.getElementById(`${prefix}modes`);
  if (modes) run.modes = new Modes(JSON.parse(modes.textContent), new Int16Array(await get("mode-shapes")), centroids);
  const model = document.getElementById(`${prefix}model`);
  if (model) Object.assign(run, { model: JSON.parse(model.textContent), fixed: new Uint8Array(await get("fixed")), lawOf: new Uint8Array(await get("joint-laws")), lawEnds: new Float32Array(await get("joint-ends")) });
  if (document.getElementById(`${prefix}loads`)) run.loads = JSON.parse(new TextDecoder().decode(await get("loads")));
  if (document.getElementById(`${prefix}tie-ends`)) run.ties = { ends: new Float32Array(await get("tie-ends")), elements: new Int32Array(await get("tie-elements")), lives: new Float32Array(await get("tie-lives")) };
  if (document.getElementById(`${prefix}mesh-bar-ends`)) run.bars = { ends: new Float32Array(await get("mesh-bar-ends")), elements: new Int32Array(await get("mesh-bar-elements")), breaking: new Float32Array(await get("mesh-bar-breaking")) };
  if (document.getElementById(`${prefix}crack-list`)) run.crackList = JSON.parse(new TextDecoder().decode(await get("crack-list")));
  const bodies = document.getElementById(`${prefix}bodies`);
  if (bodies && !facts.model) run.frames.bodies = new Bodies(JSON.parse(bodies.textContent), new Uint8Array(await get("body-ids")), run.frames.n);
  return run;
}
