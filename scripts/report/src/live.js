// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The page of a run that goes on: it is written anew now and then, and loads itself anew to show what has come since.

const kRest = 15; // s: as long after the last touch it waits, so that nobody loses what he looks at

/** Does nothing where the page is of a run that is over. What somebody has chosen (time, colours, camera) is kept in the address. */
export function keepUp(report) {
  const element = document.getElementById("live");
  if (!element) return;
  const asked = location.hash; // as it was opened; the page writes its own address there soon
  let touched = -Infinity;
  for (const what of ["pointerdown", "wheel", "keydown"]) addEventListener(what, () => (touched = performance.now()), { capture: true, passive: true });
  setInterval(() => {
    if (document.hidden || report.playing || performance.now() - touched < 1000 * kRest) return;
    if (touched === -Infinity) history.replaceState(null, "", location.pathname + asked);
    location.reload();
  }, 1000 * Number(element.textContent));
}
