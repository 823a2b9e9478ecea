// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Which faces others hide. A coarse picture of depth, a sample every few pixels, is drawn here, from the nearest element to the farthest: a face
// that is nowhere near the front of it need not be drawn. What is seen through a gap narrower than a sample, and lies deep behind, is missed:
// only where the processor draws is this worth it, and only while it plays.
import { Matrix4 } from "three";

const kEvery = 2; // pixels to a sample, each way
const kDeep = 0.15; // m: a face so little behind the front counts as seen

export class HiddenFaces {
  /** @param points  corners of all faces, each from the centroid of its element: three numbers each */
  constructor(points) {
    Object.assign(this, { points, width: 0, height: 0, near: new Float32Array(0), view: new Matrix4(), frame: new Float64Array(12), x: [0, 0, 0], y: [0, 0, 0], w: [0, 0, 0] });
  }

  /** Begins a picture. @param width, height  of the canvas, pixels */
  begin(camera, width, height) {
    const W = Math.max(1, Math.ceil(width / kEvery)), H = Math.max(1, Math.ceil(height / kEvery));
    if (W * H !== this.near.length) this.near = new Float32Array(W * H); // 1 / depth of what is nearest; 0: nothing
    else this.near.fill(0);
    this.width = W, this.height = H;
    camera.updateMatrixWorld();
    const m = this.view.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    this.rows = [[0, 0.5 * W], [1, 0.5 * H], [3, 0]].map(([row, scale]) => [0, 4, 8, 12].map((k) => (scale > 0 ? scale * (m[row + k] + m[3 + k]) : m[row + k])));
  }

  /** The next element, at `at` in `state` (brick.js). */
  element(state, at) {
    const f = this.frame;
    const x = state[at], y = state[at + 1], z = state[at + 2], i = state[at + 4], j = state[at + 5], k = state[at + 6], r = state[at + 7];
    const xx = 1 - 2 * (j * j + k * k), yx = 2 * (i * j + k * r), zx = 2 * (i * k - j * r);
    const xy = 2 * (i * j - k * r), yy = 1 - 2 * (i * i + k * k), zy = 2 * (j * k + i * r);
    const xz = 2 * (i * k + j * r), yz = 2 * (j * k - i * r), zz = 1 - 2 * (i * i + j * j);
    for (let row = 0; row < 3; ++row) { // x and y in samples times depth, and depth
      const [a, b, c, d] = this.rows[row];
      f[4 * row] = a * xx + b * yx + c * zx;
      f[4 * row + 1] = a * xy + b * yy + c * zy;
      f[4 * row + 2] = a * xz + b * yz + c * zz;
      f[4 * row + 3] = a * x + b * y + c * z + d;
    }
  }

  /** Draws a face of it, its triangles from `index[from]` to `index[to]`; whether any of it is seen, or it lies between all samples. */
  face(index, from, to) {
    const { points, frame: f, x, y, w } = this;
    let seen = false, drawn = false;
    for (let t = from; t < to; t += 3) {
      for (let c = 0; c < 3; ++c) {
        const p = 3 * index[t + c], u = points[p], v = points[p + 1], s = points[p + 2], depth = f[8] * u + f[9] * v + f[10] * s + f[11];
        if (depth < 0.05) return true;
        w[c] = 1 / depth;
        x[c] = (f[0] * u + f[1] * v + f[2] * s + f[3]) * w[c];
        y[c] = (f[4] * u + f[5] * v + f[6] * s + f[7]) * w[c];
      }
      const now = this.#triangle();
      if (now > 0) drawn = true;
      if (now > 1) seen = true;
    }
    return seen || !drawn;
  }

  /** 0: it has no sample; 1: none that is seen; 2: one that is. */
  #triangle() {
    const { x, y, w, near, width, height } = this, ax = x[0], bx = x[1], cx = x[2], ay = y[0], by = y[1], cy = y[2];
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area === 0) return 0;
    const dx = ((w[1] - w[0]) * (cy - ay) - (w[2] - w[0]) * (by - ay)) / area, dy = ((w[2] - w[0]) * (bx - ax) - (w[1] - w[0]) * (cx - ax)) / area;
    const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)), bottom = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
    let found = 0;
    for (let row = top; row <= bottom; ++row) {
      const at = row + 0.5;
      let left = Infinity, right = -Infinity;
      for (let i = 0; i < 3; ++i) { // where its edges cross the row
        const k = i === 2 ? 0 : i + 1, y0 = y[i], y1 = y[k];
        if ((y0 < at) === (y1 < at)) continue;
        const s = x[i] + ((at - y0) / (y1 - y0)) * (x[k] - x[i]);
        if (s < left) left = s;
        if (s > right) right = s;
      }
      const first = Math.max(0, Math.ceil(left - 0.5)), last = Math.min(width - 1, Math.floor(right - 0.5));
      let depth = w[0] + dx * (first + 0.5 - ax) + dy * (at - ay);
      for (let i = row * width + first, end = row * width + last; i <= end; ++i, depth += dx) {
        const front = near[i];
        if (depth * (1 + kDeep * front) >= front) found = 2;
        else if (found === 0) found = 1;
        if (depth > front) near[i] = depth;
      }
    }
    return found;
  }
}
