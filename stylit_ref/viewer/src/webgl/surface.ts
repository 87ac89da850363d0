// Pass 1: the face that each pixel shows, and its inverse depth; from a mesh, or from points.

import type { Lens } from "../camera.js";
import type { Moment } from "../engine.js";

/** Writes the buffer `surface`. */
export interface Surface {
  /** Of a view that is kept. */
  seeView(slot: number, lens: Lens): void;
  /** Of a place between views, at every `step`-th pixel. */
  seePlace(moment: Moment): void;
}
