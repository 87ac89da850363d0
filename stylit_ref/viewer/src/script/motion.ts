// Pass 3 in JavaScript: where the views around show the point of each pixel.

import { transferOf, type Lens } from "../camera.js";
import type { Surface } from "./raster.js";

/** The numbers of pixels in a view; where it does not show the point, the complement of where it would. */
export type Places = Int32Array;

/** `surface` and `near` may be of every `step`-th pixel; the places are of all. */
export function placesIn(
  labels: Uint16Array, from: Lens, to: Lens, surface: Surface, near: Int32Array, step: number, width: number, height: number,
): Places {
  const [across, down, depth] = transferOf(from, to);
  const places = new Int32Array(width * height);
  for (let y = 0, p = 0; y < height; y++)
    for (let x = 0; x < width; x++, p++) {
      const q = near[Math.floor(y / step) * surface.width + Math.floor(x / step)];
      const v = surface.inverse[q];
      let [dx, dy] = [0, 0];
      let isNear = true;
      if (v > 0) {
        const px = ((q % surface.width) + 0.5) * step - 0.5;
        const py = (Math.floor(q / surface.width) + 0.5) * step - 0.5;
        const z = depth[0] * px + depth[1] * py + depth[2] + depth[3] * v;
        dx = (across[0] * px + across[1] * py + across[2] + across[3] * v) / z - px;
        dy = (down[0] * px + down[1] * py + down[2] + down[3] * v) / z - py;
        isNear = z > 0 && Math.abs(dx) <= width && Math.abs(dy) <= height;
        if (!isNear) dx = dy = 0;
      }
      const [column, row] = [Math.floor(x + dx + 0.5), Math.floor(y + dy + 0.5)];
      const [insideX, insideY] = [Math.min(Math.max(column, 0), width - 1), Math.min(Math.max(row, 0), height - 1)];
      const place = insideY * width + insideX;
      const isShown = isNear && insideX === column && insideY === row && labels[place] === surface.faces[q];
      places[p] = isShown ? place : ~place;
    }
  return places;
}
