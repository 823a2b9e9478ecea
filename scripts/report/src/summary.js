// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The figures of the run in words.

const count = (n) => n.toLocaleString("en");
const metres = (x) => `${x.toFixed(1)} m`;
const millimetres = (x) => `${(1000 * x).toFixed(2)} mm`;
const seconds = (t) => `${t.toFixed(2)} s`;

const percent = (x) => (x === null ? "–" : `${(100 * x).toFixed(1)} %`);
const when = (t) => (t < 0 ? "never" : seconds(t));

function grade(m) {
  if (m.damage_grade < 0) return "–"; // there are no walls
  return m.damage_grade === 0 ? "G0" : `G${m.damage_grade} from ${seconds(m.grade_time[m.damage_grade - 1])}`;
}

/** How deep bodies were in each other. */
function penetration(m) {
  return [
    ["Deepest in another", `${millimetres(m.penetration)}, at most ${millimetres(m.peak_penetration)}` + (m.peak_penetration_time < 0 ? "" : ` at ${seconds(m.peak_penetration_time)}`)],
    m.peak_penetration_pair && ["… of", m.peak_penetration_pair],
    m.deep_pairs >= 0 && ["… over half a segment", `${count(m.deep_pairs)} pairs, at most ${count(m.most_deep_pairs)}`],
    ["Pairs that touch", count(m.touching_pairs)],
  ];
}

/** How the building fell; nothing if the run does not say. */
function collapse(m, collapsed) {
  if (!m) return [];
  return [
    ["Damage grade (EMS-98)", grade(m)],
    ["Collapsed", m.collapse_time < 0 ? (collapsed ? "yes" : "no") : `at ${seconds(m.collapse_time)}`],
    ["First fallen", when(m.first_fallen_time)],
    m.first_fallen_wall && ["… of the walls", m.first_fallen_wall],
    ["Debris beyond the walls", m.debris_reach > 0 ? `to ${metres(m.debris_reach)}` : "none"],
    m.debris_reach > 0 && ["… 95 % of it", m.debris_reach_95 > 0 ? `to ${metres(m.debris_reach_95)}` : "inside"],
    ["Debris covers", `${m.debris_area.toFixed(1)} m²`],
    m.free_volume !== null && ["Volume left under the roof", percent(m.free_volume)],
    ...penetration(m),
  ];
}

function rows({ facts, frames }) {
  const s = facts.summary, p = facts.provenance, has = (key) => s[key] !== undefined;
  return [
    ["Elements", count(frames.n)],
    has("finished") && ["Run", s.finished ? `finished at ${seconds(s.end_time)}` : "not finished"],
    has("first_crack_time") && ["First crack", s.first_crack_time < 0 ? "none" : seconds(s.first_crack_time)],
    !facts.measures && has("collapsed") && ["Collapsed", s.collapsed ? "yes" : "no"],
    has("fallen_mass_fraction") && ["Fallen mass", percent(s.fallen_mass_fraction)],
    ...collapse(facts.measures, s.collapsed),
    has("first_tension") && ["Sides reached first: tension", count(s.first_tension)],
    has("first_shear") && ["… shear", count(s.first_shear)],
    has("first_compression") && ["… compression", count(s.first_compression)],
    has("tension") && ["Sides opened by tension", count(s.tension)],
    has("shear") && ["… by shear", count(s.shear)],
    has("compression") && ["… by compression", count(s.compression)],
    has("peak_base_shear") && ["Peak base shear", `${(s.peak_base_shear / 1000).toFixed(1)} kN`],
    has("peak_speed") && ["Peak speed", `${s.peak_speed.toFixed(2)} m/s`],
    has("worst_residual") && ["Energy residual", s.worst_residual.toExponential(1)],
    p.version && ["Voussoir", p.version],
    p.wall_clock !== undefined && ["Wall-clock", `${count(Math.round(p.wall_clock))} s`],
    p.threads !== undefined && ["Threads", count(p.threads)],
    ["Positions within", `${((1000 * facts.quantum) / 2).toFixed(3)} mm`],
  ].filter(Boolean);
}

/** A row for each wall, and the roof: what has fallen of it, since when, how far it leaned. */
function showParts(parent, m) {
  const table = parent.appendChild(document.createElement("table"));
  const add = (kind, cells) => {
    const row = table.appendChild(document.createElement("tr"));
    for (const text of cells) row.appendChild(document.createElement(kind)).textContent = text;
  };
  add("th", ["", "fallen", "first", "peak drift", "at the end"]);
  for (const w of m.walls)
    add("td", [w.name, percent(w.fallen_mass_fraction), when(w.first_fallen_time), percent(w.peak_drift), percent(w.residual_drift)]);
  if (m.roof_fallen_mass_fraction !== null) add("td", ["roof", percent(m.roof_fallen_mass_fraction), when(m.roof_first_fallen_time), "", ""]);
}

export function showSummary(parent, run) {
  const list = parent.appendChild(document.createElement("dl"));
  for (const [name, value] of rows(run)) {
    list.appendChild(document.createElement("dt")).textContent = name;
    list.appendChild(document.createElement("dd")).textContent = value;
  }
  if (run.facts.measures?.walls.length > 0) showParts(parent, run.facts.measures);
}
