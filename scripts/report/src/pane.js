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
  /** The frame at a time, between two if it must be. */
  frameAt(t) {
    const { times } = this, last = times.length - 1;
    if (t >= times[last]) return last;
    let f = Math.max(0, Math.min(last - 1, Math.floor(((t - times[0]) / (times[last] - times[0] || 1)) * last)));
    while (f > 0 && times[f] > t) --f;
    while (f < last - 1 && times[f + 1] <= t) ++f;
    return Math.max(0, f + (t - times[f]) / (times[f + 1] - times[f] || 1));
  }
  groundAt(t) {
    const p = this.ground;
    if (!p || p.t.length < 2) return null;
    const i = Math.round((t - p.t[0]) / (p.t[1] - p.t[0]));
    return i < 0 || i >= p.t.length ? null : p.curves.map((c) => c.y[i] ?? 0);
  }
}
