// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Mode shapes of the structure as it was built (io/output/report/report_modes.h), swinging slowly, as large as the control of the motion says.

const kLargest = 0.02; // of the house's size: how far the part that moves most goes if nobody says
const kSwing = 1.5; // s, of one swing on the screen

export class Modes {
  /** @param list  of modes  @param shapes  six numbers an element and mode: displacement, rotation */
  constructor(list, shapes, centroids) {
    Object.assign(this, { list, shapes, centroids, n: centroids.length / 3, phase: 0.25 });
  }

  /** What each is called. */
  names() {
    return this.list.map(({ frequency, share }, i) => {
      const most = share.indexOf(Math.max(...share));
      return `${i + 1}: ${frequency.toFixed(2)} Hz${share[most] >= 0.1 ? `, along ${"xyz"[most]}` : ""}`;
    });
  }

  /** Swings on for so many seconds of the screen. */
  advance(seconds) { this.phase = (this.phase + seconds / kSwing) % 1; }

  /** How far the part of the house that moves most goes, m. @param size  of the house, m  @param control  "auto", or so many mm */
  largest(size, control) { return control === "auto" ? kLargest * size : 0.001 * Number(control); }

  /** Writes where all elements are into `state` (brick.js), every `stride` numbers one. @param largest  see there */
  place(mode, largest, state, stride) {
    const { n, shapes, centroids, list } = this, swing = largest * Math.sin(2 * Math.PI * this.phase), move = swing * list[mode].move, turn = 0.5 * swing * list[mode].turn;
    for (let e = 0, to = 0, at = 6 * n * mode; e < n; ++e, to += stride, at += 6) {
      let length = 1;
      for (let k = 0; k < 3; ++k) {
        state[to + k] = centroids[3 * e + k] + move * shapes[at + k];
        state[to + 4 + k] = turn * shapes[at + 3 + k]; // small turns: half the angle is the length of the vector
        length += state[to + 4 + k] ** 2;
      }
      length = Math.sqrt(length);
      for (let k = 0; k < 3; ++k) state[to + 4 + k] /= length;
      state[to + 7] = 1 / length;
    }
  }
}
