// The tip of the brush over the painting: a ring as large as its mark.

import type { Settings } from "./settings.js";
import type { Viewport } from "./viewport.js";

export class Tip {
  private readonly ring: HTMLElement;
  private readonly viewport: Viewport;
  private readonly settings: Settings;

  constructor(ring: HTMLElement, viewport: Viewport, settings: Settings) {
    this.ring = ring;
    this.viewport = viewport;
    this.settings = settings;
    settings.onChange(() => {
      viewport.pane.dataset.tool = settings.chosen.tool;
      this.resize();
    });
  }

  /** Over a mouse or a pen; a finger hides it anyway. */
  follow(event: PointerEvent): void {
    const { left, top } = this.viewport.pane.getBoundingClientRect();
    if (event.pointerType === "touch") this.hide();
    else this.show(event.clientX - left, event.clientY - top, false);
  }

  /** At a place of the painting, led by keys. */
  showAt(x: number, y: number): void {
    const [left, top] = this.viewport.paneAt(x, y);
    this.show(left, top, true);
  }

  hide(): void {
    this.ring.hidden = true;
  }

  private show(left: number, top: number, byKeys: boolean): void {
    this.resize();
    this.ring.hidden = false;
    this.ring.classList.toggle("keys", byKeys);
    this.ring.style.left = `${left}px`;
    this.ring.style.top = `${top}px`;
  }

  private resize(): void {
    const size = Math.max(this.settings.chosen.brush.size * this.viewport.scale, 3);
    this.ring.style.width = this.ring.style.height = `${size}px`;
  }
}
