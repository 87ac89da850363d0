// How long it takes from the hand to the picture that answers it.

import type { Which } from "./protocol.js";

export interface Answered {
  /** A replay: since the pointer moved. A coherent picture: since the brush was said to rest. */
  which: "replay" | "coherent";
  serial: number;
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
    this.rested.clear(); // nobody searches for a brush that goes on
  }

  rests(serial: number): void {
    this.rested.set(serial, performance.now());
  }

  /** A picture has been drawn for the next frame. Paint is answered by the first that shows it, of whatever kind. */
  shows(which: Which, serial: number): void {
    // A task after the frame's own: the frame is laid out and painted by then.
    requestAnimationFrame(() => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => {
        port1.close();
        this.answer("replay", this.moved, serial);
        if (which !== "replay") this.answer("coherent", this.rested, serial);
        this.times.splice(0, this.times.length - MOST);
      };
      port2.postMessage(null);
    });
  }

  private answer(which: Answered["which"], asked: Map<number, number>, serial: number): void {
    const now = performance.now();
    for (const [known, time] of asked) {
      if (known > serial) continue;
      asked.delete(known);
      this.times.push({ which, serial: known, milliseconds: now - time });
    }
  }
}
