// How long it takes from the hand to the picture that answers it.

import type { Which } from "./protocol.js";

export interface Answered {
  which: Which;
  serial: number;
  /** A replay: since the pointer moved. A coherent picture: since the brush was said to rest. */
  milliseconds: number;
}

const MOST = 2000;

export class Latency {
  readonly times: Answered[] = [];
  private readonly moved = new Map<number, number>();
  private readonly rested = new Map<number, number>();

  /** A rectangle is sent; `time` is when the pointer made the first of it. */
  sends(serial: number, time: number): void {
    this.moved.set(serial, time);
  }

  rests(serial: number): void {
    this.rested.set(serial, performance.now());
  }

  /** A picture has been drawn in this frame. */
  shows(which: Which, serial: number): void {
    const begun = which === "replay" ? this.moved : which === "coherent" ? this.rested : null;
    if (!begun) return;
    // A task after the frame's own: the frame is laid out and painted by then.
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      const now = performance.now();
      for (const [known, time] of begun) {
        if (known > serial) continue;
        begun.delete(known);
        this.times.push({ which, serial: known, milliseconds: now - time });
      }
      this.times.splice(0, this.times.length - MOST);
    };
    port2.postMessage(null);
  }
}
