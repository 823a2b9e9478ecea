// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Curves over time, with a line at the moment that is shown.

const kWidth = 360, kHeight = 110, kLeft = 44, kRight = 6, kTop = 6, kBottom = 14;
const kBins = 320; // across a plot; of each the lowest and the highest value are drawn

function make(name, attributes, parent, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.textContent = text;
  return parent.appendChild(element);
}

/** Of [first, end), some `step` to a bin, the indices that keep the peaks. */
function peaks(values, first, end, step) {
  const keep = [];
  for (let i = first; i < end; i += step) {
    let low = i, high = i;
    for (let j = i; j < Math.min(i + step, end); ++j) {
      if (values[j] < values[low]) low = j;
      if (values[j] > values[high]) high = j;
    }
    keep.push(...new Set([Math.min(low, high), Math.max(low, high)]));
  }
  return keep;
}

/** Stretches [first, end) of the values that are there, within [from, until]: rows of settling come before, and what has fallen has no drift. */
function stretches(times, values, from, until) {
  const found = [], shown = (i) => values[i] !== null && times[i] >= from && times[i] <= until;
  for (let i = 0; i < values.length; ++i) {
    if (!shown(i)) continue;
    if (i > 0 && shown(i - 1)) ++found[found.length - 1][1];
    else found.push([i, i + 1]);
  }
  return found;
}

/** Two digits in little room. */
const short = (v) => (v !== 0 && (Math.abs(v) < 1e-3 || Math.abs(v) >= 1e5) ? v.toExponential(1) : String(+v.toPrecision(2)));

export class Plot {
  /** \param seek called with the time that a click points at */
  constructor(parent, plot, from, until, seek) {
    Object.assign(this, { from, until });
    const values = plot.curves.flatMap((c) => c.y.filter((v, i) => v !== null && plot.t[i] >= from && plot.t[i] <= until));
    const low = values.reduce((a, b) => Math.min(a, b), 0), high = values.reduce((a, b) => Math.max(a, b), 0);
    this.low = low;
    this.span = high - low || 1;
    const figure = parent.appendChild(document.createElement("figure"));
    const caption = figure.appendChild(document.createElement("figcaption"));
    caption.textContent = plot.unit ? `${plot.title}, ${plot.unit}` : plot.title;
    this.svg = make("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, preserveAspectRatio: "none", role: "img" }, figure);
    this.svg.setAttribute("aria-label", `${plot.title} between ${low.toPrecision(3)} and ${high.toPrecision(3)} ${plot.unit}`);
    this.#axes(low, high);
    plot.curves.forEach((curve, i) => this.#curve(caption, plot.t, curve, `var(--c${i % 9})`));
    this.line = make("line", { class: "now", y1: kTop, y2: kHeight - kBottom }, this.svg);
    this.svg.addEventListener("click", (event) => {
      const box = this.svg.getBoundingClientRect(), x = ((event.clientX - box.left) / box.width) * kWidth;
      seek(from + ((x - kLeft) / (kWidth - kLeft - kRight)) * (until - from));
    });
  }

  x(t) { return kLeft + ((t - this.from) / (this.until - this.from || 1)) * (kWidth - kLeft - kRight); }
  y(v) { return kHeight - kBottom - ((v - this.low) / this.span) * (kHeight - kTop - kBottom); }

  #axes(low, high) {
    for (const v of new Set([low, 0, high])) {
      make("line", { class: "axis", x1: kLeft, x2: kWidth - kRight, y1: this.y(v), y2: this.y(v) }, this.svg);
      const beside = v !== 0 && Math.abs(this.y(v) - this.y(0)) < 9; // of zero: no room for both
      if (!beside) make("text", { x: kLeft - 3, y: this.y(v) + 3, "text-anchor": "end" }, this.svg, short(v));
    }
    make("text", { x: kLeft, y: kHeight - 3 }, this.svg, `${+this.from.toFixed(2)} s`);
    make("text", { x: kWidth - kRight, y: kHeight - 3, "text-anchor": "end" }, this.svg, `${+this.until.toFixed(2)} s`);
  }

  #curve(caption, times, { name, y }, colour) {
    const all = stretches(times, y, this.from, this.until), step = Math.ceil(all.reduce((n, [first, end]) => n + end - first, 0) / kBins);
    const line = ([first, end]) => "M" + peaks(y, first, end, step).map((i) => `${this.x(times[i]).toFixed(1)},${this.y(y[i]).toFixed(1)}`).join("L");
    if (all.length > 0) make("path", { d: all.map(line).join(""), style: `stroke:${colour}` }, this.svg);
    const label = caption.appendChild(document.createElement("span"));
    label.textContent = name;
    label.style.color = colour;
  }

  now(t) {
    this.line.setAttribute("x1", this.x(t));
    this.line.setAttribute("x2", this.x(t));
  }
}
