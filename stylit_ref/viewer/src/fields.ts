// Nearest-neighbour fields: y, x of a source pixel for each pixel of a view.

import type { Piece } from "./page_data.js";

/** As a lossless WebP: 12 bits for each number. Else bytes of differences, for styles of any size. */
export function fieldOf(piece: Piece, bytes: Uint8Array, width: number, height: number): Uint16Array<ArrayBuffer> {
  return piece.coding === "webp" ? ofColours(bytes, width * height) : ofDifferences(bytes, width, height);
}

/** Red: low byte of y. Green: low byte of x. Blue: four high bits of y, then those of x. */
function ofColours(colours: Uint8Array, pixels: number): Uint16Array<ArrayBuffer> {
  const field = new Uint16Array(2 * pixels);
  for (let i = 0, from = 0; i < field.length; i += 2, from += 3) {
    const high = colours[from + 2];
    field[i] = colours[from] | ((high & 15) << 8);
    field[i + 1] = colours[from + 1] | ((high >> 4) << 8);
  }
  return field;
}

/**
 * Four planes: low and high bytes of y, then of x, each less what a patch that goes on would have: the
 * number to the left, and for x one more. The first of a row is told from the one above it.
 */
function ofDifferences(planes: Uint8Array, width: number, height: number): Uint16Array<ArrayBuffer> {
  const pixels = width * height;
  const field = new Uint16Array(2 * pixels);
  for (let axis = 0; axis < 2; axis++) {
    const low = 2 * axis * pixels;
    const high = low + pixels;
    for (let y = 0, i = 0; y < height; y++) {
      let last = y ? field[2 * (i - width) + axis] + 1 - 2 * axis : 0;
      for (let x = 0; x < width; x++, i++) {
        last = (last + axis + (planes[low + i] | (planes[high + i] << 8))) & 65535;
        field[2 * i + axis] = last;
      }
    }
  }
  return field;
}
