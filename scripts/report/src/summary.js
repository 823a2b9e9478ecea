// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The figures of the run in words: what matters most, large; the rest in tables; where the numbers come from, folded away.
import { capacityKeys, capacityTable, limitTable } from "./capacity.js";
import { loadTables, storeyTables, tieTables } from "./members.js";
import { kGrades } from "./timeline.js";

const count = (n) => n.toLocaleString("en");
const metres = (x) => `${x.toFixed(1)} m`;
const millimetres = (x) => `${(1000 * x).toFixed(2)} mm`;
const seconds = (t) => `${t.toFixed(2)} s`;
const percent = (x) => (x === null || x === undefined ? "–" : `${(100 * x).toFixed(1)} %`);
const hundredths = (x) => `${(100 * x).toFixed(2).replace(/^-(?=[0.]*$)/, "")} %`; // no sign for a zero
const when = (t) => (t === undefined ? "–" : t < 0 ? "never" : seconds(t));

/** "LTV of bam-like, peaks 7.81, 6.23, 9.81 m/s² along x, y, z" */
export function subtitle({ facts }) {
  const m = facts.motion;
  if (!m) return facts.capacity ? `${facts.capacity.kind}, ended by: ${facts.capacity.ended}` : "no ground motion";
  const short = (x) => String(+x.toPrecision(3)), scale = new Set(m.scale).size === 1 ? short(m.scale[0]) : m.scale.map(short).join(", ");
  return [
    m.direction ? `${m.record}, ${m.direction} along x, y, z` : m.record,
    `scale ${scale}`,
    m.peak && `peaks ${m.peak.map((a) => a.toFixed(1)).join(", ")} m/s²${m.until === undefined ? "" : ` up to ${m.until.toFixed(1)} s, where the run ends`}`,
  ].filter(Boolean).join(" · ");
}

/** The rows whose figures are left to chance have a mark. */
const marked = (m, chance, rows) => rows.map((row) => (row && m?.chance && chance.some((name) => row[0].includes(name)) ? [row[0], `${row[1]} *`, ...row.slice(2)] : row));
const kChance = ["Fallen mass", "Debris", "95 % of it", "Volume left", "Slip of beams", "… the largest", "… seats lost", "storey drift", "drift out of", "gable's", "Worst moment", "Deepest", "… of", "half a segment", "that touch", "compression", "base shear", "Peak speed"];

/** How deep bodies were in each other. */
function penetration(m) {
  return [
    ["Deepest in another", `${millimetres(m.penetration)}, at most ${millimetres(m.peak_penetration)}` + (m.peak_penetration_time < 0 ? "" : ` at ${seconds(m.peak_penetration_time)}`)],
    m.peak_penetration_pair && ["… of", m.peak_penetration_pair],
    m.deep_pairs >= 0 && ["… over half a segment", `${count(m.deep_pairs)} pairs, at most ${count(m.most_deep_pairs)}`],
    ["Pairs that touch", count(m.touching_pairs)],
  ];
}

/** What a run that is not at its end has come to: [in a word, where and why]. */
const runEnd = (s) => [s.failure ? "lost" : "not finished", [s.place, s.failure].filter(Boolean).join(": ")];

/** What stands in large type: [name, value, small print]. */
function keys({ facts }) {
  const s = facts.summary, m = facts.measures, g = m?.damage_grade ?? -1, last = facts.times.at(-1);
  return marked(m, kChance, [
    !s.finished && ["Run", ...runEnd(s)],
    ...capacityKeys(facts.capacity),
    g >= 0 && ["Damage grade", `G${g}`, `${kGrades[g]}${g > 0 ? `, from ${g <= m.settling_damage_grade ? "settling" : seconds(m.grade_time[g - 1])}` : ""}`],
    ["Collapse", m?.collapse_time >= 0 ? seconds(m.collapse_time) : (s.collapsed ?? m?.collapsed ? "yes" : "no"), s.finished ? `at the end, ${seconds(s.end_time ?? last)}` : `${s.failure ? "up to where the run was lost" : "so far"}, at ${seconds(s.end_time ?? last ?? 0)}`],
    ["First fall", when(m?.first_fallen_time), m?.first_fallen_wall || (m?.first_fallen_time >= 0 ? "" : "nothing has fallen")],
    facts.worst && ["Worst moment", seconds(facts.worst.time), `${facts.worst.name}: ${facts.worst.what}`],
    ["Fallen mass", percent(s.fallen_mass_fraction ?? m?.fallen_mass_fraction), (s.first_crack_time ?? m?.first_crack_time) >= 0 ? `first crack ${seconds(s.first_crack_time ?? m.first_crack_time)}` : m?.settling_cracks > 0 ? "cracks from settling alone" : "no crack"],
  ].filter(Boolean));
}

