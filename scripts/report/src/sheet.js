// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What is written over the house on the page, cut into pieces: where nothing is written there is no canvas. Where the processor draws, laying a
// second canvas over the whole picture took a tenth to a fifth of the time of a frame, and so did looking through all its pixels for marks: what
// is drawn tells where (overlay.js).

const kWide = 96, kTall = 48; // of a cell, pixels

export class Sheet {
  constructor(parent) {
    this.parent = parent;
    this.canvas = document.createElement("canvas");
    this.context = this.canvas.getContext("2d", { willReadFrequently: true });
    this.pieces = [];
  }

  /** Shows what `paint` draws into a context of `width` by `height` pixels of the style sheet, `ratio` pixels of the screen each. */
  draw(width, height, ratio, paint) {
    const { canvas, context } = this, W = Math.max(1, Math.round(width * ratio)), H = Math.max(1, Math.round(height * ratio));
    if (canvas.width !== W || canvas.height !== H) Object.assign(canvas, { width: W, height: H });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.marks = [];
    paint(context);
    const wide = Math.ceil(W / kWide), tall = Math.ceil(H / kTall), cells = new Uint8Array((wide + 1) * tall); // one more a row: its end
    for (const [x, y, X, Y] of context.marks) {
      const cell = (pixels, size, most) => Math.min(most - 1, Math.max(0, Math.floor((pixels * ratio) / size)));
      for (let row = cell(y, kTall, tall); row <= cell(Y, kTall, tall); ++row) cells.fill(1, (wide + 1) * row + cell(x, kWide, wide), (wide + 1) * row + cell(X, kWide, wide) + 1);
    }
    let used = 0;
    for (let row = 0; row < tall; ++row) {
      for (let from = 0, k = 0; k <= wide; ++k) {
        if (cells[(wide + 1) * row + k] !== 0) continue;
        if (k > from) this.#piece(used++, from * kWide, row * kTall, Math.min(k * kWide, W) - from * kWide, Math.min(kTall, H - row * kTall), ratio);
        from = k + 1;
      }
    }
    for (const piece of this.pieces.slice(used)) piece.hidden = true;
  }

  #piece(i, x, y, width, height, ratio) {
    const piece = (this.pieces[i] ??= this.parent.appendChild(document.createElement("canvas")));
    if (piece.width !== width || piece.height !== height) Object.assign(piece, { width, height });
    const c = piece.getContext("2d", { willReadFrequently: true }); // in memory, as the canvas that it is copied from
    c.clearRect(0, 0, width, height);
    c.drawImage(this.canvas, x, y, width, height, 0, 0, width, height);
    Object.assign(piece.style, { left: `${x / ratio}px`, top: `${y / ratio}px`, width: `${width / ratio}px`, height: `${height / ratio}px` });
    piece.hidden = false;
  }
}
