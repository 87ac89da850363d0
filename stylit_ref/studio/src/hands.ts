// Pointers on a pane: one that draws or drags, two fingers that zoom, a space key that lets it be moved.

import { takesSpace } from "./elements.js";
import type { Viewport } from "./viewport.js";

/** What a pane does with a pointer that neither moves nor zooms it. */
export interface Drag {
  /** Whether it takes this pointer; if not, the pane is moved. */
  begin(event: PointerEvent): boolean;
  move(event: PointerEvent): void;
  end(event: PointerEvent): void;
  /** It was the first of two fingers. */
  cancel(): void;
}

/** The space key, for both panes. */
export const space = { isDown: false, hasMoved: false };

addEventListener("keydown", (event) => {
  if (event.key !== " " || takesSpace(event.target)) return;
  if (!event.repeat) space.hasMoved = false;
  space.isDown = true;
  document.body.classList.add("moves");
  event.preventDefault();
});
const release = () => {
  space.isDown = false;
  document.body.classList.remove("moves");
};
addEventListener("keyup", (event) => event.key === " " && release());
addEventListener("blur", release);

type Way = "drag" | "pan" | "pinch";

export class Hands {
  private readonly viewport: Viewport;
  private readonly drag: Drag;
  private readonly places = new Map<number, [number, number]>();
  private way: Way | null = null;
  private leader = -1;
  /** Once a pen has touched the pane a lone finger moves it: the palm does not paint. */
  private hasPen = false;

  constructor(viewport: Viewport, drag: Drag) {
    this.viewport = viewport;
    this.drag = drag;
    const { pane } = viewport;
    pane.addEventListener("pointerdown", (event) => this.down(event));
    // What is raw does not wait for the next frame, where the browser has it.
    const moves = "onpointerrawupdate" in pane ? "pointerrawupdate" : "pointermove";
    pane.addEventListener(moves as "pointermove", (event) => this.move(event));
    for (const kind of ["pointerup", "pointercancel", "lostpointercapture"] as const)
      pane.addEventListener(kind, (event) => this.up(event));
    pane.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  private down(event: PointerEvent): void {
    const isTouch = event.pointerType === "touch";
    if (event.button > 1 || (this.way && !(isTouch && this.places.size === 1))) return;
    this.hasPen ||= event.pointerType === "pen";
    this.viewport.pane.setPointerCapture(event.pointerId);
    this.places.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.places.size === 2) {
      if (this.way === "drag") this.drag.cancel();
      this.way = "pinch";
      return;
    }
    this.leader = event.pointerId;
    const moves = event.button === 1 || space.isDown || (isTouch && this.hasPen);
    this.way = !moves && this.drag.begin(event) ? "drag" : "pan";
    if (event.button === 1) event.preventDefault();
  }

  private move(event: PointerEvent): void {
    const before = this.places.get(event.pointerId);
    if (!before) return;
    const [right, down] = [event.clientX - before[0], event.clientY - before[1]];
    if (this.way === "drag") this.drag.move(event);
    else if (this.way === "pan") {
      space.hasMoved ||= space.isDown;
      this.viewport.pan(right, down);
    } else if (this.way === "pinch") {
      const other = [...this.places].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const span = (x: number, y: number) => Math.max(Math.hypot(x - other[0], y - other[1]), 1);
        const [x, y] = [event.clientX, event.clientY];
        this.viewport.pan(right / 2, down / 2);
        this.viewport.zoom(span(x, y) / span(...before), (x + other[0]) / 2, (y + other[1]) / 2);
      }
    }
    this.places.set(event.pointerId, [event.clientX, event.clientY]);
  }

  private up(event: PointerEvent): void {
    if (!this.places.delete(event.pointerId)) return;
    if (this.way === "drag" && event.pointerId === this.leader) {
      if (event.type === "pointercancel") this.drag.cancel();
      else this.drag.end(event);
    }
    // A finger that is left of two must not paint.
    if (!this.places.size) this.way = null;
  }
}
