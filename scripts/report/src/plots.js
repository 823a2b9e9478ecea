// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Curves over time, drawn by uPlot: the cursor reads all plots at once, a click goes there, a line stands at the moment that is shown.
import uPlot from "uplot";

export const kHeight = 168, kType = '11px system-ui, "DejaVu Sans", sans-serif';
const small = (v) => String(v !== 0 && Math.abs(v) < 1e-3 ? v.toExponential(1) : +v.toPrecision(3));
/** In little room: "202 k" is 202,000. */
export const number = (v) => (v === null || v === undefined ? "–" : Math.abs(v) >= 1e6 ? `${small(v / 1e6)} M` : Math.abs(v) >= 1e4 ? `${small(v / 1e3)} k` : small(v));

const plain = HTMLCanvasElement.prototype.getContext;
/** Has the processor draw on the canvases that `make` makes: where there is no graphics card, curves of thousands of points took seconds else,
 *  in which nothing on the page moved. */
export function onProcessor(make) {
  HTMLCanvasElement.prototype.getContext = function (kind, options) { return plain.call(this, kind, { ...options, willReadFrequently: true }); };
  try {
    return make();
  } finally {
    HTMLCanvasElement.prototype.getContext = plain;
  }
}

/** A variable of the style sheet as a colour that a canvas knows. */
export function colour(name) {
  const probe = document.body.appendChild(document.createElement("i"));
  probe.style.color = `var(${name})`;
  const value = getComputedStyle(probe).color;
  probe.remove();
  return value;
}

/** Rows of times within [from, until]. */
function within(plot, from, until) {
  const keep = plot.t.map((t, i) => i).filter((i) => plot.t[i] >= from && plot.t[i] <= until), pick = (values) => keep.map((i) => values[i]);
  return { t: pick(plot.t), curves: plot.curves.map((c) => ({ name: c.name, y: pick(c.y) })) };
}

/** Curves of a stack, the highest first: each with all below it. Its last curve stands for itself. */
function stacked(curves) {
  const sums = [], parts = curves.slice(0, -1);
  parts.forEach(({ y }, k) => sums.push(y.map((v, i) => (v ?? 0) + (k > 0 ? sums[k - 1][i] : 0))));
  return [...sums.reverse(), curves.at(-1).y];
}

/** Values beyond the clip left out, and where they were: [index, sign] of the first of each stretch. */
function clipped(y, clip) {
  const marks = [], kept = y.map((v, i) => {
    if (v === null || Math.abs(v) <= clip) return v;
    if (i === 0 || y[i - 1] === null || Math.abs(y[i - 1]) <= clip) marks.push([i, Math.sign(v)]);
    return Math.sign(v) * clip;
  });
  return { kept: kept.map((v, i) => (i > 0 && i + 1 < y.length && Math.abs(kept[i - 1]) === clip && Math.abs(v) === clip && Math.abs(kept[i + 1]) === clip ? null : v)), marks };
}

export class Plot {
  /** @param plots  of the same name, one of each run  @param seek  called with the time that a click points at */
  constructor(parent, plots, from, until, seek) {
    const first = plots.find(Boolean);
    Object.assign(this, { title: first.title, unit: first.unit, from, until, seek, hover: false });
    this.figure = parent.appendChild(document.createElement("figure"));
    const caption = this.figure.appendChild(document.createElement("figcaption"));
    caption.textContent = first.unit ? `${first.title}, ${first.unit}` : first.title;
    this.holder = this.figure.appendChild(document.createElement("div"));
    this.#read(plots, first);
    this.holder.setAttribute("role", "img");
    this.holder.setAttribute("aria-label", this.#words());
    this.#make();
    this.inView = true;
    new IntersectionObserver((seen) => this.#look(seen.at(-1).isIntersecting)).observe(this.holder);
    new ResizeObserver(() => this.plot.setSize({ width: this.holder.clientWidth, height: kHeight })).observe(this.holder);
  }

  #read(plots, first) {
    const tables = [];
    this.series = [{}], this.raw = [null], this.marks = [];
    plots.forEach((plot, run) => {
      if (!plot) return;
      const { t, curves } = within(plot, this.from, this.until), dash = run > 0 ? [5, 3] : undefined;
      const shown = plot.stack ? stacked(curves) : curves.map((c) => c.y), order = plot.stack ? [...curves.keys()].slice(0, -1).reverse().concat(curves.length - 1) : [...curves.keys()];
      tables.push([t, ...shown.map((y, k) => {
        const c = order[k], name = curves[c].name + (plots.length > 1 ? ` ${"AB"[run]}` : ""), line = plot.stack && k === shown.length - 1;
        const cut = plot.clip ? clipped(y, plot.clip) : { kept: y, marks: [] };
        this.marks.push(cut.marks.map(([i, sign]) => [t[i], sign]));
        this.series.push({ label: name, tint: line ? "--text" : `--c${c % 9}`, width: line ? 1.5 : plot.stack ? 0 : 1.25, dash: dash ?? [undefined, [7, 3], [2, 3]][Math.floor(c / 9) % 3], fill: plot.stack && !line && run === 0 });
        this.raw.push([t, curves[c].y]);
        return cut.kept;
      })]);
    });
    this.clip = first.clip;
    this.data = tables.length > 1 ? uPlot.join(tables) : tables[0];
  }

  #words() {
    const values = this.raw.slice(1).flatMap(([, y]) => y.filter((v) => v !== null));
    const low = values.reduce((a, b) => Math.min(a, b), Infinity), high = values.reduce((a, b) => Math.max(a, b), -Infinity);
    return values.length > 0 ? `${this.title} between ${number(low)} and ${number(high)} ${this.unit}` : `${this.title}: no values`;
  }

