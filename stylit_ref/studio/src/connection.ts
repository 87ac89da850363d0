// The line to the server, which is tried again when it is lost.

import { VERSION, readFrame, type Asked, type Frame, type Said } from "./protocol.js";

export interface Heard {
  said(said: Said): void;
  frame(frame: Frame): void;
  lost(): void;
}

/** Milliseconds until it is tried again, at first and at most. */
const FIRST_WAIT = 250;
const LONGEST_WAIT = 4000;

export class Connection {
  private heard: Heard | null = null;
  private socket: WebSocket | null = null;
  private wait = FIRST_WAIT;
  /** The last picture that came. */
  private picture: Frame | null = null;
  /** Whether the server has welcomed the page. */
  isOpen = false;

  /** Begin, and tell what is heard from now on. */
  begin(heard: Heard): void {
    this.heard = heard;
    this.open();
  }

  /** Bytes that are on their way out. */
  get backlog(): number {
    return this.socket?.bufferedAmount ?? 0;
  }

  /** Whether it could be said. */
  ask(asked: Asked): boolean {
    if (!this.isOpen) return false;
    this.socket?.send(JSON.stringify(asked));
    return true;
  }

  send(bytes: Uint8Array<ArrayBuffer>): void {
    this.socket?.send(bytes);
  }

  private open(): void {
    const socket = new WebSocket(`ws://${location.host}/live`);
    this.socket = socket;
    this.picture = null;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => socket.send(JSON.stringify({ do: "hello", version: VERSION } satisfies Asked));
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
      if (typeof data !== "string") {
        const frame = readFrame(data, this.picture);
        if (frame && !frame.isPainting) this.picture = frame;
        if (frame) this.heard?.frame(frame);
        return;
      }
      const said = JSON.parse(data) as Said;
      if (said.say === "welcome") {
        this.isOpen = true;
        this.wait = FIRST_WAIT;
      }
      this.heard?.said(said);
    };
    socket.onclose = () => {
      this.isOpen = false;
      this.heard?.lost();
      setTimeout(() => this.open(), this.wait);
      this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
    };
  }
}