function damage({ facts }) {
  const s = facts.summary, m = facts.measures, has = (key) => s[key] !== undefined;
  return marked(m, kChance, [
    has("first_crack_time") && ["First crack", when(s.first_crack_time)],
    m?.settling_cracks !== undefined && ["Segments broken by settling", count(m.settling_cracks)],
    m?.shaking_cracks !== undefined && ["… by the shaking", count(m.shaking_cracks)],
    m && ["Debris beyond the walls", m.debris_reach > 0 ? `to ${metres(m.debris_reach)}` : "none"],
    m?.debris_reach > 0 && ["… 95 % of it", m.debris_reach_95 > 0 ? `to ${metres(m.debris_reach_95)}` : "inside"],
    m && ["Debris covers", `${m.debris_area.toFixed(1)} m²`],
    m && m.free_volume !== null && ["Volume left under the roof", percent(m.free_volume)],
    m && m.peak_storey_drift !== null && m.peak_storey_drift !== undefined && ["Largest storey drift along a wall", `${(100 * m.peak_storey_drift).toFixed(2)} %, ${m.peak_storey_drift_wall}`],
    m && m.peak_drift !== null && m.peak_drift_wall && ["Largest drift out of a wall's plane", `${hundredths(m.peak_drift)}, ${m.peak_drift_wall}`],
    m?.peak_gable && ["… of a gable's", `${hundredths(m.peak_gable_drift)}, ${m.peak_gable}`],
    m?.peak_seat_slip > 0 && ["Slip of beams on walls", `at most ${millimetres(m.peak_seat_slip)} at ${seconds(m.peak_seat_slip_time)}${m.seat_slip === null ? "" : `, ${millimetres(m.seat_slip)} at the end`}`],
    m?.peak_seat_slip > 0 && ["… the largest", m.peak_seat_slip_place],
    m?.lost_seats > 0 && ["… seats lost", count(m.lost_seats)],
    ...(m ? penetration(m) : []),
    has("first_tension") && ["Contact points that failed first in tension", count(s.first_tension)],
    has("first_shear") && ["… first in shear", count(s.first_shear)],
    has("first_compression") && ["… first in compression", count(s.first_compression)],
    has("tension") && ["Contact points opened by tension", count(s.tension)],
    has("shear") && ["… by shear", count(s.shear)],
    has("compression") && ["… by compression", count(s.compression)],
    has("peak_base_shear") && ["Peak base shear", `${(s.peak_base_shear / 1000).toFixed(1)} kN`],
    has("peak_speed") && ["Peak speed", `${s.peak_speed.toFixed(2)} m/s`],
  ].filter(Boolean));
}

function provenance({ facts, frames }) {
  const s = facts.summary, p = facts.provenance;
  return [
    ["Elements", count(frames.n)],
    ["Run", s.finished ? `finished at ${seconds(s.end_time)}` : runEnd(s).join(" ")],
    s.worst_residual !== undefined && ["Energy error, largest, of all energy", s.worst_residual.toExponential(1)],
    p.version && ["Voussoir", p.version],
    p.compiler && ["Compiler", p.compiler],
    p.cpu && ["Processor", p.cpu],
    p.started && ["Started", p.started],
    p.wall_clock !== undefined && ["Wall-clock", `${count(Math.round(p.wall_clock))} s`],
    p.threads !== undefined && ["Threads", count(p.threads)],
    facts.every > 1 && ["Frames in this page", `one of ${count(facts.every)}`],
    facts.origin && ["Coordinates in this page from", `${facts.origin.join(", ")} m of the case's axes`],
    ["Positions in this page within", `${((1000 * facts.quantum) / 2).toFixed(3)} mm`],
  ].filter(Boolean);
}

