// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
import { colourings } from "./colours.js";
import { loadRun } from "./data.js";
import { House } from "./house.js";
import { Plot } from "./plots.js";
import { showSummary } from "./summary.js";

const by = (id) => document.getElementById(id);

class Report {
  /** @param asked  what the page's address asks for after '#': t, view, colour; still: see House */
  constructor(run, asked) {
    this.run = run;
    this.times = run.facts.times;
    this.last = this.times.length - 1;
    this.at = 0; // frame; between two while it plays
    this.playing = false;
    this.colours = colourings(run);
    // Figures and plots need no frames, and the plots reach as far as their rows.
    const ends = [this.times, ...run.facts.plots.map((p) => p.t)].map((t) => t.at(-1) ?? 0);
    this.from = this.times[0] ?? 0;
    this.until = Math.max(this.from, ...ends);
    this.plots = run.facts.plots.map((p) => this.#plot(p));
    by("title").textContent = document.title = run.facts.title;
    showSummary(by("summary"), run);
    by("status").textContent = this.last < 0 ? "The run has no frames." : "";
    if (this.last < 0) return;
    this.#build(asked.has("still"));
    by("time").max = this.last;
    this.#listen();
    this.#open(asked);
  }

  #plot(p) { return new Plot(by("plots"), p, this.from, this.until, (t) => this.seek(t)); }

  /** Where the browser cannot draw in three dimensions, the rest of the page is still there. */
  #build(still) {
    try {
      this.house = new House(by("view"), this.run, still);
    } catch (error) {
      if (still) throw error;
      by("status").textContent = `The house cannot be drawn: ${error.message}`;
    }
  }

  #listen() {
    by("time").addEventListener("input", (e) => this.show(Number(e.target.value)));
    by("play").addEventListener("click", () => this.play(!this.playing));
    by("colour").addEventListener("change", () => this.show(this.at));
    by("camera").addEventListener("change", (e) => this.house?.look(e.target.value));
    let down = [0, 0];
    by("view").addEventListener("pointerdown", (e) => (down = [e.clientX, e.clientY]));
    by("view").addEventListener("pointerup", (e) => {
      if (this.house && Math.hypot(e.clientX - down[0], e.clientY - down[1]) < 4) this.pick(this.house.pick(e.clientX, e.clientY));
    });
    document.addEventListener("keydown", (e) => this.#key(e));
  }

  #open(asked) {
    for (const [id, name] of [["camera", "view"], ["colour", "colour"]]) {
      const known = [...by(id).options].some((o) => o.value === asked.get(name));
      if (known) by(id).value = asked.get(name);
    }
    this.house?.look(by("camera").value);
    this.seek(Number(asked.get("t") ?? this.times[0]));
  }

  #key(event) {
    const step = event.shiftKey ? 10 : 1, here = Math.round(this.at);
    const to = { ArrowLeft: here - step, ArrowRight: here + step, Home: 0, End: this.last }[event.key];
    if (event.target.matches("select") || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === " " && !event.target.matches("button")) event.repeat || this.play(!this.playing);
    else if (to !== undefined) this.show(to);
    else return;
    event.preventDefault();
  }

  /** Shows frame `at`, which need not be whole. */
  show(at) {
    if (this.last < 0) return;
    this.at = Math.min(Math.max(at, 0), this.last);
    const { paint, legend, opened } = this.colours[by("colour").value];
    this.house?.show(this.at, paint, opened ? this.time() : undefined);
    if (this.legend !== legend) by("legend").innerHTML = this.legend = legend;
    const t = this.time();
    by("clock").textContent = `${t.toFixed(2)} s`;
    by("time").value = Math.round(this.at);
    by("time").setAttribute("aria-valuetext", `${t.toFixed(2)} seconds`);
    for (const plot of this.plots) plot.now(t);
    this.#describe();
  }

  time() {
    const f = Math.floor(this.at), g = Math.min(f + 1, this.last);
    return this.times[f] + (this.at - f) * (this.times[g] - this.times[f]);
  }

  seek(t) {
    const after = this.times.findIndex((x) => x >= t);
    this.show(after < 0 ? this.last : after);
  }

  /** A picture from one of the views at the frame nearest to time `t`: a PNG in base64, of so many pixels. */
  still(t, view, width, height) {
    const off = (f) => Math.abs(this.times[f] - t);
    this.show(this.times.reduce((best, _, f) => (off(f) < off(best) ? f : best), 0));
    return this.house.picture(view, width, height);
  }

  play(on) {
    this.playing = on;
    cancelAnimationFrame(this.next);
    by("play").textContent = on ? "Pause" : "Play";
    for (const id of ["clock", "picked"]) by(id).setAttribute("aria-live", on ? "off" : "polite"); // else every frame is read out
    if (!on) return;
    if (this.at >= this.last) this.show(0);
    let before = performance.now();
    const tick = (now) => {
      this.#advance(((now - before) / 1000) * Number(by("speed").value));
      before = now;
      if (this.at >= this.last) this.play(false);
      else this.next = requestAnimationFrame(tick);
    };
    this.next = requestAnimationFrame(tick);
  }

  /** Goes on by so many seconds of simulated time. */
  #advance(seconds) {
    let f = this.at, left = Math.max(0, seconds);
    while (f < this.last && left > 0) {
      const i = Math.floor(f), interval = this.times[i + 1] - this.times[i], rest = (i + 1 - f) * interval;
      if (left < rest) f += left / interval;
      else f = i + 1;
      left -= rest;
    }
    this.show(f);
  }

  /** Follows an element: its displacement over time as a plot. -1: none. */
  pick(element) {
    this.picked = element;
    this.own?.svg.parentElement.remove();
    this.plots = this.plots.filter((p) => p !== this.own);
    this.own = undefined;
    if (element >= 0) {
      const frames = this.run.frames, along = (k) => this.times.map((_, f) => frames.displacement(f, element, k));
      const plot = { title: `Displacement of element ${element}`, unit: "m", t: this.times, curves: ["x", "y", "z"].map((name, k) => ({ name, y: along(k) })) };
      this.own = this.#plot(plot);
      by("plots").prepend(this.own.svg.parentElement);
      this.plots.push(this.own);
    }
    this.show(this.at);
  }

  #describe() {
    const e = this.picked ?? -1, { frames, parts, facts } = this.run;
    by("picked").textContent = e < 0 ? "" : `Element ${e}, ${facts.parts[parts[e]]}: displaced ${frames.distance(this.at, e).toFixed(3)} m, ${Math.round(frames.broken(this.at)[e] / 2.55)} % of its bonds broken`;
  }
}

async function open() {
  const run = await loadRun();
  return (window.report = new Report(run, new URLSearchParams(location.hash.slice(1))));
}

window.opened = open();
window.opened.catch((error) => {
  by("status").textContent = `The page cannot be shown: ${error.message}`;
  throw error;
});
