// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What is written into a picture of the house: names of walls, axes, a scale, the ground's acceleration; and what is burnt into stills and
// films besides: title, time, legend. One program for the page and for pictures.
import { Vector3 } from "three";
import { drawLegend } from "./legend.js";

const kType = 'system-ui, "DejaVu Sans", sans-serif';

/** Where a point is in the picture, in pixels, or null behind the camera. */
function seen(point, camera, width, height) {
  const p = point.clone().applyMatrix4(camera.matrixWorldInverse);
  if (p.z > -camera.near) return null;
  p.applyMatrix4(camera.projectionMatrix);
  return [(0.5 + 0.5 * p.x) * width, (0.5 - 0.5 * p.y) * height];
}

/** Tells the sheet (sheet.js) what is drawn upon: from one corner to the other, and `more` pixels around. Pictures have no sheet. */
function mark(c, [x, y], [X, Y], more) {
  c.marks?.push([Math.min(x, X) - more, Math.min(y, Y) - more, Math.max(x, X) + more, Math.max(y, Y) + more]);
}
/** The same for a line, piece by piece. */
function markLine(c, [x, y], [X, Y], more) {
  const pieces = Math.ceil(Math.hypot(X - x, Y - y) / 40), at = (i) => [x + (i / pieces) * (X - x), y + (i / pieces) * (Y - y)];
  for (let i = 0; i < pieces; ++i) mark(c, at(i), at(i + 1), more);
}

/** Text with a rim of the background, so that it can be read on anything. */
function write(c, text, x, y, ink) {
  if (c.marks) {
    const m = c.measureText(text);
    mark(c, [x - m.actualBoundingBoxLeft, y - m.actualBoundingBoxAscent], [x + m.actualBoundingBoxRight, y + m.actualBoundingBoxDescent], 4);
  }
  c.strokeStyle = ink.rim, c.lineWidth = 3.5, c.lineJoin = "round", c.fillStyle = ink.text;
  c.strokeText(text, x, y);
  c.fillText(text, x, y);
}

function arrow(c, [x, y], [X, Y], head) {
  const length = Math.hypot(X - x, Y - y);
  if (length < 1) return;
  mark(c, [x, y], [X, Y], head);
  const dx = (X - x) / length, dy = (Y - y) / length, h = Math.min(head, length);
  c.beginPath(), c.moveTo(x, y), c.lineTo(X - 0.7 * h * dx, Y - 0.7 * h * dy), c.stroke();
  c.beginPath(), c.moveTo(X, Y), c.lineTo(X - h * dx - 0.45 * h * dy, Y - h * dy + 0.45 * h * dx), c.lineTo(X - h * dx + 0.45 * h * dy, Y - h * dy - 0.45 * h * dx), c.fill();
}

/** Of several houses in one run a wall's name ends with that of its house. */
const houseOf = (wall) => / of house \d+/.exec(wall.name)?.[0];

/** Whether a wall stands between others of its house, which hide it. */
function isInner(w, all) {
  const kFlush = 0.05; // m
  const walls = all.filter((other) => houseOf(other) === houseOf(w) && other.axes[0] === w.axes[0]);
  return walls.some((other) => other.low[w.across] < w.low[w.across] - kFlush) && walls.some((other) => other.high[w.across] > w.high[w.across] + kFlush);
}

/** A vector along the axes of a wall, which are turned about z, in plan along those of the model. */
const inModel = ({ axes: [c, s] }, [x, y]) => [c * x - s * y, s * x + c * y];

/** Each wall is named once, however many storeys it has: at the ground, and one between others on its top, where that is seen. Names that
 *  would lie on those of nearer walls are left out.
 *  @param open  whether the roof or what lies before a section is hidden */
