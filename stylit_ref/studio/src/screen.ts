// A canvas that shows pictures of three bytes a pixel; memory is kept from one to the next.

import { fromRgb } from "./pixels.js";

export class Screen {
  readonly canvas: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;
  private image = new ImageData(1, 1);

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d", { alpha: false }) as CanvasRenderingContext2D;
  }

  show(width: number, height: number, rgb: Uint8Array): void {
    if (this.image.width !== width || this.image.height !== height) {
      this.image = new ImageData(width, height);
      Object.assign(this.canvas, { width, height });
      // Coarser levels are stretched over the sheet.
      const { clientWidth } = this.canvas.parentElement as HTMLElement;
      this.canvas.classList.toggle("squares", 1.5 * width < clientWidth);
    }
    fromRgb(rgb, new Uint32Array(this.image.data.buffer));
    this.context.putImageData(this.image, 0, 0);
  }
}
