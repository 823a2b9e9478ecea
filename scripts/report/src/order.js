// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Which faces are drawn, and in which order: those that look at the camera and are not inside a wall, of near elements first. Where the
// processor draws, a frame takes as long as it has triangles, more than pixels: about a microsecond each. A face inside a wall is left out until
// its joint is so wide open that one could look in.
import { BufferAttribute, DynamicDrawUsage } from "three";
import { kStride } from "./brick.js";
import { HiddenFaces } from "./hidden.js";

const kLayers = 1024; // of depth: elements of one are in no order
const kNear = 4; // m: from here on, a joint that is not yet as wide as faces need to show (shapes.js: opened) is no wider than a pixel

export class FaceOrder {
  /** @param faces  of all elements: {index: corners of their triangles, start: the first of each face and the end, plane: normal and distance
   *  from the centroid of each face, first: the first face of each element and the end, covered: 1 for faces that joints cover, opened: when
   *  one of these joints is wide open, s} */
  constructor(geometry, faces) {
    const n = faces.first.length - 1;
    Object.assign(this, { geometry, faces, n, distance: new Float32Array(n), sorted: new Uint32Array(n), ends: new Uint32Array(kLayers + 1), seen: new Uint8Array(faces.start.length) });
    this.others = new HiddenFaces(geometry.getAttribute("position").array);
    // `seen`: 1 for faces that are drawn; the last stands for a face that always is
    this.index = new BufferAttribute(new Uint32Array(faces.index.length), 1).setUsage(DynamicDrawUsage);
    geometry.setIndex(this.index);
  }

  /** Elements from the nearest to the farthest, layer by layer. */
  #sort(state, eye) {
    const { n, distance, sorted, ends } = this;
    let low = Infinity, high = 0;
    for (let e = 0, at = 0; e < n; ++e, at += kStride) {
      const x = state[at] - eye.x, y = state[at + 1] - eye.y, z = state[at + 2] - eye.z;
      distance[e] = Math.sqrt(x * x + y * y + z * z);
      low = Math.min(low, distance[e]); // as it is kept, rounded: no element is nearer than the nearest
      high = Math.max(high, distance[e]);
    }
    const scale = (kLayers - 1) / (high - low || 1), layer = (e) => Math.floor((distance[e] - low) * scale);
    ends.fill(0);
    for (let e = 0; e < n; ++e) ++ends[layer(e) + 1];
    for (let k = 1; k <= kLayers; ++k) ends[k] += ends[k - 1];
    for (let e = 0; e < n; ++e) sorted[ends[layer(e)]++] = e;
  }

  /** Orders anew for elements that are where `state` says (brick.js), of which `broken` bonds are gone (0: none), and a camera at `eye`.
   *  @param now  s; infinity: all faces on which a bond is gone are drawn  @param hidden  1 an element that is not drawn  @param inside  whether
   *  faces inside an intact wall are drawn, too: some of it is hidden  @param coarse  null; or {camera, width, height: of the canvas}: faces
   *  that others hide are left out (hidden.js); returns which part of the faces these are */
  update(state, broken, eye, now, hidden, inside, coarse) {
    this.#sort(state, eye);
    const { others } = this;
    if (coarse) others.begin(coarse.camera, coarse.width, coarse.height);
    const { index, start, plane, first, covered, opened } = this.faces, to = this.index.array;
    let count = 0, looked = 0, found = 0;
    this.seen.fill(0);
    this.seen[this.seen.length - 1] = 1;
    for (const e of this.sorted) {
      if (hidden[e]) continue;
      const at = kStride * e, qx = -state[at + 4], qy = -state[at + 5], qz = -state[at + 6], qw = state[at + 7];
      const x = eye.x - state[at], y = eye.y - state[at + 1], z = eye.z - state[at + 2];
      // the eye as the element sees it: v + 2 q × (q × v + w v), with the quaternion turned back
      const tx = qy * z - qz * y + qw * x, ty = qz * x - qx * z + qw * y, tz = qx * y - qy * x + qw * z;
      const ex = x + 2 * (qy * tz - qz * ty), ey = y + 2 * (qz * tx - qx * tz), ez = z + 2 * (qx * ty - qy * tx);
      if (coarse) others.element(state, at);
      const whole = broken[e] === 0 && !inside, until = inside || this.distance[e] < kNear ? Infinity : now;
      for (let f = first[e]; f < first[e + 1]; ++f) {
        if (covered[f] && (whole || opened[f] > until)) continue;
        if (plane[4 * f] * ex + plane[4 * f + 1] * ey + plane[4 * f + 2] * ez <= plane[4 * f + 3]) continue;
        ++looked;
        if (coarse && !others.face(index, start[f], start[f + 1])) continue;
        ++found;
        this.seen[f] = 1;
        for (let i = start[f]; i < start[f + 1]; ++i) to[count++] = index[i];
      }
    }
    this.geometry.setDrawRange(0, count);
    this.index.clearUpdateRanges();
    this.index.addUpdateRange(0, count);
    this.index.needsUpdate = true;
    return 1 - found / Math.max(1, looked);
  }
}