function wallNames(c, facts, camera, width, height, u, ink, open) {
  c.font = `600 ${u}px ${kType}`, c.textAlign = "center", c.textBaseline = "middle";
  const named = new Set(), names = [];
  for (const w of facts.walls) {
    const name = w.name.replace(/, storey \d+$/, ""), inner = isInner(w, facts.walls);
    if (named.has(name) || (inner && !open)) continue;
    named.add(name);
    const at = [0, 1, 2].map((k) => 0.5 * (w.low[k] + w.high[k]));
    at[w.across] = (w.outward > 0 ? w.high : w.low)[w.across] + 0.35 * w.outward;
    at[2] = facts.base ?? w.low[2];
    if (inner) at[w.across] = 0.5 * (w.low[w.across] + w.high[w.across]), at[2] = Math.max(...facts.walls.filter((v) => v.name.startsWith(name)).map((v) => v.high[2]));
    const normal = inModel(w, [0, 1].map((k) => (k === w.across ? w.outward : 0))), p = new Vector3(...inModel(w, at), at[2]);
    const toEye = camera.position.clone().sub(p);
    if (!inner && toEye.x * normal[0] + toEye.y * normal[1] < 0.15 * toEye.length()) continue; // seen from behind, or along it
    const place = seen(p, camera, width, height);
    if (place) names.push({ name, x: place[0], y: place[1] + 0.3 * u, wide: 0.5 * c.measureText(name).width, far: toEye.length() });
  }
  const written = [];
  for (const n of names.sort((a, b) => a.far - b.far)) {
    if (written.some((m) => Math.abs(m.x - n.x) < m.wide + n.wide && Math.abs(m.y - n.y) < u)) continue;
    written.push(n);
    write(c, n.name, n.x, n.y, ink);
  }
}

/** The three axes in a corner, and beside them how long a metre is in the middle of the picture; returns where that ends. */
function axes(c, camera, target, left, bottom, u, ink, height) {
  const origin = [left + 2.6 * u, bottom - 2.2 * u];
  c.font = `${0.85 * u}px ${kType}`, c.lineWidth = 1.6, c.textAlign = "center", c.textBaseline = "middle";
  for (const [name, axis] of [["x", new Vector3(1, 0, 0)], ["y", new Vector3(0, 1, 0)], ["z", new Vector3(0, 0, 1)]]) {
    const d = axis.transformDirection(camera.matrixWorldInverse), end = [origin[0] + 2 * u * d.x, origin[1] - 2 * u * d.y];
    c.strokeStyle = c.fillStyle = ink.text;
    arrow(c, origin, end, 0.5 * u);
    if (Math.hypot(d.x, d.y) > 0.2) write(c, name, origin[0] + 2.6 * u * d.x, origin[1] - 2.6 * u * d.y, ink);
  }
  const metre = height / (2 * Math.tan((camera.fov * Math.PI) / 360) * camera.position.distanceTo(target)); // pixels
  const bar = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20].find((m) => m * metre > 4.5 * u) ?? 50, x = left + 6.4 * u, y = bottom - 1.2 * u;
  c.strokeStyle = c.fillStyle = ink.text, c.lineWidth = 2;
  mark(c, [x, y - 0.35 * u], [x + bar * metre, y], 2);
  c.beginPath(), c.moveTo(x, y - 0.35 * u), c.lineTo(x, y), c.lineTo(x + bar * metre, y), c.lineTo(x + bar * metre, y - 0.35 * u), c.stroke();
  c.textBaseline = "bottom";
  write(c, `${bar} m`, x + 0.5 * bar * metre, y - 0.25 * u, ink);
  return x + bar * metre;
}

/** The acceleration of the ground as an arrow beside the axes and the scale, turned as they are: there it crosses neither the house nor names. */
function groundArrow(c, ground, camera, left, bottom, u, ink) {
  const size = Math.hypot(...ground);
  c.font = `${0.85 * u}px ${kType}`, c.textAlign = "center", c.textBaseline = "bottom", c.lineWidth = 3;
  const middle = [left + 3.4 * u, bottom - 4.2 * u], d = new Vector3(...ground).transformDirection(camera.matrixWorldInverse).multiplyScalar(0.2 * u * size);
  c.strokeStyle = c.fillStyle = ink.arrow;
  if (size >= 0.05) arrow(c, [middle[0] - d.x, middle[1] + d.y], [middle[0] + d.x, middle[1] - d.y], 0.9 * u);
  write(c, `ground ${size.toFixed(1)} m/s²`, middle[0], bottom, { ...ink, text: ink.arrow });
}

function distanceNames(c, box, base, camera, width, height, u, ink) {
  c.font = `${0.9 * u}px ${kType}`, c.textAlign = "center", c.textBaseline = "middle";
  for (let d = 1; d <= 6; ++d) {
    for (const [x, y] of [[box.high.x + d, 0.5 * (box.low.y + box.high.y)], [0.5 * (box.low.x + box.high.x), box.low.y - d]]) {
      const p = seen(new Vector3(x, y, base), camera, width, height);
      if (p) write(c, `${d} m`, ...p, { ...ink, text: ink.arrow });
    }
  }
}

