// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What is written over the house on the page, cut into pieces: where nothing is written there is no canvas. Where the processor draws, laying a
// second canvas over the whole picture took a tenth to a fifth of the time of a frame.

const kWide = 96, kTall = 48; // of what is looked at for marks, pixels

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
    paint(context);
    const image = context.getImageData(0, 0, W, H), pixels = new Uint32Array(image.data.buffer), marks = new Uint8Array(Math.ceil(W / kWide) + 1);
    let used = 0;
    for (let y = 0; y < H; y += kTall) {
      const tall = Math.min(kTall, H - y);
      marks.fill(0);
      for (let i = y * W, x = 0, end = i + tall * W; i < end; ++i) {
        if (pixels[i] !== 0) marks[Math.floor(x / kWide)] = 1;
        if (++x === W) x = 0;
      }
      for (let from = 0, k = 0; k < marks.length; ++k) {
        if (marks[k] === 0 && k > from) this.#piece(used++, image, from * kWide, y, Math.min(k * kWide, W) - from * kWide, tall, ratio);
        if (marks[k] === 0) from = k + 1;
      }
    }
    for (const piece of this.pieces.slice(used)) piece.hidden = true;
  }

  #piece(i, image, x, y, width, height, ratio) {
    const piece = (this.pieces[i] ??= this.parent.appendChild(document.createElement("canvas")));
    if (piece.width !== width || piece.height !== height) Object.assign(piece, { width, height });
    piece.getContext("2d").putImageData(image, -x, -y, x, y, width, height);
    Object.assign(piece.style, { left: `${x / ratio}px`, top: `${y / ratio}px`, width: `${width / ratio}px`, height: `${height / ratio}px` });
    piece.hidden = false;
  }
}
