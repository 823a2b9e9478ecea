// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
import { CrackTable } from "./cracktable.js";
import { CurvePlot } from "./curves.js";
import { loadRun } from "./data.js";
import { showLegend } from "./legend.js";
import { keepUp } from "./live.js";
import { drawOverlay } from "./overlay.js";
import { tiesAt } from "./ties.js";
import { loadsAt } from "./loads.js";
import { Pane } from "./pane.js";
import { compose, kPaper, Recorder } from "./pictures.js";
import { Plot } from "./plots.js";
import { Sheet } from "./sheet.js";
import { showSummary, subtitle } from "./summary.js";
import { showTimeline } from "./timeline.js";
import { cameraNumbers, cameraText, cornerOf } from "./views.js";

const by = (id) => document.getElementById(id);
/** Sets a text that has changed: the browser would lay the page out anew for the same one, too. */
function say(id, text) {
  if (by(id).textContent !== text) by(id).textContent = text;
}
const afterComma = (url) => url.slice(url.indexOf(",") + 1);
const kNight = { text: "#e8e6e2", rim: "rgba(20, 20, 22, 0.85)", arrow: "#7db7ff", hinge: "#b9c4ff", load: "#e5a8ff", tie: "#ffb454" };
// While it plays where the processor draws: only every so many frames the clock, the slider and the lines in the plots go on, and every so many
// times that values are read and the picture is written upon. What changes beside the house has to be painted, too.
const kStepped = 3, kSeldom = 3;

class Report {
  /** @param runs  one, or two to see side by side  @param asked  what the page's address asks for after '#': t, view or camera, colour, motion;
   *  still: see House */
  constructor(runs, asked) {
    this.runs = runs;
    const ends = runs.map((run) => run.facts.times.at(-1) ?? -Infinity);
    this.run = runs[ends.indexOf(Math.max(...ends))]; // its frames are those of the slider
    this.times = this.run.facts.times;
    this.last = this.times.length - 1;
    this.at = 0; // frame; between two while it plays
    this.playing = false;
    this.unsaid = this.unread = 0; // frames since the page was last written
    this.panes = [];
    this.dark = matchMedia("(prefers-color-scheme: dark)");
    this.#describeRun();
    by("status").textContent = "";
    this.#build(asked);
    by("time").max = this.last;
    this.#listen();
    this.#open(asked);
  }

