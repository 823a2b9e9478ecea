// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The table of cracks, whose widths at the moment shown go with the clock, and the crack maps (io/output/report/damage/report_cracks.h).

const mm = (x) => x.toFixed(x < 10 ? 1 : 0);
const cell = (row, kind, text, scope) => Object.assign(row.appendChild(document.createElement(kind)), { textContent: text, ...(scope ? { scope } : {}) });

export class CrackTable {
  /** @param cracks  of one run  @param letter  "", or that of the run of two  @param seek  called with the time of a width that is clicked */
  constructor(parent, cracks, letter, seek) {
    this.cracks = cracks.cracks;
    const table = parent.appendChild(Object.assign(document.createElement("table"), { className: "cracks" }));
    table.createCaption().textContent = `Cracks${letter ? `, ${letter}` : ""}: opening and sliding, mm; a crack is a net of open joints, its branches are added up${cracks.more > 0 ? ` (${cracks.more} narrower ones are left out)` : ""}`;
    const head = table.appendChild(document.createElement("tr"));
    for (const text of ["no., wall, place in m: from the left, up", "extent", "branches", "now", "most", "at the end"]) cell(head, "th", text, "col").className = text.length > 16 ? "long" : "";
    this.now_ = this.cracks.map((c, i) => {
      const row = table.appendChild(document.createElement("tr"));
      cell(row, "th", `${i + 1}, ${c.wall}, ${c.along.map((x) => x.toFixed(1)).join("–")}, ${c.z.map((x) => x.toFixed(1)).join("–")}`, "row").className = "long";
      for (const x of [c.extent, c.length]) cell(row, "td", `${x.toFixed(1)} m`);
      const now = cell(row, "td", "");
      const most = cell(row, "td", "").appendChild(Object.assign(document.createElement("button"), { type: "button", className: "link", textContent: mm(1000 * c.peak), title: `at ${c.peak_time.toFixed(2)} s: go there` }));
      most.addEventListener("click", () => seek(c.peak_time));
      cell(row, "td", mm(1000 * c.at_end));
      return now;
    });
    if (cracks.maps.length > 0) this.#maps(parent, cracks, letter);
  }

  #maps(parent, { maps, time }, letter) {
    const folded = parent.appendChild(Object.assign(document.createElement("details"), { className: "maps" }));
    folded.appendChild(document.createElement("summary")).textContent = `Crack maps${letter ? `, ${letter}` : ""}, at ${time.toFixed(2)} s`;
    folded.addEventListener("toggle", () => {
      if (!folded.open || folded.querySelector("img")) return;
      for (const { wall, svg } of maps) folded.appendChild(Object.assign(document.createElement("img"), { alt: `Crack map of the ${wall}`, src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}` }));
    });
  }

  /** @param frame  of this run; need not be whole */
  now(frame) {
    this.cracks.forEach((c, i) => {
      const text = mm(c.widths[Math.min(Math.round(frame), c.widths.length - 1)] ?? 0);
      if (this.now_[i].textContent !== text) this.now_[i].textContent = text;
    });
  }
}