/** The forces of loads as arrows that end where they act, each with its name and size. */
function loadArrows(c, loads, camera, width, height, u, ink) {
  c.font = `600 ${0.85 * u}px ${kType}`, c.textAlign = "center", c.textBaseline = "bottom";
  for (const { from, to, text } of loads) {
    const ends = [from, to].map((p) => seen(new Vector3(...p), camera, width, height));
    if (ends.some((p) => !p)) continue;
    c.strokeStyle = ink.rim, c.fillStyle = ink.rim, c.lineWidth = 7;
    arrow(c, ...ends, 1.5 * u);
    c.strokeStyle = c.fillStyle = ink.load, c.lineWidth = 3.5;
    arrow(c, ...ends, 1.2 * u);
    write(c, text, ends[0][0], ends[0][1] - 0.4 * u, { ...ink, text: ink.load });
  }
}

/** Ties, and the bars of decks and meshes, as lines that are seen through walls; the thinner the more there are. */
function tieLines(c, { rods, bars }, camera, width, height, ink) {
  barLines(c, bars, 0.7, camera, width, height, ink);
  barLines(c, rods, rods.length > 100 ? 1 : 2.5, camera, width, height, ink);
}

function barLines(c, bars, thick, camera, width, height, ink) {
  c.strokeStyle = ink.tie, c.lineWidth = thick;
  c.beginPath();
  for (const pair of bars) {
    const ends = pair.map((p) => seen(new Vector3(...p), camera, width, height));
    if (ends.some((p) => !p)) continue;
    markLine(c, ...ends, 3);
    c.moveTo(...ends[0]), c.lineTo(...ends[1]);
  }
  c.stroke();
}

/** Draws all of these that `on` asks for: names, axes, ground (three numbers, m/s²), distances, loads, ties. */
export function drawOverlay(c, house, width, height, u, on, ink) {
  const { camera } = house, facts = house.run.facts;
  camera.updateMatrixWorld();
  if (on.distances && facts.base !== null) distanceNames(c, house, facts.base, camera, width, height, u, ink);
  if (on.names) wallNames(c, facts, camera, width, height, u, ink, house.partly);
  const bottom = height - (on.bottom ?? 0.6 * u), end = axes(c, camera, house.controls.target, 0.6 * u, bottom, u, ink, height);
  if (on.ties) tieLines(c, on.ties, camera, width, height, ink);
  if (on.loads) loadArrows(c, on.loads, camera, width, height, u, ink);
  if (on.ground && facts.base !== null) groundArrow(c, on.ground, camera, end + u, bottom, u, ink);
  for (const { points, slides } of on.hinges ?? []) {
    const ends = points.map((p) => seen(new Vector3(...p), camera, width, height));
    if (ends.some((p) => !p)) continue;
    c.strokeStyle = ink.hinge, c.lineWidth = slides ? 4 : 3, c.setLineDash(slides ? [2, 4] : [9, 5]);
    markLine(c, ...ends, 4);
    c.beginPath(), c.moveTo(...ends[0]), c.lineTo(...ends[1]), c.stroke(), c.setLineDash([]);
  }
}

/** Title and time at the top, the legend at the bottom, on plates; returns the height of the lower plate. */
export function drawCaption(c, { title, subtitle, clock, note, legend }, width, height, u) {
  const plate = "rgba(255, 255, 255, 0.86)";
  c.fillStyle = plate, c.fillRect(0, 0, width, 3.6 * u);
  c.textBaseline = "middle", c.textAlign = "right", c.fillStyle = "#111";
  c.font = `600 ${1.7 * u}px ${kType}`;
  c.fillText(clock, width - u, 1.45 * u);
  const room = width - 3 * u - c.measureText(clock).width;
  c.font = `${0.95 * u}px ${kType}`, c.fillStyle = "#444";
  if (note) c.fillText(note, width - u, 2.9 * u);
  c.textAlign = "left";
  c.fillText(subtitle, u, 2.75 * u, width - 3 * u - (note ? c.measureText(note).width : 0));
  c.font = `600 ${1.25 * u}px ${kType}`, c.fillStyle = "#111";
  c.fillText(title, u, 1.3 * u, room);
  const measure = document.createElement("canvas").getContext("2d"), top = drawLegend(measure, legend, u, height - 0.3 * u, width - 2 * u, u);
  c.fillStyle = plate, c.fillRect(0, top - 0.3 * u, width, height - top + 0.3 * u);
  drawLegend(c, legend, u, height - 0.3 * u, width - 2 * u, u);
  return height - top + 0.3 * u;
}
