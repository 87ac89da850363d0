// Pass 6 in JavaScript: of the patches that the views around show, the one most like the picture so far.

import type { Stage } from "../engine.js";
import type { Places } from "./motion.js";

export function limitedSearch(
  places: Places[], fields: Uint16Array[], shifted: Uint16Array, picture: Uint8Array, stage: Stage, found: Uint16Array,
): void {
  const { width, height, patchRadius: radius } = stage;
  const { width: stride, rgba } = stage.style as NonNullable<Stage["style"]>;

  /** The difference of a patch to the picture around a pixel; given up beyond a limit. */
  const difference = (y: number, x: number, sourceY: number, sourceX: number, limit: number): number => {
    let sum = 0;
    for (let dy = -radius; dy <= radius && sum < limit; dy++) {
      const row = Math.min(Math.max(y + dy, 0), height - 1) * width;
      let source = 4 * ((sourceY + dy) * stride + sourceX - radius);
      for (let dx = -radius; dx <= radius; dx++, source += 4) {
        const at = 4 * (row + Math.min(Math.max(x + dx, 0), width - 1));
        const red = rgba[source] - picture[at];
        const green = rgba[source + 1] - picture[at + 1];
        const blue = rgba[source + 2] - picture[at + 2];
        sum += red * red + green * green + blue * blue;
      }
    }
    return sum;
  };

  for (let y = 0, p = 0; y < height; y++)
    for (let x = 0; x < width; x++, p++) {
      let [bestY, bestX] = [shifted[2 * p], shifted[2 * p + 1]];
      let best = -1; // not known: most pixels have one candidate alone
      for (let k = 0; k < places.length; k++) {
        const place = places[k][p];
        if (place < 0) continue;
        const [nextY, nextX] = [fields[k][2 * place], fields[k][2 * place + 1]];
        if (nextY === bestY && nextX === bestX) continue;
        if (best < 0) best = difference(y, x, bestY, bestX, Infinity);
        const next = difference(y, x, nextY, nextX, best);
        if (next < best) [best, bestY, bestX] = [next, nextY, nextX];
      }
      found[2 * p] = bestY;
      found[2 * p + 1] = bestX;
    }
}
