// The picture on the right: the newest wins, and its caption says what it is.

import { byId } from "./elements.js";
import { atOnceAndPerFrame } from "./frames.js";
import type { Latency } from "./latency.js";
import type { Frame, Which } from "./protocol.js";
import { Screen } from "./screen.js";

const MEANINGS: Record<Exclude<Which, "look">, string> = {
  replay: "the last match, with your new paint",
  coherent: "searched anew with the same seed",
  warm: "searched on from the last step of the turn",
  fast: "the dense method, preset fast",
  full: "the full method",
  step: "by the step buttons",
};

export class Result {
  which: Which | null = null;
  private readonly screen = new Screen(byId("picture"));
  private readonly latency: Latency;
  private newest: Frame | null = null;
  /** The last that is no step, to go back to. */
  private live: Frame | null = null;
  private serial = 0;
  private readonly askFrame: () => void;

  constructor(latency: Latency) {
    this.latency = latency;
    this.askFrame = atOnceAndPerFrame(() => this.draw());
    byId("back").onclick = () => {
      this.newest = this.live;
      this.askFrame();
    };
  }

  /** Begin again, as the server counts serials from elsewhere. */
  forget(): void {
    this.serial = 0;
    this.newest = this.live = null;
  }

  show(frame: Frame): void {
    if (frame.serial < this.serial) return;
    this.serial = frame.serial;
    this.newest = frame;
    if (frame.which !== "step") this.live = frame;
    this.askFrame();
  }

  private draw(): void {
    const { newest } = this;
    if (!newest) return;
    this.newest = null;
    const { which, width, height, serial, milliseconds } = newest;
    this.screen.show(width, height, newest.rgb);
    this.which = which;
    byId("empty").hidden = true;
    byId("back").hidden = which !== "step" || !this.live;
    byId("which").textContent = which;
    byId("which").dataset.which = which;
    byId("took").textContent = timeOf(milliseconds);
    byId("meaning").textContent = which === "look" ? "" : MEANINGS[which];
    this.latency.shows(which, serial);
  }
}

function timeOf(milliseconds: number): string {
  if (milliseconds < 9.95) return `${milliseconds.toFixed(1)} ms`;
  return milliseconds < 999.5 ? `${milliseconds.toFixed(0)} ms` : `${(milliseconds / 1000).toFixed(1)} s`;
}
