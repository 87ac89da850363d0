// Passes 5 and 7 in JavaScript: each pixel is the mean of its votes, rounded half up.

import type { Stage } from "../engine.js";

export function vote(field: Uint16Array, stage: Stage, colours: Uint8Array): void {
  const { width, height, patchRadius: radius } = stage;
  const { width: stride, rgba } = stage.style as NonNullable<Stage["style"]>;
  for (let y = 0, to = 0; y < height; y++) {
    const top = Math.max(y - radius, 0);
    const bottom = Math.min(y + radius, height - 1);
    for (let x = 0; x < width; x++, to += 4) {
      const left = Math.max(x - radius, 0);
      const right = Math.min(x + radius, width - 1);
      let [red, green, blue] = [0, 0, 0];
      for (let row = top; row <= bottom; row++)
        for (let column = left, from = 2 * (row * width + left); column <= right; column++, from += 2) {
          const at = 4 * ((field[from] - row + y) * stride + field[from + 1] - column + x);
          red += rgba[at];
          green += rgba[at + 1];
          blue += rgba[at + 2];
        }
      const votes = (bottom - top + 1) * (right - left + 1);
      colours[to] = ((2 * red + votes) / (2 * votes)) | 0;
      colours[to + 1] = ((2 * green + votes) / (2 * votes)) | 0;
      colours[to + 2] = ((2 * blue + votes) / (2 * votes)) | 0;
      colours[to + 3] = 255;
    }
  }
}
