// Nearest-neighbour fields: y, x of a source pixel for each pixel of a view.

/** Rows and columns to the pixels that a patch may go on from; stylit_ref/viewer/fields.py has the same. */
const BEFORE = [
  [0, -1], [-1, 0], [-1, 1], [-1, -1], [0, -2], [-2, 0],
  [-2, 1], [-1, 2], [-2, -1], [-1, -2], [-2, 2], [-2, -2],
] as const;
const NEW = BEFORE.length;

/**
 * For each pixel one of those, or that its patch is new. Then of the new ones how y and x differ from those
 * of the pixel before, folded to 0, -1, 1, -2 and so on: four low bits of both, eight middle bits of y,
 * eight of x, and four high bits of both, which are left out if all are 0.
 */
export function fieldOf(bytes: Uint8Array, width: number, height: number): Uint16Array<ArrayBuffer> {
  const origins = bytes.subarray(0, width * height);
  const count = origins.reduce((sum, origin) => sum + Number(origin === NEW), 0);
  const plane = (k: number) => bytes.subarray(origins.length + k * count, origins.length + (k + 1) * count);
  const [low, middleY, middleX, high] = [plane(0), plane(1), plane(2), plane(3)];
  const field = new Uint16Array(2 * origins.length);
  let [y, x] = [0, 0];
  for (let p = 0, n = 0; p < origins.length; p++) {
    if (origins[p] === NEW) {
      const top = high.length ? high[n] : 0;
      y += unfolded((low[n] & 15) | (middleY[n] << 4) | ((top & 15) << 12));
      x += unfolded((low[n] >> 4) | (middleX[n] << 4) | ((top >> 4) << 12));
      n++;
    } else {
      const [down, right] = BEFORE[origins[p]];
      const from = 2 * (p + down * width + right);
      y = field[from] - down;
      x = field[from + 1] - right;
    }
    field[2 * p] = y;
    field[2 * p + 1] = x;
  }
  return field;
}

const unfolded = (number: number): number => (number & 1 ? -(number + 1) / 2 : number / 2);
