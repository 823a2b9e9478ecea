// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The course of a run on the slider: damage grades as bands, what happened first as ticks.

export const kGrades = ["no damage", "slight", "moderate", "substantial", "very heavy", "destruction"];

function add(parent, className, text, left, width) {
  const e = parent.appendChild(Object.assign(document.createElement("span"), { className, textContent: text }));
  e.style.left = `${100 * left}%`;
  if (width !== undefined) e.style.width = `${100 * width}%`;
  return e;
}

/** Moments worth a tick: [name, time]. */
export function moments(facts) {
  const m = facts.measures, s = facts.summary;
  return [["first crack", s.first_crack_time ?? m?.first_crack_time], ["first fall", m?.first_fallen_time], ["collapse", m?.collapse_time], [facts.worst?.name, facts.worst?.name === "collapse" ? -1 : facts.worst?.time], ["roof falls", m?.collapse_time >= 0 ? -1 : m?.roof_first_fallen_time]].filter(([, t]) => t !== undefined && t !== null && t >= 0);
}

/** Fills `bands` and `ticks`, which lie over the slider from `from` to `until`; a tick shows its moment. */
export function showTimeline(bands, ticks, facts, from, until, seek) {
  const place = (t) => Math.min(1, Math.max(0, (t - from) / (until - from || 1)));
  const starts = [from, ...(facts.measures?.damage_grade >= 0 ? facts.measures.grade_time : [])];
  starts.forEach((t, g) => {
    if (t < 0) return;
    const end = starts.slice(g + 1).find((next) => next >= 0) ?? until, width = place(end) - place(t);
    if (width <= 0) return;
    add(bands, `band grade${g}`, width > 0.035 ? `G${g}` : "", place(t), width).title = `G${g}, ${kGrades[g]}, from ${t.toFixed(2)} s`;
  });
  for (const [name, t] of moments(facts).sort((a, b) => a[1] - b[1])) {
    const tick = ticks.appendChild(Object.assign(document.createElement("button"), { type: "button", className: "tick", textContent: `${name} ${t.toFixed(2)} s` }));
    tick.style.left = `${100 * place(t)}%`;
    tick.addEventListener("click", () => seek(t));
  }
  new ResizeObserver(() => arrange(ticks)).observe(ticks);
}

const kGap = 6; // px between two texts

/** Texts that would reach over the end of the slider go to the left of their tick; those without room before the next one stand higher. */
function arrange(ticks) {
  let next = Infinity;
  for (const tick of [...ticks.children].reverse()) {
    tick.classList.remove("second", "leftwards");
    tick.classList.toggle("leftwards", tick.offsetLeft + tick.offsetWidth > ticks.clientWidth);
    const left = tick.offsetLeft - (tick.classList.contains("leftwards") ? tick.offsetWidth : 0);
    if (left + tick.offsetWidth + kGap > next) tick.classList.add("second");
    else next = left;
  }
}
