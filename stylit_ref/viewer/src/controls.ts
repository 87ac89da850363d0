// Turning the model by mouse, touch and keys.

import type { Grid, Place } from "./grid.js";

/** Told by how much to turn, in degrees; or to go to the middle. */
export interface Turned {
  by(right: number, up: number): void;
  home(): void;
}

/** Of the way from view to view, for a press of an arrow key. */
const STEP = 0.05;
const WHOLE_TURN = 180;
/** After so many milliseconds a glide has lost most of its speed. */
const GLIDE = 180;

const ARROWS: Record<string, Place> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function control(canvas: HTMLCanvasElement, grid: Grid, turned: Turned): void {
  const prefersStillness = matchMedia("(prefers-reduced-motion: reduce)");
  let speed: Place = [0, 0];
  let before = 0;
  let finger: number | null = null;

  canvas.addEventListener("pointerdown", (event) => {
    if (finger !== null || event.button !== 0) return;
    finger = event.pointerId;
    canvas.setPointerCapture(finger);
    speed = [0, 0];
    before = event.timeStamp;
    last = [event.clientX, event.clientY];
  });
  let last: [number, number] = [0, 0];
  canvas.addEventListener("pointermove", (event) => {
    if (event.pointerId !== finger) return;
    const scale = scaleOf(canvas, grid);
    // The model follows the hand, so the eye goes the other way.
    const right = -(event.clientX - last[0]) * scale[0];
    const up = (event.clientY - last[1]) * scale[1];
    const time = Math.max(event.timeStamp - before, 1);
    last = [event.clientX, event.clientY];
    before = event.timeStamp;
    speed = [right / time, up / time];
    turned.by(right, up);
  });
  const release = (event: PointerEvent) => {
    if (event.pointerId !== finger) return;
    finger = null;
    if (!prefersStillness.matches && event.timeStamp - before < 50) requestAnimationFrame(glide);
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("lostpointercapture", release);

  const glide = (now: number) => {
    if (finger !== null || Math.hypot(...speed) < 1e-3) return;
    const time = Math.min(Math.max(now - before, 0), 50);
    before = now;
    turned.by(speed[0] * time, speed[1] * time);
    const kept = Math.exp(-time / GLIDE);
    speed = [speed[0] * kept, speed[1] * kept];
    requestAnimationFrame(glide);
  };

  canvas.addEventListener("keydown", (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const arrow = ARROWS[event.key];
    if (event.key === "Home") turned.home();
    else if (arrow) {
      const steps = event.shiftKey ? 1 : STEP;
      const [right, up] = grid.spacing;
      turned.by(arrow[0] * steps * right, arrow[1] * steps * up);
    } else return;
    speed = [0, 0]; // a glide would lead away again
    event.preventDefault();
  });
}

/** Degrees a pixel: the width of the canvas is the whole grid, or half a turn. */
function scaleOf(canvas: HTMLCanvasElement, grid: Grid): Place {
  const { clientWidth, clientHeight } = canvas;
  const [right, up] = grid.reach.map((reach) => Math.min(2 * reach, WHOLE_TURN));
  return [right / clientWidth, up / clientHeight];
}