function table(parent, head, rows, caption) {
  const t = parent.appendChild(document.createElement("table"));
  t.createCaption().textContent = caption;
  const add = (kind, cells) => {
    const row = t.appendChild(document.createElement("tr"));
    cells.forEach((text, i) => {
      const cell = row.appendChild(document.createElement(kind === "th" || i === 0 ? "th" : "td"));
      cell.textContent = text;
      if (text.length > 16) cell.className = "long";
      if (cell.tagName === "TH") cell.scope = kind === "th" ? "col" : "row";
    });
  };
  if (head) add("th", head);
  for (const cells of rows) add("td", cells);
}

/** A row for each wall, and the roof: what has fallen of it, since when, how far it leaned. */
function partsTable(parent, m, caption) {
  const drift = (x) => (x === null ? "–" : Math.abs(x) > 0.25 ? "fell" : hundredths(x)), rows = m.walls.map((w) => [w.name, percent(w.fallen_mass_fraction), when(w.first_fallen_time), drift(w.peak_drift), drift(w.residual_drift)]);
  if (m.roof_fallen_mass_fraction !== null) rows.push(["roof", percent(m.roof_fallen_mass_fraction), when(m.roof_first_fallen_time), "", ""]);
  table(parent, ["part", "fallen", "first", "peak drift", "at the end"], rows, caption);
}

/** Rows of two runs side by side, with what differs marked. */
function both(runs, rowsOf) {
  const maps = runs.map((run) => new Map(rowsOf(run))), names = [...new Set(maps.flatMap((m) => [...m.keys()]))];
  return names.map((name) => [name, ...maps.map((m) => m.get(name) ?? "–")]);
}

/** A key figure: its name, and lines of text by their class. */
function tile(parent, name, lines) {
  const div = parent.appendChild(document.createElement("div"));
  div.appendChild(document.createElement("dt")).textContent = name;
  for (const [className, textContent] of lines) div.appendChild(Object.assign(document.createElement("dd"), { className, textContent }));
}

/** @param runs  one, or two side by side */
export function showSummary(top, rest, folded, runs) {
  if (runs.length === 1) for (const [name, value, small] of keys(runs[0])) tile(top, name, [["large", value], ["small", small]]);
  else for (const [name, ...values] of both(runs, keys)) tile(top, name, values.map((value, i) => ["run", `${"AB"[i]} ${value}`]));
  if (runs.some((run) => run.facts.capacity)) table(rest, runs.length > 1 ? ["", "A", "B"] : null, both(runs, capacityTable).map(mark), "Capacity");
  if (runs.some((run) => run.facts.limit)) table(rest, runs.length > 1 ? ["", "A", "B"] : null, both(runs, limitTable).map(mark), "Second opinion: limit analysis");
  table(rest, runs.length > 1 ? ["", "A", "B"] : null, both(runs, damage).map(mark), "Damage");
  runs.forEach((run, i) => run.facts.measures?.walls.length > 0 && partsTable(rest, run.facts.measures, runs.length > 1 ? `Walls and roof, ${"AB"[i]}` : "Walls and roof"));
  runs.forEach((run, i) => {
    for (const [caption, head, rows] of [...storeyTables(run.facts.measures), ...tieTables(run.facts.measures), ...loadTables(run.facts.measures)]) table(rest, head, rows, runs.length > 1 ? `${caption}, ${"AB"[i]}` : caption);
  });
  runs.forEach((run, i) => {
    const note = run.facts.measures?.chance?.note;
    if (note) rest.appendChild(Object.assign(document.createElement("p"), { className: "chance", textContent: `* ${runs.length > 1 ? `${"AB"[i]}: ` : ""}${note}` }));
  });
  table(folded, runs.length > 1 ? ["", "A", "B"] : null, both(runs, provenance), "Where the numbers come from");
}

/** The name of a row in which two runs differ has a mark. */
const mark = ([name, ...values]) => [values.length > 1 && new Set(values).size > 1 ? `${name} ≠` : name, ...values];
