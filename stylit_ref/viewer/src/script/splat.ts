// Pass 1 in JavaScript without a mesh: points of the views around, on the pixels that they land on.

import { transferOf, type Lens } from "../camera.js";
import { SKY } from "../engine.js";
import { SLACK, type Points } from "../points.js";
import type { Surface } from "./raster.js";

const { floor } = Math;

/** What a view shows itself. */
export function surfaceOf(points: Points, width: number, height: number): Surface {
  const bits = new Float32Array(points.buffer);
  const faces = new Uint16Array(width * height);
  const inverse = new Float32Array(width * height);
  for (let p = 0; p < faces.length; p++) {
    faces[p] = points[2 * p];
    inverse[p] = bits[2 * p + 1];
  }
  return { width, height, faces, inverse };
}

/** The nearest wins, less near beside the middle of a pixel; of equals that of the first view, then the first. */
export function splat(
  views: { points: Points; lens: Lens }[], lens: Lens, viewWidth: number, viewHeight: number, step: number,
): Surface {
  const [width, height] = [viewWidth, viewHeight].map((side) => Math.ceil(side / step));
  const faces = new Uint16Array(width * height).fill(SKY);
  const inverse = new Float32Array(width * height);
  const merits = new Float32Array(width * height);
  for (const { points, lens: from } of views) {
    const [across, down, depth] = transferOf(from, lens);
    const bits = new Float32Array(points.buffer);
    for (let y = 0, p = 0; y < viewHeight; y++)
      for (let x = 0; x < viewWidth; x++, p++) {
        const v = bits[2 * p + 1];
        const z = depth[0] * x + depth[1] * y + depth[2] + depth[3] * v;
        if (!(v > 0 && z > 0)) continue;
        const right = (across[0] * x + across[1] * y + across[2] + across[3] * v) / z + 0.5;
        const below = (down[0] * x + down[1] * y + down[2] + down[3] * v) / z + 0.5;
        const column = floor((floor(right) + 0.5) / step);
        const row = floor((floor(below) + 0.5) / step);
        if (column < 0 || column >= width || row < 0 || row >= height) continue;
        const to = row * width + column;
        const near = Math.fround(v / z);
        const [awayX, awayY] = [right / step - column - 0.5, below / step - row - 0.5];
        const merit = Math.fround(near * (1 - SLACK * (awayX * awayX + awayY * awayY)));
        if (merit <= merits[to]) continue;
        merits[to] = merit;
        inverse[to] = near;
        faces[to] = points[2 * p];
      }
  }
  return filled({ width, height, faces, inverse });
}

/** A surface that is seen from closer by leaves gaps; of the two sides the farther one counts, to the left and right first. */
function filled({ width, height, faces, inverse }: Surface): Surface {
  const all = { width, height, faces: faces.slice(), inverse: inverse.slice() };
  for (let y = 0, p = 0; y < height; y++)
    for (let x = 0; x < width; x++, p++) {
      if (faces[p] !== SKY) continue;
      for (const [isInside, d] of [[x > 0 && x < width - 1, 1], [y > 0 && y < height - 1, width]] as const) {
        if (!isInside || faces[p - d] === SKY || faces[p + d] === SKY) continue;
        const from = inverse[p + d] < inverse[p - d] ? p + d : p - d;
        all.faces[p] = faces[from];
        all.inverse[p] = inverse[from];
        break;
      }
    }
  return all;
}
