// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
import { colourings } from "./colours.js";
import { House } from "./house.js";
import { magnification } from "./magnify.js";

/** A run and its house; of two side by side, one. */
export class Pane {
  constructor(run, element, still) {
    this.run = run;
    this.times = run.facts.times;
    this.colours = colourings(run);
    this.element = element;
    this.ground = run.facts.plots.find((p) => p.title === "Ground acceleration");
    this.house = new House(element.querySelector(".view"), run, still);
    this.magnify = magnification(run, this.house.size);
  }
  /** Turns the house with keys; a click on it picks an element. */
  listen(pick) {
    let down = [0, 0];
    const view = this.house.canvas;
    view.addEventListener("pointerdown", (e) => (down = [e.clientX, e.clientY]));
    view.addEventListener("pointerup", (e) => {
      if (Math.hypot(e.clientX - down[0], e.clientY - down[1]) < 4) pick(this.house.pick(e.clientX, e.clientY));
    });
    const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08], "+": [0, 0, 1.15], "=": [0, 0, 1.15], "-": [0, 0, 1 / 1.15] };
    view.addEventListener("keydown", (e) => {
      if (!turns[e.key] || e.altKey || e.ctrlKey || e.metaKey) return;
      this.house.orbit(...turns[e.key]);
      e.preventDefault(), e.stopPropagation();
    });
  }
  /** The frame at a time, between two if it must be. */
  frameAt(t) {
    const { times } = this, last = times.length - 1;
    if (t >= times[last]) return last;
    let f = Math.max(0, Math.min(last - 1, Math.floor(((t - times[0]) / (times[last] - times[0] || 1)) * last)));
    while (f > 0 && times[f] > t) --f;
    while (f < last - 1 && times[f + 1] <= t) ++f;
    return Math.max(0, f + (t - times[f]) / (times[f + 1] - times[f] || 1));
  }
  /** Of two runs side by side: its letter, what it is if it is no time history, and its end once the clock is past it. */
  label(letter, t) {
    const { capacity } = this.run.facts, last = this.times.at(-1) ?? 0;
    return letter + (capacity ? `: ${capacity.kind}` : "") + (t > last + 5e-3 ? `, at its end (${last.toFixed(2)} s)` : "");
  }
  /** Where the ground is at a frame, which need not be whole, m. */
  groundWay(at) {
    const { ground } = this.run.facts, f = Math.floor(at);
    if (!ground?.length) return [0, 0, 0];
    const a = ground[Math.min(f, ground.length - 1)], b = ground[Math.min(f + 1, ground.length - 1)];
    return a.map((x, k) => x + (at - f) * (b[k] - x));
  }
  /** Its acceleration at a time, m/s². */
  groundAt(t) {
    const p = this.ground;
    if (!p || p.t.length < 2) return null;
    const i = Math.round((t - p.t[0]) / (p.t[1] - p.t[0]));
    return i < 0 || i >= p.t.length ? null : p.curves.map((c) => c.y[i] ?? 0);
  }
}
