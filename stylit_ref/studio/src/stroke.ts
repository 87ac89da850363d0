// A stroke on the painting. Where its marks lie over each other the strongest counts, so a stroke is
// even, whatever its opacity.

import { profileOf, type Brush, type Dab } from "./brush.js";
import { GRAIN, HAIRS, grainOf, type Grain } from "./grains.js";
import type { Tiles } from "./history.js";
import { TILE, type Painting } from "./painting.js";
import { around, within, type Rect } from "./rect.js";

/** What is painted: a picture that is repeated; a colour is a picture of one pixel. */
export interface Ink {
  width: number;
  height: number;
  pixels: Uint32Array;
}

interface Touched {
  before: Uint32Array;
  /** How much of the paint lies on each pixel, up to 255. */
  covered: Uint8Array;
}

export class Stroke {
  private readonly painting: Painting;
  private readonly ink: Ink;
  private readonly brush: Brush;
  private readonly grain: Grain | null;
  private readonly touched = new Map<number, Touched>();
  private profile: Uint8Array = new Uint8Array(0);
  private profileRadius = 0;

  constructor(painting: Painting, ink: Ink, brush: Brush) {
    this.painting = painting;
    this.ink = ink;
    this.brush = { ...brush };
    this.grain = grainOf(brush.grain);
  }

  /** What the tiles held before. */
  get before(): Tiles {
    return new Map([...this.touched].map(([tile, { before }]) => [tile, before]));
  }

  /** Take it all back; where the painting differs now. */
  cancel(): Rect | null {
    let changed: Rect | null = null;
    for (const [tile, before] of this.before) changed = around(changed, this.painting.writeTile(tile, before));
    return changed;
  }

  /** Leave a mark; where the painting differs now. */
  add(dab: Dab): Rect | null {
    const reach = dab.radius + 1;
    const [x, y] = [Math.floor(dab.x - reach), Math.floor(dab.y - reach)];
    const square = { x, y, width: Math.ceil(dab.x + reach) - x, height: Math.ceil(dab.y + reach) - y };
    const rect = within(square, this.painting.whole);
    if (!rect) return null;
    if (Math.abs(this.profileRadius / dab.radius - 1) > 0.05) {
      this.profile = profileOf(this.brush.hardness, dab.radius * dab.aspect);
      this.profileRadius = dab.radius;
    }
    for (const tile of this.painting.tilesOf(rect)) this.addTo(tile, rect, dab);
    this.painting.changed(rect);
    return rect;
  }

  private addTo(tile: number, rect: Rect, dab: Dab): void {
    const frame = this.painting.frameOf(tile);
    const part = within(rect, frame) as Rect;
    const { before, covered } = this.touch(tile);
    const { pixels, width } = this.painting;
    const { ink, profile, grain } = this;
    // Half a pixel more: the rim of a hard brush lies between pixels.
    const radius = dab.radius + 0.5;
    const [cos, sin] = [Math.cos(dab.angle) / radius, Math.sin(dab.angle) / radius];
    const [along, across] = [Math.cos(dab.direction) / radius, Math.sin(dab.direction) / radius];
    const opacity = this.brush.opacity;
    for (let y = part.y; y < part.y + part.height; y++) {
      const down = y + 0.5 - dab.y;
      let at = (y - frame.y) * TILE + part.x - frame.x;
      for (let x = part.x; x < part.x + part.width; x++, at++) {
        const right = x + 0.5 - dab.x;
        const major = right * cos + down * sin;
        const minor = (down * cos - right * sin) / dab.aspect;
        const square = major * major + minor * minor;
        if (square >= 1) continue;
        let paint = profile[Math.floor(256 * square)] * dab.strength;
        if (grain) {
          const hair = (down * along - right * across + 1) * (HAIRS / 2);
          const place = grain.follows === "ground" ? (y % GRAIN) * GRAIN + (x % GRAIN) : Math.min(Math.max(Math.floor(hair), 0), HAIRS - 1);
          paint = Math.min(255, Math.max(0, grain.fill * (paint + grain.heights[place] - 255)));
        }
        if (paint <= covered[at]) continue;
        covered[at] = paint;
        const from = ink.pixels[(y % ink.height) * ink.width + (x % ink.width)];
        pixels[y * width + x] = mixed(before[at], from, (covered[at] * opacity) / 255);
      }
    }
  }

  private touch(tile: number): Touched {
    let touched = this.touched.get(tile);
    if (!touched) {
      touched = { before: this.painting.copyTile(tile), covered: new Uint8Array(TILE * TILE) };
      this.touched.set(tile, touched);
    }
    return touched;
  }
}

function mixed(below: number, above: number, part: number): number {
  const red = (below & 255) + ((above & 255) - (below & 255)) * part;
  const green = ((below >> 8) & 255) + (((above >> 8) & 255) - ((below >> 8) & 255)) * part;
  const blue = ((below >> 16) & 255) + (((above >> 16) & 255) - ((below >> 16) & 255)) * part;
  return 0xff000000 | (Math.round(blue) << 16) | (Math.round(green) << 8) | Math.round(red);
}
