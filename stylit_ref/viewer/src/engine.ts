// What draws: WebGL 2, or plain JavaScript where there is none.

import type { Lens } from "./camera.js";
import type { Mode } from "./modes.js";
import type { Points } from "./points.js";

/** The model: triangles, the face that each belongs to, and its plane. */
export interface Mesh {
  /** Nine coordinates a triangle. */
  corners: Float32Array;
  /** Faces mask each other. */
  faces: Uint16Array;
  /** Four numbers a triangle: its normal, and what makes the sum 0 at points of it. */
  planes: Float32Array;
}

/** No face: what lies behind everything. */
export const SKY = 65535;

/** What stays the same as long as the page is open. */
export interface Stage {
  width: number;
  height: number;
  patchRadius: number;
  /** How far strokes reach beyond a silhouette, in pixels. */
  reach: number;
  /** Four bytes a pixel; null if there are pictures alone. */
  style: { width: number; height: number; rgba: Uint8Array<ArrayBuffer> } | null;
  mesh: Mesh | null;
  /** In place of a mesh, whether views have points. */
  hasPoints: boolean;
  /** How many views are kept ready, at most SLOTS. */
  slots: number;
}

/** A view as it was decoded. */
export interface ViewPixels {
  /** y, x of every pixel's patch; null if there is a picture alone. */
  field: Uint16Array<ArrayBuffer> | null;
  rgba: Uint8Array<ArrayBuffer> | null;
  points: Points | null;
  lens: Lens | null;
}

/** What is to be drawn. */
export interface Moment {
  mode: Mode;
  /** Where one is; null where cameras are unknown. */
  lens: Lens | null;
  /** Up to four views around, the closest first: where the engine keeps them, and their weights. */
  around: { slot: number; linear: number; fading: number; lens: Lens | null }[];
  /** Motion is found for every `step`-th pixel. */
  step: number;
}

export interface Engine {
  readonly name: "webgl" | "script";
  /** Keep a view in one of the stage's slots. */
  keep(slot: number, view: ViewPixels): void;
  draw(moment: Moment): void;
  /** Wait until what was asked for is drawn. */
  finish(): void;
  /** A buffer as the last frame left it: fields for stills, and any for tests. */
  read(buffer: string): Uint8Array | Uint16Array | Uint32Array | Int16Array | Int32Array | Float32Array;
}

/** How many views are kept ready at most; the one that was not needed for longest gives way. */
export const SLOTS = 16;
