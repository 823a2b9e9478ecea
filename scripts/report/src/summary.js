// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The figures of the run in words.

const count = (n) => n.toLocaleString("en");
const metres = (x) => `${x.toFixed(1)} m`;
const seconds = (t) => `${t.toFixed(2)} s`;

function rows({ facts, frames }) {
  const s = facts.summary, p = facts.provenance, has = (key) => s[key] !== undefined;
  return [
    ["Elements", count(frames.n)],
    has("finished") && ["Run", s.finished ? `finished at ${seconds(s.end_time)}` : "not finished"],
    has("first_crack_time") && ["First crack", s.first_crack_time < 0 ? "none" : seconds(s.first_crack_time)],
    has("collapse_time") && ["Collapsed", `at ${seconds(s.collapse_time)}`],
    has("collapsed") && !has("collapse_time") && ["Collapsed", s.collapsed ? "yes" : "no"],
    has("fallen_mass_fraction") && ["Fallen mass", `${(100 * s.fallen_mass_fraction).toFixed(1)} %`],
    has("debris_reach") && ["Debris beyond the walls", s.debris_reach > 0 ? `to ${metres(s.debris_reach)}` : "none"],
    s.debris_reach > 0 && ["… 95 % of it", s.debris_reach_95 > 0 ? `to ${metres(s.debris_reach_95)}` : "inside"],
    has("tension") && ["Sides broken in tension", count(s.tension)],
    has("shear") && ["… in shear", count(s.shear)],
    has("compression") && ["… in compression", count(s.compression)],
    has("peak_base_shear") && ["Peak base shear", `${(s.peak_base_shear / 1000).toFixed(1)} kN`],
    has("peak_speed") && ["Peak speed", `${s.peak_speed.toFixed(2)} m/s`],
    has("worst_residual") && ["Energy residual", s.worst_residual.toExponential(1)],
    p.version && ["Voussoir", p.version],
    p.wall_clock !== undefined && ["Wall-clock", `${count(Math.round(p.wall_clock))} s`],
    p.threads !== undefined && ["Threads", count(p.threads)],
    ["Positions within", `${((1000 * facts.quantum) / 2).toFixed(3)} mm`],
  ].filter(Boolean);
}

export function showSummary(parent, run) {
  const list = parent.appendChild(document.createElement("dl"));
  for (const [name, value] of rows(run)) {
    list.appendChild(document.createElement("dt")).textContent = name;
    list.appendChild(document.createElement("dd")).textContent = value;
  }
}
