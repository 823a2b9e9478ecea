// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Open joints as lines along their edges, between the two bricks: the wider the joint, the wider and stronger the line. A line has a width in
// pixels, so that a crack of a tenth of a millimetre is seen from twenty metres; once the joint is wider than that, it is as wide as the joint.
import { BufferAttribute, BufferGeometry, DataTexture, DoubleSide, DynamicDrawUsage, Mesh, RedFormat, ShaderMaterial, UnsignedByteType } from "three";
import { kPlaced } from "./brick.js";

const kRow = 1024; // joints in a row of the texture of levels
const kApart = 10; // level from which on bricks are apart: their faces show, and no line joins them

/** Classes of the legend: from `level` (io/output/replay/joint_cracks.h) on, `pixels` wide, red to this part, from this width in mm on. */
export const kClasses = [
  { level: 1, pixels: 1.8, strength: 0.7, mm: 0 },
  { level: 3, pixels: 2.5, strength: 0.85, mm: 0.1 },
  { level: 6, pixels: 3.4, strength: 1, mm: 1 },
  { level: 8, pixels: 4.4, strength: 1, mm: 5 },
];
const chosen = (key) => kClasses.slice(1).reduce((below, c) => `(level >= ${(c.level - 0.5).toFixed(1)} ? ${c[key].toFixed(2)} : ${below})`, kClasses[0][key].toFixed(2));

const kVertex = `
attribute vec3 fromB, otherA, otherB;  // this end and the other end, from the centroids of the two elements
attribute vec4 which;                  // the elements, the side of the line (1, -1; 2, -2 at its other end), the joint
uniform highp sampler2D levels;
uniform vec2 pixels;                   // of the picture
uniform float scale;                   // of all widths
varying float vAcross;
flat varying float vHalf, vStrength;
${kPlaced}
void main() {
  int j = int(which.w + 0.5);
  float level = 255.0 * texelFetch(levels, ivec2(j % ${kRow}, j / ${kRow}), 0).r;
  ivec2 atA = stateOf(which.x), atB = stateOf(which.y);
  vec4 turnA = texelFetch(state, atA + ivec2(1, 0), 0), turnB = texelFetch(state, atB + ivec2(1, 0), 0);
  vec3 middleA = texelFetch(state, atA, 0).xyz, middleB = texelFetch(state, atB, 0).xyz;
  vec3 a = middleA + turned(turnA, position), b = middleB + turned(turnB, fromB);
  vec4 here = viewMatrix * vec4(0.5 * (a + b), 1.0);
  vec4 there = viewMatrix * vec4(0.5 * (middleA + middleB + turned(turnA, otherA) + turned(turnB, otherB)), 1.0);
  here.xyz *= 1.0 - 0.03 / length(here.xyz);  // nearer by 3 cm: the bricks do not hide their own edges
  there.xyz *= 1.0 - 0.03 / length(there.xyz);
  there.z = min(there.z, -0.01);
  vec4 p = projectionMatrix * here, q = projectionMatrix * there;
  float open = length(a - b) * projectionMatrix[1][1] * 0.5 * pixels.y / p.w;
  float width = max(scale * ${chosen("pixels")}, min(open, 8.0 * scale));
  vStrength = ${chosen("strength")};
  vHalf = 0.5 * width;
  vec2 along = (q.xy / q.w - p.xy / p.w) * pixels;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  float reach = vHalf + 0.5;  // half a pixel more, over which the line fades
  float left = sign(which.z);
  vAcross = (abs(which.z) > 1.5 ? -left : left) * reach;  // along runs the other way at the other end
  p.xy += (left * vec2(-along.y, along.x) - 0.3 * along) * reach * 2.0 / pixels * p.w;
  gl_Position = p;
}`;

const kFragment = `
uniform vec3 red;
varying float vAcross;
flat varying float vHalf, vStrength;
void main() { gl_FragColor = vec4(red, vStrength * clamp(vHalf + 0.5 - abs(vAcross), 0.0, 1.0)); }`;

/** Lines of all joints: {position, fromB, otherA, otherB, which} and `first`, the first edge of each joint and the end. */
function lines({ cracks, frames }) {
  const { elements, ends, joints } = cracks, edges = ends.length / 6;
  const out = { position: new Float32Array(12 * edges), fromB: new Float32Array(12 * edges), otherA: new Float32Array(12 * edges), otherB: new Float32Array(12 * edges), which: new Float32Array(16 * edges), first: new Uint32Array(joints + 1) };
  const put = (to, v, point, element) => {
    for (let k = 0; k < 3; ++k) to[3 * v + k] = ends[3 * point + k] - (element < 0 ? 0 : frames.centroids[3 * element + k]);
  };
  let edge = 0;
  for (let j = 0; j < joints; ++j) {
    out.first[j] = edge;
    const a = elements[2 * j], b = elements[2 * j + 1];
    for (let last = edge + cracks.edges[j]; edge < last; ++edge) {
      for (let k = 0; k < 4; ++k) {
        const v = 4 * edge + k, here = 2 * edge + (k >> 1), there = 2 * edge + 1 - (k >> 1);
        put(out.position, v, here, a), put(out.fromB, v, here, b), put(out.otherA, v, there, a), put(out.otherB, v, there, b);
        out.which.set([a, b < 0 ? frames.n : b, ((k >> 1) ^ (k & 1) ? 1 : -1) * (1 + (k >> 1)), j], 4 * v);
      }
    }
  }
  out.first[joints] = edge;
  return out;
}

