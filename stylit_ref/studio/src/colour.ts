// Colours as they are chosen: a hue of 0 to 360, saturation and value of 0 to 1.

export interface Colour {
  hue: number;
  saturation: number;
  value: number;
}

export type Rgb = [number, number, number];

export function rgbOf({ hue, saturation, value }: Colour): Rgb {
  const channel = (offset: number) => {
    const k = (offset + hue / 60) % 6;
    return Math.round(255 * value * (1 - saturation * Math.max(0, Math.min(k, 4 - k, 1))));
  };
  return [channel(5), channel(3), channel(1)];
}

/** Greys have no hue of their own: they keep that of `before`. */
export function colourOf([red, green, blue]: Rgb, before?: Colour): Colour {
  const most = Math.max(red, green, blue);
  const range = most - Math.min(red, green, blue);
  const value = most / 255;
  if (!range) return { hue: before?.hue ?? 0, saturation: 0, value };
  const sector = most === red ? (green - blue) / range : most === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
  return { hue: (60 * sector + 360) % 360, saturation: range / most, value };
}

export const hexOf = (rgb: Rgb): string => "#" + rgb.map((channel) => channel.toString(16).padStart(2, "0")).join("");

/** Null for a text that is no colour. */
export function fromHex(text: string): Rgb | null {
  const digits = /^#?([0-9a-f]{6})$/i.exec(text.trim())?.[1];
  return digits ? ([0, 2, 4].map((k) => parseInt(digits.slice(k, k + 2), 16)) as Rgb) : null;
}
