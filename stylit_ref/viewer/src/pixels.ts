// Images as passes take them: four bytes a pixel, the last of them 255.

export function toRgba(colours: Uint8Array): Uint8Array<ArrayBuffer> {
  const rgba = new Uint8Array((colours.length / 3) * 4).fill(255);
  for (let from = 0, to = 0; from < colours.length; from += 3, to += 4) {
    rgba[to] = colours[from];
    rgba[to + 1] = colours[from + 1];
    rgba[to + 2] = colours[from + 2];
  }
  return rgba;
}
