// What a brush is, and the mark that it leaves where it touches.

import type { GrainName } from "./grains.js";
import type { Sample } from "./pen.js";

export interface Brush {
  /** Diameter in pixels of the painting. */
  size: number;
  /** From 0 to 1, like what follows. */
  opacity: number;
  hardness: number;
  smoothing: number;
  grain: GrainName;
  pressure: "size" | "opacity" | "both" | "nothing";
  /** Whether a pen that leans leaves a longer mark. */
  tilts: boolean;
}

/** An ellipse of paint. */
export interface Dab {
  x: number;
  y: number;
  /** Half of its longer axis, in pixels. */
  radius: number;
  /** The shorter axis as a part of the longer one. */
  aspect: number;
  /** Of the longer axis, in radians. */
  angle: number;
  /** Which way the stroke goes, in radians. */
  direction: number;
  /** How much paint there is in the middle, from 0 to 1. */
  strength: number;
}

/** A pen that lies down makes marks so many times as long as wide. */
const LONGEST = 3;

export function dabOf(brush: Brush, sample: Sample, direction: number): Dab {
  const { x, y, pressure, lean, azimuth } = sample;
  const shaped = brush.pressure === "size" || brush.pressure === "both" ? 0.08 + 0.92 * pressure : 1;
  const strength = brush.pressure === "opacity" || brush.pressure === "both" ? pressure : 1;
  const length = brush.tilts ? 1 + (LONGEST - 1) * lean * lean : 1;
  const radius = Math.max((brush.size / 2) * shaped, 0.4);
  return { x, y, radius: radius * Math.sqrt(length), aspect: 1 / length, angle: azimuth, direction, strength };
}

/** Pixels from mark to mark. */
export const spacingOf = (dab: Dab): number => Math.max(0.5, 0.16 * dab.radius * dab.aspect);

/** How much paint there is by the square of the distance to the middle, from 0 to 255; 1 is the rim. */
export function profileOf(hardness: number, radius: number): Uint8Array {
  // The rim is at least a pixel wide: it is not jagged.
  const core = Math.max(0, Math.min(hardness, 1 - 1 / Math.max(radius, 1)));
  return Uint8Array.from({ length: 257 }, (_, k) => {
    const way = (1 - Math.sqrt(k / 256)) / (1 - core);
    const t = Math.min(Math.max(way, 0), 1);
    return Math.round(255 * t * t * (3 - 2 * t));
  });
}