/** Two faces an edge, on which its line lies: of its first element and of its second, or twice of one of them; where neither has one, the
 *  number of all faces. @param faces  as FaceOrder wants them */
function facesOf({ cracks, frames }, { plane, first }) {
  const { elements, ends, joints } = cracks, all = plane.length / 4, out = new Uint32Array(ends.length / 3), kNear = 1e-4; // m
  const on = (f, e, edge) => [0, 1].every((end) => {
    const distance = [0, 1, 2].reduce((d, k) => d + plane[4 * f + k] * (ends[6 * edge + 3 * end + k] - frames.centroids[3 * e + k]), -plane[4 * f + 3]);
    return Math.abs(distance) < kNear;
  });
  const along = (e, edge) => {
    const found = [];
    for (let f = e < 0 ? 0 : first[e]; e >= 0 && f < first[e + 1]; ++f) if (on(f, e, edge)) found.push(f);
    return found;
  };
  const opposite = (f, g) => plane[4 * f] * plane[4 * g] + plane[4 * f + 1] * plane[4 * g + 1] + plane[4 * f + 2] * plane[4 * g + 2] < -0.999;
  for (let j = 0, edge = 0; j < joints; ++j) {
    for (const last = edge + cracks.edges[j]; edge < last; ++edge) {
      const ofA = along(elements[2 * j], edge), ofB = along(elements[2 * j + 1], edge); // among them the two that met: these are opposite
      const a = ofA.find((f) => !ofB.some((g) => opposite(f, g)));
      const b = elements[2 * j + 1] < 0 ? ofA.at(-1) : ofB.find((f) => !ofA.some((g) => opposite(f, g))); // on the base, either of the first
      out[2 * edge] = a ?? b ?? all, out[2 * edge + 1] = b ?? a ?? all;
    }
  }
  return out;
}

export class CrackLines {
  /** @param faces  of the elements, as FaceOrder wants them */
  constructor(run, state, red, faces) {
    this.cracks = run.cracks;
    this.faces = facesOf(run, faces);
    const all = lines(run), geometry = (this.geometry = new BufferGeometry());
    this.first = all.first;
    for (const name of ["position", "fromB", "otherA", "otherB"]) geometry.setAttribute(name, new BufferAttribute(all[name], 3));
    geometry.setAttribute("which", new BufferAttribute(all.which, 4));
    this.index = new BufferAttribute(new Uint32Array(6 * all.first.at(-1)), 1).setUsage(DynamicDrawUsage);
    geometry.setIndex(this.index);
    const rows = Math.max(1, Math.ceil(this.cracks.joints / kRow));
    this.levels = new DataTexture(new Uint8Array(kRow * rows), kRow, rows, RedFormat, UnsignedByteType);
    this.material = new ShaderMaterial({
      uniforms: { state: { value: state }, levels: { value: this.levels }, pixels: { value: [1, 1] }, scale: { value: 1 }, red: { value: red } },
      vertexShader: kVertex, fragmentShader: kFragment, transparent: true, depthWrite: false, side: DoubleSide });
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
    this.shown = 0;
  }

  /** Lines of frame `at`, none of hidden elements nor on faces that look away; the strongest last, on top. @param hidden  1 an element that is
   *  not drawn  @param seen  1 a face that is drawn (FaceOrder) */
  update(at, hidden, seen) {
    const { elements, joints } = this.cracks, levels = this.cracks.at(at), to = this.index.array, { first, faces } = this;
    if (this.written !== Math.floor(at)) {
      this.levels.image.data.set(levels);
      this.levels.needsUpdate = true;
      this.written = Math.floor(at);
    }
    let count = 0;
    for (let k = 0; k < kClasses.length; ++k) {
      const from = kClasses[k].level, until = kClasses[k + 1]?.level ?? kApart;
      for (let j = 0; j < joints; ++j) {
        if (levels[j] < from || levels[j] >= until || hidden[elements[2 * j]] || hidden[elements[2 * j + 1]]) continue;
        for (let e = first[j]; e < first[j + 1]; ++e) {
          if (!seen[faces[2 * e]] && !seen[faces[2 * e + 1]]) continue;
          const v = 4 * e;
          to[count++] = v, to[count++] = v + 1, to[count++] = v + 2, to[count++] = v + 2, to[count++] = v + 1, to[count++] = v + 3;
        }
      }
    }
    this.geometry.setDrawRange(0, count);
    this.index.clearUpdateRanges();
    this.index.addUpdateRange(0, count);
    this.index.needsUpdate = true;
    this.shown = count / 6;
  }
}
