// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What a quasi-static analysis has found, in words. A figure that there is none of is null.

const is = (x) => x !== null && x !== undefined;
const fixed = (x, digits, unit) => (is(x) ? `${x.toFixed(digits)} ${unit}`.trimEnd() : "–");
const kilonewtons = (x) => fixed(is(x) ? x / 1000 : x, 1, "kN"), millimetres = (x) => fixed(is(x) ? 1000 * x : x, 2, "mm");
const percent = (x, digits = 2) => fixed(is(x) ? 100 * x : x, digits, "%"), stiffness = (x) => fixed(is(x) ? x / 1e6 : x, 1, "kN/mm");
const rate = (c) => (is(c.unbalanced) ? "of states of rest" : `without inertia and damping, ${c.slow ? "slow enough" : "depends on the rate"}`);

/** What stands in large type: [name, value, small print]. @param c  null or undefined: a time history */
export function capacityKeys(c) {
  if (!c) return [];
  if (c.kind === "rest") return [["At rest", percent(c.share, 1), "of the loads that grow and of the supports' movements"]];
  if (c.kind === "settlement") return [["Fell after", is(c.collapse_movement) ? `${c.collapse_movement.toFixed(3)} m` : "never", "movement of a support"]];
  if (c.kind === "cyclic") return [["Load factors", `${c.least_factor.toFixed(2)} … ${c.multiplier.toFixed(2)}`, `${c.loops?.length ?? 0} whole cycles`], ["Lost in the loops", fixed(c.dissipated, 1, "J"), `of ${fixed(c.loop_area, 1, "J")} put in`]];
  return [
    [c.kind === "tilt" ? "Multiplier" : "Load factor", fixed(c.multiplier_at_rest, 4, ""), rate(c)],
    ["Base shear", kilonewtons(c.peak_shear), `largest, at ${millimetres(c.peak_displacement)}`],
    ["Ultimate", millimetres(c.ultimate_displacement), is(c.ultimate_drift) ? `drift ${percent(c.ultimate_drift)}` : "not reached"],
    ["First stiffness", stiffness(c.first_stiffness), "at 15 % of the peak"],
  ];
}

const bilinear = (c, code, name) => [
  [`Bilinear, ${name}: plateau`, kilonewtons(c[`${code}_force`])],
  ["… stiffness", stiffness(c[`${code}_stiffness`])],
  ["… yield", millimetres(c[`${code}_yield`])],
  ["… ductility", fixed(c[`${code}_ductility`], 2, "")],
];

const METHODS = { n2_ec8: "N2, EC 8", n2_ntc: "N2, NTC 2018", capacity_spectrum: "Capacity spectrum" };

/** What a spectrum asks of the capacity: [name, value]. @param p  null or undefined: there is no demand */
function demandRows(p) {
  if (!p) return [];
  const points = p.points.flatMap((q) => [
    [`${METHODS[q.name]}: target`, millimetres(q.target)],
    [`… ${METHODS[q.name]}, demand over capacity`, is(q.demand_over_capacity) ? `${q.at_most ? "at most " : ""}${q.demand_over_capacity.toFixed(2)}` : "not known"],
    ...(q.not_proven.length ? [[`… ${METHODS[q.name]}, not proven`, q.not_proven.join("; ")]] : []),
  ]);
  return [["Demand", p.spectrum], ["… participation", fixed(p.participation, 3, "")], ["… effective mass", percent((p.participation * p.mass) / p.all_mass, 0)], ["Near collapse", millimetres(p.near_collapse)], ...points];
}

const control = (c) => (c.control ? [["Control point", `${c.control.part}, element ${c.control.element}, at (${c.control.position.map((x) => x.toFixed(2)).join(", ")}) m`]] : []);

const doubts = (c) => (c.not_proven ?? []).map((words) => ["Not proven", words]);

/** Walls that the ground has left: [name, value]. */
const hanging = (c) => (c.hanging ?? []).map((h) => [`Ground has left the ${h.wall}`, `over ${h.length.toFixed(2)} m (${h.from.toFixed(2)} to ${h.to.toFixed(2)} m from its left end), by up to ${millimetres(h.gap)} at ${h.height.toFixed(2)} m; what is above hangs by its mortar`]);

/** Rows of a table: [name, value]. */
export function capacityTable({ facts }) {
  const c = facts.capacity;
  if (!c) return [];
  if (c.kind === "rest") return [...control(c), ...doubts(c), ["Unbalanced, of an element's mean weight", is(c.unbalanced) ? c.unbalanced.toExponential(1) : "–"], ...hanging(c), ["Mechanism at the end", c.mechanism_at_end.join("; ")]];
  if (c.kind === "settlement") return [...control(c), ...doubts(c), ["Fell at", fixed(c.collapse_time, 2, "s")], ...hanging(c), ["Mechanism at the end", c.mechanism_at_end.join("; ")]];
  const loops = (c.loops ?? []).flatMap((l, i) => [
    [`Loop ${i + 1}, ${millimetres(l.least)} to ${millimetres(l.most)}`, fixed(l.area, 2, "J")],
    [`… ${i + 1} lost, stored`, `${l.dissipated.toFixed(2)}, ${l.stored.toFixed(2)} J`],
    [`… ${i + 1} viscous damping`, percent(l.viscous_damping, 1)],
  ]);
  const grows = c.kind === "cyclic" ? loops : [...named(bilinear(c, "ec8", "EC 8"), "EC 8"), ...named(bilinear(c, "ntc", "NTC 2018"), "NTC"), ...demandRows(c.performance), ["At the peak", c.mechanism.join("; ")], ["At the end", c.mechanism_at_end.join("; ")]];
  return [...control(c), ...doubts(c), ["Borne by inertia and damping", percent(c.motion_share)], ["Kinetic energy over work", percent(c.kinetic_share)], ...grows];
}

/** Limit analysis of the same case, and why it may differ: [name, value]. */
export function limitTable({ facts }) {
  const l = facts.limit;
  if (!l) return [];
  return [
    ["This run, without inertia", fixed(facts.capacity.multiplier_at_rest, 4, "")],
    ["Limit analysis, Coulomb", is(l.coulomb) ? fixed(l.coulomb, 4, "") : "not computed"],
    ["… associated flow", fixed(l.associated, 4, "")],
    ...l.reasons.map((reason, i) => [i ? `… ${i + 1}` : "Why they may differ", reason]),
  ];
}

/** Names of rows are keys where two runs stand side by side. */
const named = (rows, code) => rows.map(([name, value]) => [name.startsWith("…") ? `… ${code} ${name.slice(2)}` : name, value]);
