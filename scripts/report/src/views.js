// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// From where the house is seen.
import { Vector3 } from "three";

/** Directions to the camera. */
export const kViews = {
  corner: [1, -1.4, 0.8], rearcorner: [-1, 1.4, 0.8], front: [0, -1, 0.12], rear: [0, 1, 0.12], left: [-1, 0, 0.12], side: [1, 0, 0.12], top: [0, -0.001, 1], plan: [0, -0.001, 1],
};

/** The corner view from which most of some elements are on the near side. */
export function cornerOf(elements, centroids) {
  const middle = [0, 1].map((k) => centroids.reduce((sum, x, i) => (i % 3 === k ? sum + (3 * x) / centroids.length : sum), 0));
  const [x, y] = kViews.corner;
  const near = elements.reduce((sum, e) => sum + x * (centroids[3 * e] - middle[0]) + y * (centroids[3 * e + 1] - middle[1]), 0);
  return near < 0 ? "rearcorner" : "corner";
}

/** Puts the camera where all points (three numbers each) are just in the picture, seen from a direction; returns what it looks at. */
export function fit(camera, direction, points, margin = 0.92) {
  const back = new Vector3(...direction).normalize(), right = new Vector3(0, 0, 1).cross(back).normalize(), up = back.clone().cross(right);
  const target = new Vector3(), tall = Math.tan((camera.fov * Math.PI) / 360) * margin, wide = tall * camera.aspect;
  const n = points.length / 3;
  for (let i = 0; i < n; ++i) target.add(new Vector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]).divideScalar(n));
  let distance = 1;
  for (let round = 0; round < 6; ++round) { // the middle of the picture moves with what is nearest
    distance = 0.1;
    let low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    const seen = [];
    for (let i = 0; i < n; ++i) {
      const p = new Vector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]).sub(target), x = p.dot(right), y = p.dot(up), z = p.dot(back);
      seen.push([x, y, z]);
      distance = Math.max(distance, z + Math.abs(x) / wide, z + Math.abs(y) / tall);
    }
    for (const [x, y, z] of seen) [x, y].forEach((v, k) => (low[k] = Math.min(low[k], v / (distance - z)), high[k] = Math.max(high[k], v / (distance - z))));
    target.addScaledVector(right, 0.5 * (low[0] + high[0]) * distance).addScaledVector(up, 0.5 * (low[1] + high[1]) * distance);
  }
  camera.position.copy(target).addScaledVector(back, distance);
  return target;
}

const round = (x) => Math.round(100 * x) / 100;
/** The camera as a text for the page's address. */
export const cameraText = (numbers) => numbers.map(round).join(",");
/** Six numbers of such a text, or null. */
export function cameraNumbers(text) {
  const numbers = (text ?? "").split(",").map(Number);
  return numbers.length === 6 && numbers.every(Number.isFinite) ? numbers : null;
}
