// Pass 2 in JavaScript: the pixel whose face and motion each pixel takes.

import type { Surface } from "./raster.js";

const isNearer = (inverse: number, other: number): boolean => inverse > 1.05 * other;

/** Numbers of pixels, row by row. */
export function beside(surface: Surface, reach: number): Int32Array {
  const { width, height, inverse } = surface;
  const rims = rimsOf(surface);
  const inRows = grownInRows(rims, width, reach);
  const isClose = grownInColumns(inRows, width, height, reach);
  const places = Int32Array.from(inverse, (_, p) => p);
  for (let y = 0, p = 0; y < height; y++)
    for (let x = 0; x < width; x++, p++) {
      if (!isClose[p]) continue;
      let closest = reach * reach + 1;
      let nearest = Infinity;
      for (let row = Math.max(y - reach, 0); row <= Math.min(y + reach, height - 1); row++) {
        if (!inRows[row * width + x]) continue;
        for (let column = Math.max(x - reach, 0); column <= Math.min(x + reach, width - 1); column++) {
          const q = row * width + column;
          if (!rims[q]) continue;
          const away = (row - y) ** 2 + (column - x) ** 2;
          const wins = away < closest || (away === closest && inverse[q] > nearest);
          if (!wins || !isNearer(inverse[q], inverse[p])) continue;
          closest = away;
          nearest = inverse[q];
          places[p] = q;
        }
      }
      if (closest > reach * reach) continue;
      const [rimY, rimX] = [Math.floor(places[p] / width), places[p] % width];
      const [row, column] = [rimY + Math.sign(rimY - y), rimX + Math.sign(rimX - x)];
      const isInside = row >= 0 && row < height && column >= 0 && column < width;
      if (isInside && !isNearer(nearest, inverse[row * width + column])) places[p] = row * width + column;
    }
  return places;
}

/** Pixels beside which depth steps back. */
function rimsOf({ width, height, inverse }: Surface): Uint8Array {
  const rims = new Uint8Array(inverse.length);
  /** Whether what steps back does so rather than receding on one plane. */
  const isStep = (x: number, y: number, dx: number, dy: number): boolean => {
    const at = (k: number): number | undefined => {
      const [column, row] = [x + k * dx, y + k * dy];
      return column >= 0 && column < width && row >= 0 && row < height ? inverse[row * width + column] : undefined;
    };
    const [near, far] = [inverse[y * width + x], at(1) as number];
    // Outside of the picture the plane goes on.
    const before = at(-1) ?? 2 * near - far;
    const behind = at(2) ?? 2 * far - near;
    return near - far > 2 * Math.min(Math.abs(before - near), Math.abs(far - behind));
  };
  for (let y = 0, p = 0; y < height; y++)
    for (let x = 0; x < width; x++, p++) {
      const near = inverse[p];
      if (y > 0 && isNearer(near, inverse[p - width]) && isStep(x, y, 0, -1)) rims[p] = 1;
      else if (y < height - 1 && isNearer(near, inverse[p + width]) && isStep(x, y, 0, 1)) rims[p] = 1;
      else if (x > 0 && isNearer(near, inverse[p - 1]) && isStep(x, y, -1, 0)) rims[p] = 1;
      else if (x < width - 1 && isNearer(near, inverse[p + 1]) && isStep(x, y, 1, 0)) rims[p] = 1;
    }
  return rims;
}

/** What is set within reach in the row. */
function grownInRows(rims: Uint8Array, width: number, reach: number): Uint8Array {
  const grown = new Uint8Array(rims.length);
  for (let p = 0; p < rims.length; p++) {
    if (!rims[p]) continue;
    const start = p - (p % width);
    grown.fill(1, Math.max(p - reach, start), Math.min(p + reach + 1, start + width));
  }
  return grown;
}

/** What is set within reach in the column. */
function grownInColumns(set: Uint8Array, width: number, height: number, reach: number): Uint8Array {
  const grown = new Uint8Array(set.length);
  for (let y = 0; y < height; y++)
    for (let row = Math.max(y - reach, 0); row <= Math.min(y + reach, height - 1); row++)
      for (let x = 0; x < width; x++) grown[y * width + x] |= set[row * width + x];
  return grown;
}
