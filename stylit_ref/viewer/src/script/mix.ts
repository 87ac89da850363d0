// Pass 8 in JavaScript: means of pictures, rounded half up.

import type { Places } from "./motion.js";
import { chosen } from "./shift.js";

export function mix(pictures: Uint8Array[], weights: number[], mixed: Uint8Array): void {
  const whole = weights.reduce((sum, each) => sum + each, 0);
  for (let i = 0; i < mixed.length; i++) {
    let sum = 0;
    for (let k = 0; k < pictures.length; k++) sum += weights[k] * pictures[k][i];
    mixed[i] = Math.floor((2 * sum + whole) / (2 * whole));
  }
}

/** Of the pictures that show the point of a pixel; if those weigh nothing, the first one. */
export function mixShifted(places: Places[], pictures: Uint8Array[], weights: number[], mixed: Uint8Array): void {
  for (let p = 0; p < places[0].length; p++) {
    const isHeard = (k: number) => places[k][p] >= 0 && weights[k] > 0;
    let whole = 0;
    for (let k = 0; k < places.length; k++) if (isHeard(k)) whole += weights[k];
    const [first, place] = chosen(places, p);
    for (let c = 0; c < 4; c++) {
      let sum = 0;
      for (let k = 0; k < places.length; k++) if (isHeard(k)) sum += weights[k] * pictures[k][4 * places[k][p] + c];
      mixed[4 * p + c] = whole ? Math.floor((2 * sum + whole) / (2 * whole)) : pictures[first][4 * place + c];
    }
  }
}
