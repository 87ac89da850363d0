// A still at the style's own size: its pixels, voted through a field that was made at the grid's size.

export interface StillStyle {
  /** How many times larger than the style of the field. */
  scale: number;
  /** Of the enlarged style, four bytes a pixel. */
  width: number;
  rgba: Uint8Array;
}

/** The weighted mean of pictures of one size, rounded half up. */
export function mixed(pictures: ImageData[], weights: number[]): ImageData {
  if (pictures.length === 1) return pictures[0];
  const [{ width, height }] = pictures;
  const image = new ImageData(width, height);
  const whole = weights.reduce((sum, weight) => sum + weight, 0);
  for (let i = 0; i < image.data.length; i++) {
    let sum = 0;
    for (const [k, picture] of pictures.entries()) sum += weights[k] * picture.data[i];
    image.data[i] = Math.floor((2 * sum + whole) / (2 * whole));
  }
  return image;
}

/** As stylit_ref.replay: means of votes, rounded half up. */
export function replay(
  field: Uint16Array, width: number, height: number, radius: number, { scale, width: stride, rgba }: StillStyle,
): ImageData {
  const image = new ImageData(width * scale, height * scale);
  const colours = image.data;
  for (let fineY = 0, to = 0; fineY < height * scale; fineY++) {
    const y = Math.floor(fineY / scale);
    const [top, bottom] = [Math.max(y - radius, 0), Math.min(y + radius, height - 1)];
    for (let fineX = 0; fineX < width * scale; fineX++, to += 4) {
      const x = Math.floor(fineX / scale);
      const [left, right] = [Math.max(x - radius, 0), Math.min(x + radius, width - 1)];
      const sum = [0, 0, 0];
      for (let row = top; row <= bottom; row++)
        for (let column = left; column <= right; column++) {
          const from = 2 * (row * width + column);
          const sourceY = (field[from] - row + y) * scale + (fineY % scale);
          const sourceX = (field[from + 1] - column + x) * scale + (fineX % scale);
          const at = 4 * (sourceY * stride + sourceX);
          for (let c = 0; c < 3; c++) sum[c] += rgba[at + c];
        }
      const votes = (bottom - top + 1) * (right - left + 1);
      for (let c = 0; c < 3; c++) colours[to + c] = Math.floor((2 * sum[c] + votes) / (2 * votes));
      colours[to + 3] = 255;
    }
  }
  return image;
}
