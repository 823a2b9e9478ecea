// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Capacity curves: a force over a displacement, which may turn back, drawn by uPlot. A point stands where the run is at the moment that is
// shown; a click goes to the moment of the nearest point of the curve.
import uPlot from "uplot";
import { colour, kHeight, kType, number, onProcessor } from "./plots.js";

/** A line through points, in the order in which they come. */
function through(u, s) {
  const [x, y] = u.data[s], line = new Path2D();
  x.forEach((v, i) => (i === 0 || y[i - 1] === null || y[i] === null ? line.moveTo : line.lineTo).call(line, u.valToPos(v, "x", true), u.valToPos(y[i] ?? 0, "y", true)));
  return { stroke: line, fill: null };
}

export class CurvePlot {
  /** @param plots  of the same name, one of each run  @param seek  called with the time that a click points at */
  constructor(parent, plots, seek) {
    this.runs = plots.map((plot, run) => plot && { ...plot, run }).filter(Boolean);
    this.two = plots.length > 1, this.first = this.runs[0], this.seek = seek;
    this.figure = parent.appendChild(Object.assign(document.createElement("figure"), { className: "curves" }));
    this.figure.appendChild(document.createElement("figcaption")).textContent = [this.first.title, this.first.unit].filter(Boolean).join(", ");
    this.holder = this.figure.appendChild(document.createElement("div"));
    this.holder.setAttribute("role", "img");
    this.holder.setAttribute("aria-label", this.#words());
    this.#make();
    new ResizeObserver(() => this.plot.setSize({ width: this.holder.clientWidth, height: kHeight + 24 })).observe(this.holder);
  }

  #words() {
    const { y } = this.first.curves[0], most = y.reduce((a, b) => Math.max(a, b ?? -Infinity), -Infinity), at = this.first.x.values[y.indexOf(most)];
    const points = (this.first.points ?? []).map((p) => `${p.name} at ${number(p.x)} ${this.first.x.unit}`);
    return [`${this.first.title}: at most ${number(most)} ${this.first.unit} at ${number(at)} ${this.first.x.unit}`, ...points].join("; ");
  }

  /** What is drawn: of each run its curves, then the straight lines that stand for them. */
  #series() {
    const name = (text, { run }) => (this.two ? `${text} ${"AB"[run]}` : text);
    return this.runs.flatMap((r) => {
      const dash = r.run > 0 ? [5, 3] : undefined;
      return [
        ...r.curves.map((c, k) => ({ label: name(c.name, r), tint: `--c${k % 9}`, width: 1.5, dash, data: [r.x.values, c.y] })),
        ...(r.lines ?? []).map((l, k) => ({ label: name(l.name, r), tint: `--c${(k + r.curves.length) % 9}`, width: 1.25, dash: [[6, 3], [2, 2]][k % 2], data: [l.x, l.y] })),
      ];
    });
  }

  #make() {
    const series = this.#series(), all = (k) => series.flatMap((s) => s.data[k]).filter((v) => v !== null), facet = (scale) => ({ scale, auto: true });
    const range = (values) => {
      const low = values.reduce((a, b) => Math.min(a, b), 0), high = values.reduce((a, b) => Math.max(a, b), 0), room = 0.04 * (high - low || 1);
      return [low < 0 ? low - room : 0, high + room];
    };
    const x = range(all(0)), y = range(all(1)), line = colour("--line"), faint = colour("--faint");
    const axis = { stroke: faint, font: kType, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1, size: 4 } };
    const options = {
      mode: 2, width: Math.max(200, this.holder.clientWidth), height: kHeight + 24, padding: [6, 16, 0, 0],
      cursor: { show: false }, legend: { live: false },
      scales: { x: { time: false, range: () => x }, y: { range: () => y } },
      axes: [{ ...axis, size: 24, gap: 2, label: `${this.first.x.name}, ${this.first.x.unit}`, labelSize: 16, labelGap: 0, labelFont: kType, values: (u, ticks) => ticks.map(number) }, { ...axis, size: 46, gap: 2, values: (u, ticks) => ticks.map(number) }],
      series: [{}, ...series.map((s) => ({ label: s.label, stroke: colour(s.tint), width: s.width, dash: s.dash, facets: [facet("x"), facet("y")], paths: through, points: { show: false } }))],
      hooks: { draw: [(u) => this.#drawPoints(u)], ready: [() => this.#again()], setSize: [() => this.#again()] },
    };
    this.plot = onProcessor(() => new uPlot(options, [null, ...series.map((s) => s.data)], this.holder));
    this.dots = this.runs.map(() => this.plot.over.appendChild(Object.assign(document.createElement("div"), { className: "here" })));
    this.plot.over.addEventListener("click", (e) => this.#goTo(e));
  }

  /** Scales are there only after uPlot has drawn. */
  #again() { setTimeout(() => this.plot.over.isConnected && this.shown !== undefined && this.now(this.shown)); }

  /** Peak, ultimate point and the like, by name. */
  #drawPoints(u) {
    const c = u.ctx, size = 3.5 * devicePixelRatio;
    c.save();
    c.font = `${11 * devicePixelRatio}px system-ui, "DejaVu Sans", sans-serif`, c.strokeStyle = c.fillStyle = colour("--text"), c.lineWidth = 1.5 * devicePixelRatio, c.setLineDash([]);
    for (const r of this.runs)
      for (const p of r.points ?? []) {
        const x = u.valToPos(p.x, "x", true), y = u.valToPos(p.y, "y", true), left = x > u.bbox.left + 0.75 * u.bbox.width;
        c.beginPath(), c.arc(x, y, size, 0, 2 * Math.PI), c.stroke();
        c.textAlign = left ? "right" : "left";
        c.fillText(this.two ? `${p.name} ${"AB"[r.run]}` : p.name, x + (left ? -2 : 2) * size, y + 4.5 * size);
      }
    c.restore();
  }

  #goTo(event) {
    const box = this.plot.over.getBoundingClientRect(), at = [event.clientX - box.left, event.clientY - box.top];
    let best = Infinity, time;
    for (const r of this.runs)
      r.x.values.forEach((x, i) => {
        const off = Math.hypot(this.plot.valToPos(x, "x") - at[0], this.plot.valToPos(r.curves[0].y[i] ?? 0, "y") - at[1]);
        if (off < best) best = off, time = r.t[i];
      });
    if (time !== undefined) this.seek(time);
  }

  now(t) {
    this.shown = t;
    this.runs.forEach((r, k) => {
      const after = r.t.findIndex((x) => x >= t), i = after < 0 ? r.t.length - 1 : after;
      this.dots[k].style.transform = `translate(${this.plot.valToPos(r.x.values[i] ?? 0, "x")}px, ${this.plot.valToPos(r.curves[0].y[i] ?? 0, "y")}px)`;
    });
  }

  /** In the colours of the theme. */
  dress() {
    this.plot.destroy();
    this.#make();
  }
  remove() {
    this.plot.destroy();
    this.figure.remove();
  }
}
