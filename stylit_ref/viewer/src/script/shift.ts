// Pass 4 in JavaScript: the closest view's patch at every pixel.

import type { Places } from "./motion.js";

/** `places` and `fields` are those of the views around, in the order in which they count. */
export function shift(places: Places[], fields: Uint16Array[], shifted: Uint16Array): void {
  for (let p = 0; p < places[0].length; p++) {
    const [k, place] = chosen(places, p);
    shifted[2 * p] = fields[k][2 * place];
    shifted[2 * p + 1] = fields[k][2 * place + 1];
  }
}

/** The first view that shows the point, and where; if none does, the first of all. */
export function chosen(places: Places[], p: number): [k: number, place: number] {
  for (let k = 0; k < places.length; k++) if (places[k][p] >= 0) return [k, places[k][p]];
  return [0, ~places[0][p]];
}
