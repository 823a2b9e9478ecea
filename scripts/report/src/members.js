// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Drift of each storey by wall; rods, decks and meshes with force, elongation, utilisation; loads with the displacement of their places.
const is = (x) => x !== null && x !== undefined;
const shown = (x, digits) => x.toFixed(digits).replace(/^-(?=[0.]*$)/, ""); // no sign for a zero
const percent = (x, digits = 2) => (is(x) ? `${shown(100 * x, digits)} %` : "–");
const millimetres = (x) => (is(x) ? `${shown(1000 * x, Math.abs(x) < 1e-3 ? 2 : 1)} mm` : "–");
const kWild = 0.25; // beyond it a wall is falling
const drift = (x) => (is(x) && Math.abs(x) > kWild ? "fell" : percent(x));

/** [caption, head, rows] of each storey. */
export function storeyTables(m) {
  const storeys = new Map();
  for (const w of m?.walls ?? []) is(w.storey) && storeys.set(w.storey, [...(storeys.get(w.storey) ?? []), w]);
  return [...storeys].sort(([a], [b]) => a - b).map(([storey, walls]) => {
    const foot = Math.min(...walls.map((w) => w.foot)), top = Math.max(...walls.map((w) => w.top)), bears = walls.some((w) => is(w.peak_seat_slip));
    const rows = walls.map((w) => [w.name.replace(/, storey \d+/, ""), drift(w.peak_storey_drift), drift(w.residual_storey_drift), drift(w.peak_drift), ...(bears ? [millimetres(w.peak_seat_slip)] : [])]);
    return [`Drift of storey ${storey}, ${foot.toFixed(2)} to ${top.toFixed(2)} m`, ["wall", "along it", "at the end", "out of plane", ...(bears ? ["beam slip"] : [])], rows];
  });
}

/** [caption, head, rows] of rods, and of decks and meshes. */
export function tieTables(m) {
  const ties = m?.ties ?? [], part = (n, bars, word) => (n > 0 ? [bars > 0 ? `${n} of ${bars} ${word}` : word] : []);
  const state = (t) => [...part(t.yielded, t.bars, "yielded"), ...part(t.broken, t.bars, "broken")].join(", ") || "holds";
  const row = (t) => [t.name, `${(t.peak_force / 1000).toFixed(2)} kN`, millimetres(t.peak_elongation), percent(t.utilisation, 0), state(t)];
  const head = (what) => [what, "force", "elongation", "of strength", "state"];
  return [
    ["Rods and other ties: largest in the run", head("tie"), ties.filter((t) => t.bars === 0).map(row)],
    ["Decks and meshes: the bar that bears most", head("deck"), ties.filter((t) => t.bars > 0).map(row)],
  ].filter(([, , rows]) => rows.length > 0);
}

/** [caption, head, rows] of each load. */
export function loadTables(m) {
  const kilonewtons = (x) => (is(x) ? `${(x / 1000).toFixed(2)} kN` : "–"), seconds = (t) => (is(t) ? ` at ${t.toFixed(2)} s` : "");
  return (m?.loads ?? []).map((l) => [
    `${l.name[0].toUpperCase()}${l.name.slice(1)}, ${l.place}`, ["", "force", "place, along the force"], [
      [`Largest force${seconds(l.peak_force_time)}`, kilonewtons(l.peak_force), millimetres(l.displacement_at_peak_force)],
      [`Largest displacement${seconds(l.peak_displacement_time)}`, kilonewtons(l.force_at_peak_displacement), millimetres(l.peak_displacement)],
      ["At the end", kilonewtons(l.end_force), millimetres(l.end_displacement)],
    ]]);
}