  /** The value of a curve at the time nearest to `t`, of those that were there before anything was stacked or clipped; null where the curve has
   *  ended, as that of a shorter run. */
  #value(s, t) {
    const [times, y] = this.raw[s], last = times.length - 1, step = last > 0 ? (times[last] - times[0]) / last : 0;
    if (t > times[last] + step || t < times[0] - step) return null;
    let low = 0, high = times.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle;
      else high = middle;
    }
    return y[high] !== undefined && Math.abs(times[high] - t) < Math.abs(times[low] - t) ? y[high] : y[low];
  }

  #make() {
    const line = colour("--line"), faint = colour("--faint"), axis = { stroke: faint, font: kType, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1, size: 4 } };
    const value = (s) => (u, v, i, at) => (at === null ? "–" : number(this.#value(s, u.data[0][at])));
    const options = {
      width: Math.max(200, this.holder.clientWidth), height: kHeight, padding: [6, 16, 0, 0],
      cursor: { y: false, sync: { key: "report" }, drag: { x: false, y: false }, points: { size: 5 } },
      legend: { live: true, markers: { dash: (_, i) => (this.series[i].dash ? "dashed" : "solid") } },
      scales: { x: { time: false, range: () => [this.from, this.until] }, y: { range: (u, low, high) => this.#range(low, high) } },
      axes: [{ ...axis, size: 24, gap: 2, values: (u, ticks) => ticks.map((t) => `${+t.toFixed(2)} s`) }, { ...axis, size: 46, gap: 2, values: (u, ticks) => ticks.map(number) }],
      series: this.series.map((s, i) => (i === 0 ? { label: "Time", value: (u, t) => (t == null ? "–" : `${t.toFixed(2)} s`) } : { label: s.label, stroke: colour(s.tint), width: s.width, dash: s.dash, fill: s.fill ? colour(s.tint) : undefined, value: value(i), points: { show: false } })),
      hooks: { draw: [(u) => this.#drawMarks(u)], ready: [() => this.#again()], setSize: [() => this.#again()] },
    };
    this.plot = onProcessor(() => new uPlot(options, this.data, this.holder));
    this.line = this.plot.over.appendChild(Object.assign(document.createElement("div"), { className: "now" }));
    this.plot.over.addEventListener("pointerenter", () => (this.hover = true));
    this.plot.over.addEventListener("pointerleave", () => ((this.hover = false), this.#again()));
    this.plot.over.addEventListener("click", (e) => this.seek(this.plot.posToVal(e.clientX - this.plot.over.getBoundingClientRect().left, "x")));
    for (const cell of this.holder.querySelectorAll(".u-legend th")) cell.setAttribute("scope", "row");
  }

  #range(low, high) {
    if (low === null || high === null) return [0, 1];
    if (this.clip && Math.max(-low, high) >= this.clip) return [low <= -this.clip ? -1.08 * this.clip : Math.min(0, low), high >= this.clip ? 1.08 * this.clip : Math.max(0, high)];
    const bottom = Math.min(0, low), top = Math.max(0, high), room = 0.05 * (top - bottom || 1);
    return [bottom < 0 ? bottom - room : 0, top > 0 ? top + room : 0];
  }

  /** A triangle where a curve leaves the plot. */
  #drawMarks(u) {
    const c = u.ctx, size = 4 * devicePixelRatio;
    this.marks.forEach((marks, s) => {
      c.fillStyle = colour(this.series[s + 1].tint);
      for (const [t, sign] of marks) {
        const x = u.valToPos(t, "x", true), y = u.valToPos(sign * this.clip, "y", true);
        c.beginPath(), c.moveTo(x - size, y), c.lineTo(x + size, y), c.lineTo(x, y - 1.6 * sign * size), c.fill();
      }
    });
  }

  /** Out of view nothing is moved; once it comes back, it shows the moment. */
  #look(inView) {
    this.inView = inView;
    if (inView && this.shown !== undefined) this.now(this.shown, true);
  }

  /** uPlot has forgotten what was read. */
  #again() { setTimeout(() => this.plot.over.isConnected && this.shown !== undefined && this.now(this.shown, true)); }

  /** @param read  whether the values then are to be shown, too */
  now(t, read) {
    this.shown = t;
    if (!this.inView) return;
    this.line.style.transform = `translateX(${this.plot.valToPos(Math.min(Math.max(t, this.from), this.until), "x")}px)`;
    if (read && !this.hover) this.plot.setLegend({ idx: this.plot.valToIdx(t) });
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
