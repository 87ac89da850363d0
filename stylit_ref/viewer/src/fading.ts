// The frames that a picture is mixed from.

import type { Moment } from "./engine.js";
import { WHOLE } from "./grid.js";

/** A frame: the views around in the order in which they count, and the frame's weight. */
export interface Frame {
  order: number[];
  weight: number;
}

/** One frame; in a fade one for each view that weighs something, as if it were the closest. */
export function framesOf({ mode, around }: Moment): Frame[] {
  const all = around.map((_, k) => k);
  if (mode !== "fade") return [{ order: all, weight: WHOLE }];
  return all
    .filter((k) => around[k].fading > 0)
    .map((k) => ({ order: [k, ...all.filter((other) => other !== k)], weight: around[k].fading }));
}

/** Image shifting takes the closest view that shows a point; the blend takes all that do. */
export function shiftedWeights({ mode, around }: Moment): number[] {
  return around.map((view, k) => (mode === "blend" ? view.linear : k === 0 ? WHOLE : 0));
}