  /** Figures and plots need no frames, and the plots reach as far as their rows. */
  #describeRun() {
    const { runs } = this, ends = runs.flatMap(({ facts }) => [facts.times, ...facts.plots.map((p) => p.t)]).map((t) => t.at(-1) ?? 0);
    this.from = this.times[0] ?? 0;
    this.until = Math.max(this.from, ...ends);
    by("title").textContent = document.title = runs.map((run, i) => (runs.length > 1 ? `${"AB"[i]}: ` : "") + run.facts.title).join("  |  ");
    by("subtitle").textContent = runs.map((run) => subtitle(run) + (run.facts.model ? " · the model, before it moves" : "")).filter((text, i, all) => all.indexOf(text) === i).join("  |  ");
    showSummary(by("keys"), by("summary"), by("provenance").lastElementChild, runs);
    this.crackTables = runs.map((run, i) => run.crackList?.cracks.length > 0 && new CrackTable(by("summary"), run.crackList, runs.length > 1 ? "AB"[i] : "", (t) => this.seek(t)));
    const titles = [...new Set(runs.flatMap((run) => run.facts.plots.map((p) => p.title)))];
    this.plots = titles.map((title) => {
      const plots = runs.map((run) => run.facts.plots.find((p) => p.title === title)), seek = (t) => this.seek(t);
      return plots.find(Boolean).x ? new CurvePlot(by("plots"), plots, seek) : new Plot(by("plots"), plots, this.from, this.until, seek);
    });
    const end = this.times.at(-1) ?? this.until; // of the slider
    showTimeline(by("bands"), by("ticks"), this.run.facts, this.from, end, (t) => this.seek(t));
  }

  /** Where the browser cannot draw in three dimensions, the rest of the page is still there. */
  #build(asked) {
    const still = asked.has("still");
    try {
      const first = document.querySelector(".pane");
      const blank = first.cloneNode(true);
      blank.querySelector(".view").removeAttribute("id");
      this.runs.forEach((run, i) => {
        const element = i === 0 ? first : by("panes").appendChild(blank);
        if (this.runs.length > 1) element.appendChild(Object.assign(document.createElement("div"), { className: "letter", textContent: "AB"[i] }));
        const pane = new Pane(run, element, still && !asked.has("film"));
        pane.letter = element.querySelector(".letter");
        pane.house.onDraw = () => this.#overlay(pane);
        pane.house.onTurn = () => this.#turned(pane);
        pane.house.onResize = () => this.#resized(pane);
        this.panes.push(pane);
      });
      this.pane = this.panes.find((p) => p.run === this.run);
      this.house = this.pane.house;
      this.modes = this.runs.length === 1 ? this.run.modes : undefined;
      this.modes?.names().forEach((name, i) => by("mode").add(new Option(name, i)));
      by("mode").parentElement.hidden = !this.modes;
      by("ties").parentElement.hidden = !this.runs.some((run) => run.ties || run.bars);
      by("shake").parentElement.hidden = !this.runs.some((run) => run.facts.ground?.length > 0);
      if (this.run.frames.bodies) by("colour").add(new Option("bodies that move as one", "bodies"));
      if (this.run.model) {
        document.body.classList.add("model"); // a model that does not run has no clock
        by("colour").replaceChildren(new Option("material", "material"), new Option("joints by law", "law"), new Option("supports", "support"), new Option("part", "part"));
        if (this.run.model.fault) by("fault").textContent = this.run.model.fault, by("camera").value = cornerOf(this.run.model.faults, this.run.frames.centroids);
      }
      this.#dress(still);
      for (const { house } of this.panes) house.resize();
    } catch (error) {
      if (still) throw error;
      by("status").textContent = `The house cannot be drawn: ${error.message}`;
    }
  }

  #dress(still) {
    this.still_ = still || this.still_;
    if (this.still_) document.body.style.visibility = "hidden"; // pictures are made elsewhere; painting the page would only take time
    this.ink = this.dark.matches && !this.still_ ? kNight : kPaper;
    for (const { house } of this.panes) house.dress(this.dark.matches && !this.still_);
  }

  /** Two houses are seen with one camera. */
  #turned(from) {
    if (this.turning) return;
    this.turning = true;
    for (const { house } of this.panes.filter((pane) => pane !== from)) {
      if (from.house.turns) house.turnsByHand();
      house.place(from.house.placed);
    }
    this.turning = false;
    if (this.opened && !this.looking && by("camera").value !== "free") by("camera").value = "free";
    this.#remember();
  }

  /** A view named is fitted anew to the room there is; a camera turned by hand stays. */
  #resized(pane) {
    if (this.opened && !this.composing && by("camera").value !== "free") this.look(by("camera").value);
    else pane.house.draw();
  }

  look(view) {
    this.looking = true;
    const camera = [];
    for (const { house } of this.panes) {
      this.turning = true;
      house.look(view);
      camera.push(house.placed);
    }
    this.turning = false;
    const far = camera.map((c) => Math.hypot(c[0] - c[3], c[1] - c[4], c[2] - c[5])); // the farther of two sees both whole
    for (const { house } of this.panes) if (this.panes.length > 1) house.place(camera[far.indexOf(Math.max(...far))]);
    by("roofless").checked = view === "plan";
    this.looking = false;
    this.#remember();
  }

  #listen() {
    const { panes } = this, redraw = () => this.redraw(), houses = (act) => () => (panes.forEach(({ house }) => act(house)), redraw());
    by("time").addEventListener("input", (e) => this.show(Number(e.target.value)));
    by("play").addEventListener("click", () => this.play(!this.playing));
    for (const id of ["colour", "magnify", "names", "ties", "shake"]) by(id).addEventListener("change", redraw);
    by("mode").addEventListener("change", () => (this.redraw(), this.play(this.mode !== null)));
    by("camera").addEventListener("change", (e) => this.look(e.target.value));
    by("roofless").addEventListener("change", houses((house) => house.hideRoof(by("roofless").checked)));
    by("rooms").addEventListener("change", houses((house) => house.around.rooms && (house.around.rooms.visible = by("rooms").checked)));
    for (const id of ["section", "cut"]) by(id).addEventListener("input", houses((house) => house.cut(by("section").value === "" ? null : { axis: Number(by("section").value), at: by("cut").value / 100 })));
    by("record").addEventListener("click", () => this.record(!this.recorder));
    this.dark.addEventListener("change", () => (this.#dress(), this.plots.forEach((p) => p.dress()), redraw()));
    panes.forEach((pane) => pane.listen((element) => this.pick(element, pane)));
    document.addEventListener("keydown", (e) => this.#key(e));
  }

  #open(asked) {
    const old = { faces: "cracks" }; // a name of earlier versions
    for (const [id, name] of [["camera", "view"], ["colour", "colour"], ["magnify", "motion"]]) {
      const value = old[asked.get(name)] ?? asked.get(name);
      if ([...by(id).options].some((o) => o.value === value)) by(id).value = value;
    }
    const camera = cameraNumbers(asked.get("camera"));
    if (by("camera").value === "free") by("camera").value = "corner";
    this.seek(Number(asked.get("t") ?? (this.still_ ? null : this.run.facts.worst?.time) ?? this.times[0]));
    this.opens = asked.has("t") ? -1 : this.at; // where nobody has gone to: Play begins at the beginning
    this.look(by("camera").value);
    this.opened = true;
    if (camera) this.house?.place(camera);
  }

  /** Keeps time, colours and camera in the page's address, once it is at rest. */
  #remember() {
    if (!this.opened || this.still_) return;
    clearTimeout(this.remembering);
    this.remembering = setTimeout(() => {
      const parts = [`t=${+this.time().toFixed(3)}`, `colour=${by("colour").value}`, by("magnify").value !== "auto" && `motion=${by("magnify").value}`];
      parts.push(by("camera").value === "free" ? `camera=${cameraText(this.house.placed)}` : `view=${by("camera").value}`);
      history.replaceState(null, "", "#" + parts.filter(Boolean).join("&"));
    }, 400);
  }

  #key(event) {
    const step = event.shiftKey ? 10 : 1, here = Math.round(this.at);
    const to = { ArrowLeft: here - step, ArrowRight: here + step, Home: 0, End: this.last }[event.key];
    if (event.target.matches("select, #cut") || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === " " && !event.target.matches("button, summary, input[type=checkbox]")) event.repeat || this.play(!this.playing);
    else if (to !== undefined) this.show(to);
    else return;
    event.preventDefault();
  }

  /** Shows frame `at` of the run whose frames are on the slider; it need not be whole. */
  show(at) {
    this.at = Math.min(Math.max(at, 0), this.last);
    by("mode").value = "";
    const t = this.time(), name = by("colour").value, size = by("magnify").value;
    let large = 1;
    for (const pane of this.panes) {
      const own = pane === this.pane ? this.at : pane.frameAt(t);
      large = size === "auto" ? this.pane.magnify(t) : Number(size);
      if (by("follow").checked && pane.picked >= 0) pane.house.follow(pane.picked);
      pane.house.shake(by("shake").checked ? pane.groundWay(own) : [0, 0, 0]);
      pane.house.show(own, pane.colours[name] ?? pane.colours.cracks, t, large);
      if (pane.letter) pane.letter.textContent = pane.label("AB"[this.panes.indexOf(pane)], t);
    }
    this.large = large;
    say("note", large === 1 ? "" : `motion × ${+large.toPrecision(2)}`);
    this.#legend(name);
    if (this.still_) return; // nobody looks at the page
    if (!this.playing || !this.house?.software || ++this.unsaid >= kStepped) this.#say(t);
    this.recorder?.shot();
  }

  /** The mode that is shown, or null. */
  get mode() { return by("mode").value === "" ? null : Number(by("mode").value); }

  redraw() {
    if (this.mode === null) return this.show(this.at);
    const { house, colours } = this.pane, colouring = colours[by("colour").value] ?? colours.cracks, largest = this.modes.largest(house.size, by("magnify").value);
    house.shake([0, 0, 0]);
    house.showMode(this.modes, this.mode, largest, colouring.steady ? colouring : colours.cracks);
    say("note", `mode ${this.modes.names()[this.mode]} · as built, largest motion ${Math.round(1000 * largest)} mm`);
    this.recorder?.shot();
  }

  /** What stands beside the house at a moment: clock, slider, plots, the element picked, the address. */
  #say(t) {
    this.unsaid = 0;
    say("clock", `${t.toFixed(2)} s`);
    by("time").value = Math.round(this.at);
    by("time").setAttribute("aria-valuetext", `${t.toFixed(2)} seconds`);
    const read = !this.playing || !this.house?.software || ++this.unread >= kSeldom;
    if (read) this.unread = 0;
    for (const plot of this.plots) plot.now(t, read);
    if (read) this.crackTables.forEach((table, i) => table && table.now(this.panes[i]?.house.at ?? this.at));
    this.#describe();
    this.#remember();
  }

  #legend(name) {
    if (!this.pane) return;
    const entries = (this.pane.colours[name] ?? this.pane.colours.cracks).legend(this.at), key = JSON.stringify(entries);
    if (key !== this.legendKey) showLegend(by("legend"), entries);
    this.legendKey = key;
    this.legend = entries;
  }

  #overlayOf(pane) {
    const t = this.time(), plan = pane.house.view === "plan";
    return { names: by("names").checked && !plan, loads: this.mode === null ? loadsAt(pane) : null, ties: by("ties").checked && this.mode === null ? tiesAt(pane, t) : null, ground: this.mode === null ? pane.groundAt(t) : null, distances: plan, hinges: by("colour").value === "bodies" && this.mode === null ? pane.run.frames.bodies?.hinges(pane.house.at, (e, p) => pane.house.carried(e, p)) : null };
  }

  #overlay(pane) {
    if (this.composing) return;
    // While it plays, writing it all at every frame would take as long as the house.
    const camera = cameraText([...pane.house.camera.position, ...pane.house.controls.target]);
    if (this.playing && camera === pane.written && ++pane.unwritten < kStepped * kSeldom) return;
    pane.written = camera, pane.unwritten = 0;
    const ratio = Math.min(window.devicePixelRatio, 2), { clientWidth: width, clientHeight: height } = pane.element;
    pane.sheet ??= new Sheet(pane.element.querySelector(".overlay"));
    pane.sheet.draw(width, height, ratio, (c) => drawOverlay(c, pane.house, width, height, 13, this.#overlayOf(pane), this.ink));
  }

  time() {
    const f = Math.floor(this.at), g = Math.min(f + 1, this.last);
    return this.times[f] + (this.at - f) * (this.times[g] - this.times[f]);
  }

  seek(t) {
    const after = this.times.findIndex((x) => x >= t - 1e-9);
    this.show(after < 0 ? this.last : after);
  }

  #caption() {
    const time = this.time();
    const moves = !this.run.model; // a model has no clock, and nothing is magnified
    return { title: by("title").textContent, subtitle: by("subtitle").textContent, clock: moves ? `${time.toFixed(2)} s` : "", note: moves ? by("note").textContent : "", legend: this.legend };
  }

  /** Draws a picture at the time `t`; returns its canvas. @param view  one of the views; null: the camera as it is  @param between  whether
   *  elements are put between two frames; else the nearest frame is shown */
  #picture(t, view, width, height, between) {
    const off = (f) => Math.abs(this.times[f] - t);
    this.composing = true;
    for (const { house } of this.panes) house.fixed = true;
    if (this.sized !== `${width} ${height}`) for (const { house } of this.panes) house.fitTo(width / this.panes.length, height, 1);
    this.sized = `${width} ${height}`;
    if (between && view) this.show(this.last), this.look(view), (view = null); // a film has room for the debris from its beginning
    this.show(between ? this.pane.frameAt(t) : this.times.reduce((best, _, f) => (off(f) < off(best) ? f : best), 0));
    // What was drawn last is still in the canvas: drawImage follows at once.
    if (view) this.look(view);
    const canvas = (this.paper ??= document.createElement("canvas"));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    compose(canvas.getContext("2d", { willReadFrequently: true }), this.panes, this.#caption(), (pane) => this.#overlayOf(pane));
    this.composing = false;
    return canvas;
  }

  /** A PNG in base64 from one of the views at the frame nearest to time `t`, with title, time, scale and legend. */
  still(t, view, width, height) {
    const png = afterComma(this.#picture(t, view, width, height, false).toDataURL("image/png"));
    if (!this.still_) {
      this.sized = "";
      for (const { house } of this.panes) house.fixed = false, house.resize();
    }
    return png;
  }

  /** A JPEG in base64 of a film: the first from the view named, all others from where that was seen. @param next  the time of the picture that
   *  will be asked for next, if there is one: it is drawn while this one is packed */
  async shot(t, view, width, height, next) {
    const jpeg = (time, from) => new Promise((done) => this.#picture(time, from, width, height, true).toBlob(done, "image/jpeg", 0.95));
    const asked = this.ahead?.t === t ? this.ahead.jpeg : jpeg(t, view);
    this.ahead = next === undefined ? null : { t: next, jpeg: jpeg(next, null) };
    const blob = await asked, reader = new FileReader();
    return new Promise((done) => (reader.addEventListener("load", () => done(afterComma(reader.result))), reader.readAsDataURL(blob)));
  }

  play(on) {
    this.playing = on;
    cancelAnimationFrame(this.next);
    for (const { house } of this.panes) house.moving = on;
    by("play").textContent = on ? "Pause" : "Play";
    for (const id of ["clock", "picked"]) by(id).setAttribute("aria-live", on ? "off" : "polite"); // else every frame is read out
    if (!on) {
      if (this.recorder) this.record(false);
      return this.redraw();
    }
    if ((this.at >= this.last || this.at === this.opens) && this.mode === null) this.show(0);
    this.opens = -1;
    let before = performance.now();
    const tick = (now) => {
      const seconds = ((now - before) / 1000) * Number(by("speed").value);
      before = now;
      if (this.mode !== null) this.modes.advance(seconds), this.redraw();
      else this.#advance(seconds);
      if (this.at >= this.last && this.mode === null) this.play(false);
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

  /** Plays and writes what is seen into a film, which the browser then saves. */
  record(on) {
    by("record").textContent = on ? "Stop recording" : "Record a film";
    if (on) {
      const stage = by("stage"), draw = (c) => (this.panes.forEach(({ house }) => house.render()), compose(c, this.panes, this.#caption(), (pane) => this.#overlayOf(pane)));
      this.recorder = new Recorder(stage.clientWidth, stage.clientHeight, draw, (film) => this.#save(film));
      if (!this.playing) this.play(true);
    } else {
      const { recorder } = this;
      this.recorder = null;
      recorder?.stop();
      if (this.playing) this.play(false);
    }
  }

  #save(film) {
    this.film = film;
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(film), download: `${this.run.facts.title.split(":")[0].toLowerCase() || "voussoir"}.webm` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  /** Lights up an element, with its displacement over time as the first plot. -1: none. */
  pick(element, pane = this.pane) {
    for (const p of this.panes) p.picked = p === pane ? element : -1, p.house.followed = null, p.house.lightUp(p.picked);
    this.picked = pane;
    this.own?.remove();
    this.plots = this.plots.filter((p) => p !== this.own);
    this.own = undefined;
    if (element >= 0) {
      const { frames } = pane.run, along = (k) => pane.times.map((_, f) => 1000 * frames.displacement(f, element, k));
      const plot = { title: `Displacement of element ${element}`, unit: "mm", t: pane.times, curves: ["x", "y", "z"].map((name, k) => ({ name, y: along(k) })) };
      this.own = new Plot(by("plots"), [plot], this.from, this.until, (t) => this.seek(t));
      by("plots").prepend(this.own.figure);
      this.own.figure.scrollIntoView({ block: "nearest" });
      this.plots.push(this.own);
    }
    this.show(this.at);
  }

  #describe() {
    const pane = this.picked, e = pane?.picked ?? -1;
    if (e < 0) return say("picked", "");
    const { frames, parts, facts } = pane.run, at = pane.house.at;
    say("picked", `Element ${e}, ${facts.parts[parts[e]]}: displaced ${(1000 * frames.distance(at, e)).toFixed(1)} mm, ${Math.round(frames.broken(at)[e] / 2.55)} % of its bonds broken`);
  }
}

async function open() {
  const runs = [await loadRun(), await loadRun("second-")].filter(Boolean);
  return (window.report = new Report(runs, new URLSearchParams(location.hash.slice(1))));
}

window.opened = open();
window.opened.then(keepUp).catch((error) => {
  by("status").textContent = `The page cannot be shown: ${error.message}`;
  throw error;
});
