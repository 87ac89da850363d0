// Opaque pixels of a canvas: red, green, blue and 255 in memory, one number each on every machine of
// today, which are little-endian.

const OPAQUE = 0xff000000;

export const pack = (red: number, green: number, blue: number): number =>
  (OPAQUE | (blue << 16) | (green << 8) | red) >>> 0;

/** Write pixels of three bytes each. */
export function fromRgb(rgb: Uint8Array, pixels: Uint32Array): void {
  for (let from = 0, to = 0; to < pixels.length; from += 3, to++)
    pixels[to] = OPAQUE | (rgb[from + 2] << 16) | (rgb[from + 1] << 8) | rgb[from];
}
