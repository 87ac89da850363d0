// What the page and its server say to each other.

import type { Rect } from "./rect.js";

export const VERSION = 2;

export const RESULTS = ["replay", "coherent", "warm", "fast", "full", "step", "look"] as const;
export type Which = (typeof RESULTS)[number];

/** A picture or the painting, as it comes; three bytes a pixel. */
export interface Frame {
  isPainting: boolean;
  which: Which;
  width: number;
  height: number;
  /** Of the last rectangle of the painting that it knows. */
  serial: number;
  milliseconds: number;
  /** Of a look: what was asked for. */
  of: string;
  rgb: Uint8Array;
}

export type Role = "painter" | "reader";
export type Value = number | string | boolean | null | number[];

export interface SceneSaid {
  name: string;
  title: string;
  /** Of a turntable; 1 where the scene stands still. */
  steps: number;
  width: number;
  height: number;
  buffers: string[];
  /** What one can choose guides from; empty where there is no choice. */
  layers: string[];
}

/** A parameter, and what it may be. */
export interface Field {
  name: string;
  kind: "integer" | "number" | "choice" | "flag" | "several";
  least?: number;
  most?: number;
  choices?: string[];
  help: string;
  of: "live" | "dense";
  optional?: boolean;
  odd?: boolean;
}

/** What belongs to a scene that is chosen. */
export interface Chosen {
  scene: string;
  step: number;
  parameters: { values: Record<string, Value>; fields: Field[] };
  weights: Record<string, number>;
  layers?: string[];
}

export interface Welcome extends Chosen {
  say: "welcome";
  version: number;
  role: Role;
  /** By which the server knows this page. */
  page: string;
  painting: { width: number; height: number; name: string; serial: number };
  scenes: SceneSaid[];
  seed?: number;
  panels: string[];
  notes: string[];
}

export type Working = { say: "working"; which: string; state: "started" | "cancelled" | "done" | "failed"; text: string };
export type Stepped = { say: "stepped"; level: number; iteration: number; done: boolean; possible: string[] };
export type Exported = { say: "exported"; folder: string; files: string[]; commands: string[] };

export type Said =
  | Welcome
  | ({ say: "scene" } & Chosen)
  | { say: "role"; role: Role }
  | Working
  | { say: "compiling"; text: string; done: number; total: number }
  | { say: "problem"; text: string; of?: string }
  | { say: "saved"; text: string }
  | Stepped
  | Exported
  | { say: "notes"; texts: string[] };

export type Asked =
  | { do: "hello"; version: number }
  | { do: "rest"; serial: number }
  | { do: "finish" }
  | { do: "scene"; name: string }
  | { do: "turn"; step: number; restylize: boolean }
  | { do: "parameters"; values: Record<string, Value> }
  | { do: "weights"; values: Record<string, number> }
  | { do: "seed"; value: number }
  | { do: "step"; operation: string }
  | { do: "look"; what: string }
  | { do: "export" }
  | { do: "take_over" }
  | { do: "layers"; names: string[] };

const RECT_HEAD = 14;
const FRAME_HEAD = 16;
/** Kinds of frames. */
const [PAINTING, CHANGES] = [2, 3];
/** Pixels along a tile of a picture. */
const TILE = 16;

/** The message that brings a rectangle of the painting, three bytes a pixel. */
export function rectMessage(rect: Rect, serial: number, rgb: Uint8Array): Uint8Array<ArrayBuffer> {
  const message = new Uint8Array(RECT_HEAD + rgb.length);
  const head = new DataView(message.buffer);
  head.setUint8(0, 1);
  [rect.x, rect.y, rect.width, rect.height].forEach((value, k) => head.setUint16(2 + 2 * k, value, true));
  head.setUint32(10, serial, true);
  message.set(rgb, RECT_HEAD);
  return message;
}

/** Null for a message that is none. Of a picture there may be only what has changed since the one `before`. */
export function readFrame(message: ArrayBuffer, before: Frame | null): Frame | null {
  if (message.byteLength < FRAME_HEAD) return null;
  const head = new DataView(message);
  const [kind, which] = [head.getUint8(0), RESULTS[head.getUint8(1)]];
  const [width, height] = [head.getUint16(2, true), head.getUint16(4, true)];
  const begins = FRAME_HEAD + head.getUint16(6, true);
  if (message.byteLength < begins) return null;
  const of = new TextDecoder().decode(message.slice(FRAME_HEAD, begins));
  const body = new Uint8Array(message, begins);
  const rgb = kind === CHANGES ? changed(body, before) : body;
  if (!which || rgb?.length !== 3 * width * height) return null;
  const [serial, milliseconds] = [head.getUint32(8, true), head.getFloat32(12, true)];
  return { isPainting: kind === PAINTING, which, width, height, serial, milliseconds, of, rgb };
}

/** A picture with other tiles here and there; null if there is none. */
function changed(body: Uint8Array, before: Frame | null): Uint8Array | null {
  if (!before) return null;
  const { width, height } = before;
  const [rows, columns] = [Math.ceil(height / TILE), Math.ceil(width / TILE)];
  const rgb = before.rgb.slice();
  let from = Math.ceil((rows * columns) / 8);
  for (let tile = 0; tile < rows * columns; tile++) {
    if (!((body[tile >> 3] >> (tile & 7)) & 1)) continue;
    const [x, y] = [(tile % columns) * TILE, Math.floor(tile / columns) * TILE];
    const length = 3 * Math.min(TILE, width - x);
    for (let row = 0; row < TILE; row++, from += 3 * TILE)
      if (y + row < height) rgb.set(body.subarray(from, from + length), 3 * ((y + row) * width + x));
  }
  return rgb;
}
