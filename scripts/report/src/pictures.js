// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Stills and films: the houses with everything that says what they show burnt in.
import { drawCaption, drawOverlay } from "./overlay.js";

/** On paper, whatever the theme. */
export const kPaper = { text: "#222", rim: "rgba(255, 255, 255, 0.85)", arrow: "#1f5fa8", hinge: "#1a237e", load: "#7b1fa2", tie: "#c05a00" };

/** Draws the panes side by side with caption and legend, as large as the canvas of `c`; they have just been drawn. */
export function compose(c, panes, caption, overlay) {
  const { width, height } = c.canvas, u = Math.max(10, Math.round(Math.min(height / 42, width / 56))), each = width / panes.length;
  c.setTransform(1, 0, 0, 1, 0, 0);
  panes.forEach(({ house }, i) => c.drawImage(house.canvas, i * each, 0, each, height));
  const bottom = drawCaption(c, caption, width, height, u);
  panes.forEach((pane, i) => {
    c.save();
    c.beginPath(), c.rect(i * each, 0, each, height), c.clip(), c.translate(i * each, 0);
    drawOverlay(c, pane.house, each, height, u, { ...overlay(pane), bottom: bottom + 0.5 * u }, kPaper);
    if (panes.length > 1) {
      c.font = `600 ${1.4 * u}px system-ui, "DejaVu Sans", sans-serif`, c.textAlign = "left", c.fillStyle = "#111";
      c.fillText("AB"[i], 1 * u, 5 * u);
    }
    c.restore();
  });
}

/** Writes what is shown into a WebM while it is on. */
export class Recorder {
  /** @param draw  draws a picture into a context of two dimensions  @param done  called with the film, a Blob */
  constructor(width, height, draw, done) {
    const canvas = Object.assign(document.createElement("canvas"), { width: width & ~1, height: height & ~1 }), pieces = [];
    this.context = canvas.getContext("2d");
    this.draw = draw;
    this.shot();
    const type = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"].find((t) => MediaRecorder.isTypeSupported(t));
    this.recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 8e6 });
    this.recorder.addEventListener("dataavailable", (e) => pieces.push(e.data));
    this.recorder.addEventListener("stop", () => done(new Blob(pieces, { type: "video/webm" })));
    this.recorder.start(500);
  }
  shot() { this.draw(this.context); }
  stop() { this.recorder.stop(); }
}
