// What a view shows, pixel by pixel, where there is no mesh.

/** How much farther away a point counts that lands beside the middle of a pixel: by that times the square of how far. */
export const SLACK = 0.1;

/** For each pixel its label, and the bits of its inverse depth as a float of 32 bits. */
export type Points = Uint32Array<ArrayBuffer>;

/**
 * Planes of bytes, the lowest first: two of labels, less those to the left; and four of bits, less twice
 * those to the left, plus those left of them.
 */
export function pointsOf(planes: Uint8Array, width: number, height: number): Points {
  const pixels = width * height;
  const points = new Uint32Array(2 * pixels);
  for (let y = 0, i = 0; y < height; y++) {
    let [label, slope, bits] = [0, 0, 0];
    for (let x = 0; x < width; x++, i++) {
      const byte = (plane: number) => planes[plane * pixels + i];
      label = (label + (byte(0) | (byte(1) << 8))) & 65535;
      slope = (slope + (byte(2) | (byte(3) << 8) | (byte(4) << 16) | (byte(5) << 24))) | 0;
      bits = (bits + slope) | 0;
      points[2 * i] = label;
      points[2 * i + 1] = bits;
    }
  }
  return points;
}
