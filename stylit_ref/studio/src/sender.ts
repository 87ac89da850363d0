// The painting on its way to the server and to the canvas: what changed, once a frame, and when the brush
// rests.

import type { Connection } from "./connection.js";
import { atOnceAndPerFrame } from "./frames.js";
import type { Latency } from "./latency.js";
import type { Painting } from "./painting.js";
import { rectMessage } from "./protocol.js";
import { around, type Rect } from "./rect.js";

/** Milliseconds without a change until the brush counts as resting. */
const REST = 80;
/** Bytes on their way that are enough; more changes are gathered meanwhile. */
const MOST_BACKLOG = 8 * 1024 * 1024;

export class Sender {
  /** Of the last message. */
  serial = 0;
  painting: Painting | null = null;
  private readonly connection: Connection;
  private readonly latency: Latency;
  private unsent: Rect | null = null;
  /** Of the first event that made it. */
  private since = 0;
  private isAllowed = false;
  private isResting = false;
  private rested = 0;
  private timer = 0;
  private readonly ask: () => void;

  constructor(connection: Connection, latency: Latency) {
    this.connection = connection;
    this.latency = latency;
    this.ask = atOnceAndPerFrame(() => this.flush());
    // Frames of a hidden page are not drawn.
    document.addEventListener("visibilitychange", () => document.hidden && this.flush());
  }

  /** Whether there is paint that the server does not have. */
  get isBehind(): boolean {
    return this.unsent !== null;
  }

  /** Whether what changes may be sent. */
  allow(isAllowed: boolean): void {
    this.isAllowed = isAllowed;
    this.ask();
  }

  changed(rect: Rect | null, time = performance.now()): void {
    if (!rect) return;
    if (!this.unsent) this.since = time;
    this.unsent = around(this.unsent, rect);
    this.isResting = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.rest(), REST);
    this.ask();
  }

  /** The brush rests, or its stroke is done. */
  rest(): void {
    clearTimeout(this.timer);
    this.isResting = true;
    this.ask();
  }

  /** The server has other strokes than the page, or fewer: it gets the whole painting. */
  sendAll(): void {
    if (!this.painting) return;
    this.changed(this.painting.whole);
    this.rest();
  }

  /** Nothing is left to be sent: the painting is the server's. */
  forget(serial: number): void {
    this.serial = this.rested = serial;
    this.unsent = null;
    this.isResting = false;
    clearTimeout(this.timer);
  }

  /** Show and send what has changed so far. */
  flush(): void {
    this.painting?.show();
    if (!this.isAllowed || !this.painting) return;
    if (this.unsent) {
      if (this.connection.backlog > MOST_BACKLOG) return this.ask();
      this.serial = (this.serial + 1) >>> 0;
      this.connection.send(rectMessage(this.unsent, this.serial, this.painting.read(this.unsent)));
      this.latency.sends(this.serial, this.since);
      this.unsent = null;
    }
    if (this.isResting && this.rested !== this.serial) {
      this.rested = this.serial;
      this.latency.rests(this.serial);
      this.connection.ask({ do: "rest", serial: this.serial });
    }
  }
}
