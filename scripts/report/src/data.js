// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The data in the page; io/report/report_data.h and io/report/report_frames.h say how they are packed.

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
  constructor(buffer, count, centroids, quantum) {
    const n = centroids.length / 3;
    Object.assign(this, { n, count, centroids, quantum });
    const packed = new Uint8Array(buffer);
    this.values = new Int16Array(7 * n * count); // a frame: dx, dy, dz, w, x, y, z of all elements, one after the other
    this.brokenBytes = new Uint8Array(n * count);
    for (let f = 0; f < count; ++f) this.#add(packed, f);
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

  /** Component `c` of element `e` between frames; `at` is a frame number that need not be whole. */
  #between(at, c, e) {
    const f = Math.min(Math.floor(at), this.count - 1), g = Math.min(f + 1, this.count - 1), w = at - f;
    const stride = 7 * this.n, i = c * this.n + e;
    return (1 - w) * this.values[f * stride + i] + w * this.values[g * stride + i];
  }
  /** Displacement of element `e` along axis `k`, m. */
  displacement(at, e, k) { return this.quantum * this.#between(at, k, e); }
  distance(at, e) { return Math.hypot(this.displacement(at, e, 0), this.displacement(at, e, 1), this.displacement(at, e, 2)); }
  /** Writes position and quaternion (x, y, z, w) of every element into `state`, every `stride` numbers one. */
  place(at, state, stride) {
    const { n, values, centroids, quantum } = this;
    const f = Math.min(Math.floor(at), this.count - 1), g = Math.min(f + 1, this.count - 1), w = at - f, v = 1 - w;
    for (let e = 0, to = 0, a = 7 * n * f, b = 7 * n * g; e < n; ++e, ++a, ++b, to += stride) {
      for (let k = 0; k < 3; ++k) state[to + k] = centroids[3 * e + k] + quantum * (v * values[a + k * n] + w * values[b + k * n]);
      const q = (c) => v * values[a + c * n] + w * values[b + c * n];
      const qw = q(3), qx = q(4), qy = q(5), qz = q(6), length = Math.sqrt(qw * qw + qx * qx + qy * qy + qz * qz) || 1;
      state[to + 4] = qx / length, state[to + 5] = qy / length, state[to + 6] = qz / length, state[to + 7] = qw / length;
    }
  }
  /** Broken fraction of every element's bonds at the frame before, in 1/255. */
  broken(at) { return this.brokenBytes.subarray(Math.floor(at) * this.n, (Math.floor(at) + 1) * this.n); }
}

export async function loadRun() {
  const facts = JSON.parse(document.getElementById("facts").textContent);
  const run = {
    facts,
    vertices: new Float32Array(await inflate("vertices")),
    cells: new Int32Array(await inflate("cells")),
    cellTypes: new Uint8Array(await inflate("cell-types")),
    cellElements: new Int32Array(await inflate("cell-elements")),
    parts: new Int32Array(await inflate("parts")),
    coveredElements: new Int32Array(await inflate("covered-elements")),
    coveredNormals: new Float32Array(await inflate("covered-normals")),
    openedElements: new Int32Array(await inflate("opened-elements")),
    openedNormals: new Float32Array(await inflate("opened-normals")),
    openedTimes: new Float32Array(await inflate("opened-times")),
  };
  const centroids = new Float32Array(await inflate("centroids"));
  run.frames = new Frames(await inflate("frames"), facts.times.length, centroids, facts.quantum);
  return run;
}
