// The painting. The page keeps its bytes itself: a browser may round or disturb what a canvas is asked for.

import { fromRgb } from "./pixels.js";
import { around, within, type Rect } from "./rect.js";

/** Pixels along a tile; what changes is kept by tiles. */
export const TILE = 64;

export class Painting {
  readonly width: number;
  readonly height: number;
  /** One opaque pixel a number; see pixels.ts. */
  readonly pixels: Uint32Array<ArrayBuffer>;
  /** Tiles in a row of them. */
  readonly columns: number;
  private readonly image: ImageData;
  private readonly context: CanvasRenderingContext2D;
  private unshown: Rect | null = null;

  constructor(canvas: HTMLCanvasElement, width: number, height: number) {
    Object.assign(canvas, { width, height });
    this.width = width;
    this.height = height;
    this.columns = Math.ceil(width / TILE);
    this.image = new ImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
    this.pixels.fill(0xffffffff);
    this.context = canvas.getContext("2d", { alpha: false, willReadFrequently: true }) as CanvasRenderingContext2D;
    this.context.putImageData(this.image, 0, 0);
  }

  get whole(): Rect {
    return { x: 0, y: 0, width: this.width, height: this.height };
  }

  /** The numbers of the tiles that a rectangle touches. */
  *tilesOf(rect: Rect): Generator<number> {
    const right = Math.floor((rect.x + rect.width - 1) / TILE);
    const bottom = Math.floor((rect.y + rect.height - 1) / TILE);
    for (let y = Math.floor(rect.y / TILE); y <= bottom; y++)
      for (let x = Math.floor(rect.x / TILE); x <= right; x++) yield y * this.columns + x;
  }

  frameOf(tile: number): Rect {
    const place = { x: (tile % this.columns) * TILE, y: Math.floor(tile / this.columns) * TILE };
    return within({ ...place, width: TILE, height: TILE }, this.whole) as Rect;
  }

  copyTile(tile: number): Uint32Array {
    const { x, y, width, height } = this.frameOf(tile);
    const copy = new Uint32Array(TILE * TILE);
    for (let row = 0; row < height; row++) {
      const from = (y + row) * this.width + x;
      copy.set(this.pixels.subarray(from, from + width), row * TILE);
    }
    return copy;
  }

  writeTile(tile: number, copy: Uint32Array): Rect {
    const frame = this.frameOf(tile);
    for (let row = 0; row < frame.height; row++)
      this.pixels.set(copy.subarray(row * TILE, row * TILE + frame.width), (frame.y + row) * this.width + frame.x);
    this.changed(frame);
    return frame;
  }

  /** All of it, three bytes a pixel. */
  replace(rgb: Uint8Array): void {
    fromRgb(rgb, this.pixels);
    this.changed(this.whole);
  }

  /** A rectangle, three bytes a pixel. */
  read({ x, y, width, height }: Rect): Uint8Array {
    const rgb = new Uint8Array(3 * width * height);
    let to = 0;
    for (let row = y; row < y + height; row++)
      for (let at = row * this.width + x, end = at + width; at < end; at++) {
        const pixel = this.pixels[at];
        rgb[to++] = pixel & 255;
        rgb[to++] = (pixel >> 8) & 255;
        rgb[to++] = (pixel >> 16) & 255;
      }
    return rgb;
  }

  /** The pixel at a place; null outside. */
  at(x: number, y: number): number | null {
    const [column, row] = [Math.floor(x), Math.floor(y)];
    const isInside = column >= 0 && row >= 0 && column < this.width && row < this.height;
    return isInside ? this.pixels[row * this.width + column] : null;
  }

  /** Pixels differ; the canvas shows them once `show` is called. */
  changed(rect: Rect): void {
    this.unshown = around(this.unshown, rect);
  }

  show(): void {
    if (!this.unshown) return;
    const { x, y, width, height } = this.unshown;
    this.context.putImageData(this.image, 0, 0, x, y, width, height);
    this.unshown = null;
  }
}
