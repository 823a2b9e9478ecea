// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The faces of all elements, each about its centroid.
import { BufferGeometry, Float32BufferAttribute } from "three";

const kNever = 3e38; // s

// Faces of VTK's hexahedron (12) and wedge (13), outward.
const kFaces = {
  12: [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
  13: [[0, 1, 2], [3, 5, 4], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]],
};

/** Outer faces of an element as lists of corners from its centroid. */
function outline(run, cells, e) {
  const at = (v) => [0, 1, 2].map((k) => run.vertices[3 * v + k] - run.frames.centroids[3 * e + k]);
  if (run.loops?.has(e)) return run.loops.get(e).map((loop) => loop.map(at)); // of several cells: its faces as they are
  const faces = new Map(); // a face that two cells share is inside
  for (const c of cells) {
    for (const face of kFaces[run.cellTypes[c]]) {
      const corners = face.map((k) => run.cells[8 * c + k]);
      const key = [...corners].sort((a, b) => a - b).join();
      if (!faces.delete(key)) faces.set(key, corners);
    }
  }
  return [...faces.values()].map((face) => face.map(at));
}

/** Writes value(i) for each face that is the i-th of those named by their element and their normal. */
function mark(to, elements, normals, value, first, plane) {
  elements.forEach((e, i) => {
    const x = normals[3 * i], y = normals[3 * i + 1], z = normals[3 * i + 2];
    for (let f = first[e]; f < first[e + 1]; ++f) if (plane[4 * f] * x + plane[4 * f + 1] * y + plane[4 * f + 2] * z > 0.9999) to[f] = value(i);
  });
  return to;
}

const kSquare = [[-1, -1], [1, -1], [1, 1], [-1, 1]];

/** Appends a face, which is convex. `across` tells where edges are: there one of its two numbers is 1 or -1 (see brick.js). */
function addFace(face, to) {
  const first = to.points.length / 3;
  to.points.push(...face.flat());
  if (face.length === 4) {
    to.across.push(...kSquare.flat());
    to.index.push(first, first + 1, first + 2, first, first + 2, first + 3);
    return;
  }
  const middle = first + face.length; // a fan about it
  to.points.push(...[0, 1, 2].map((k) => face.reduce((sum, p) => sum + p[k], 0) / face.length));
  face.forEach((_, i) => {
    to.across.push(1, 0);
    to.index.push(middle, first + i, first + ((i + 1) % face.length));
  });
  to.across.push(0, 0);
}

/** Unit normal of a convex face, and its distance from the centroid along it. */
function planeOf(face) {
  const [a, b, c] = face, u = a.map((_, k) => b[k] - a[k]), v = a.map((_, k) => c[k] - a[k]);
  const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...normal), unit = normal.map((x) => x / length);
  return [...unit, unit[0] * a[0] + unit[1] * a[1] + unit[2] * a[2]];
}

/** {geometry, faces, extent}: all elements as one geometry, each about its centroid; its faces as FaceOrder wants them; and six numbers an
 *  element: its lowest and highest corner. */
export function allShapes(run) {
  const n = run.frames.n, to = { points: [], across: [], index: [] }, element = [], extent = new Float32Array(6 * n);
  const start = [0], plane = [], first = [0], faceOf = [];
  const cellsOf = Array.from({ length: n }, () => []);
  run.cellElements.forEach((e, c) => cellsOf[e].push(c));
  cellsOf.forEach((cells, e) => {
    const faces = outline(run, cells, e), corners = faces.flat();
    for (const face of faces) {
      addFace(face, to);
      while (faceOf.length < to.points.length / 3) faceOf.push(start.length - 1);
      start.push(to.index.length);
      plane.push(...planeOf(face));
    }
    first.push(start.length - 1);
    while (element.length < to.points.length / 3) element.push(e);
    for (let k = 0; k < 3; ++k) {
      extent[6 * e + k] = Math.min(...corners.map((p) => p[k]));
      extent[6 * e + 3 + k] = Math.max(...corners.map((p) => p[k]));
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(to.points, 3));
  geometry.setAttribute("across", new Float32BufferAttribute(to.across, 2));
  geometry.setAttribute("element", new Float32BufferAttribute(element, 1));
  const count = plane.length / 4;
  const opened = mark(new Float32Array(count).fill(kNever), run.openedElements, run.openedNormals, (i) => run.openedTimes[i], first, plane);
  geometry.setAttribute("opened", new Float32BufferAttribute(faceOf.map((f) => opened[f]), 1));
  geometry.setIndex(to.index);
  geometry.computeVertexNormals(); // faces share no vertices, so they stay flat
  const faces = { index: Uint32Array.from(to.index), start: Uint32Array.from(start), plane: Float32Array.from(plane), first: Uint32Array.from(first), covered: mark(new Uint8Array(count), run.coveredElements, run.coveredNormals, () => 1, first, plane), opened };
  return { geometry, faces, extent };
}
