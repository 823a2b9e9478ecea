// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Entries of a legend, as HTML and burnt into pictures: {head}, {line, strength, colour, text}, {chip, text} or {from, to, low, high}.

const make = (className, style = {}, text = "") => {
  const element = Object.assign(document.createElement("span"), { className, textContent: text });
  Object.assign(element.style, style);
  return element;
};

export function showLegend(parent, entries) {
  parent.replaceChildren(...entries.map((e) => {
    const item = make("item");
    if (e.head) item.append(make("head", {}, e.head));
    else if (e.line) item.append(make("line", { borderTopWidth: `${e.line}px`, borderTopColor: e.colour, opacity: e.strength }), e.text);
    else if (e.chip) item.append(make("chip", { background: e.chip }), e.text);
    else item.append(e.low, make("bar", { background: `linear-gradient(90deg, ${e.from}, ${e.to})` }), e.high);
    return item;
  }));
}

/** Draws it in one or more rows that end at the height `bottom`; returns where they begin. `u`: a unit of type, pixels. */
export function drawLegend(c, entries, left, bottom, width, u) {
  const measure = () => {
    c.font = `${u}px system-ui, "DejaVu Sans", sans-serif`;
    return entries.map((e) => ({ e, w: (e.head ? 0 : e.from ? 9 * u : 2.4 * u) + c.measureText(e.head ?? (e.from ? e.low + e.high : e.text)).width + 1.2 * u }));
  };
  c.textBaseline = "middle";
  let measured = measure();
  const over = measured.reduce((s, m) => s + m.w, 0) / width;
  if (over > 1 && over < 1.25) u /= 1.01 * over, measured = measure(); // rather a little smaller than one entry in a second row
  const rows = [[]];
  for (const m of measured) {
    const row = rows.at(-1);
    if (row.length > 0 && row.reduce((s, r) => s + r.w, 0) + m.w > width) rows.push([m]);
    else row.push(m);
  }
  const top = bottom - 1.7 * u * rows.length;
  rows.forEach((row, i) => {
    let x = left;
    const y = top + 1.7 * u * (i + 0.5);
    for (const { e, w } of row) {
      c.fillStyle = c.strokeStyle = "#222";
      if (e.head) c.fillText(e.head, x, y);
      else if (e.line) {
        c.globalAlpha = e.strength, c.strokeStyle = e.colour, c.lineWidth = (e.line * u) / 12;
        c.beginPath(), c.moveTo(x, y), c.lineTo(x + 1.8 * u, y), c.stroke();
        c.globalAlpha = 1;
        c.fillText(e.text, x + 2.2 * u, y);
      } else if (e.chip) {
        c.fillStyle = e.chip, c.lineWidth = 1, c.strokeStyle = "#999";
        c.fillRect(x + 0.4 * u, y - 0.5 * u, u, u), c.strokeRect(x + 0.4 * u, y - 0.5 * u, u, u);
        c.fillStyle = "#222";
        c.fillText(e.text, x + 1.9 * u, y);
      } else {
        const low = c.measureText(e.low).width, fill = c.createLinearGradient(x + low + 0.6 * u, 0, x + low + 8.6 * u, 0);
        c.fillText(e.low, x, y);
        fill.addColorStop(0, e.from), fill.addColorStop(1, e.to);
        c.fillStyle = fill;
        c.fillRect(x + low + 0.6 * u, y - 0.45 * u, 8 * u, 0.9 * u);
        c.fillStyle = "#222";
        c.fillText(e.high, x + low + 9.1 * u, y);
      }
      x += w;
    }
  });
  return top;
}
