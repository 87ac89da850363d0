// The drawing: where one is, what is drawn, and when.

import { lensOf } from "./camera.js";
import type { Engine, Moment } from "./engine.js";
import { framesOf } from "./fading.js";
import type { Grid, Place } from "./grid.js";
import { STEPS, type Mode, type Motion } from "./modes.js";
import { Pace } from "./pace.js";
import { PageError, type Camera, type PageData } from "./page_data.js";
import type { Store } from "./store.js";

/** Milliseconds without a turn until the drawing counts as resting. */
const REST = 200;

const STILL_TO_COME = "Views are still to come. Try again in a moment.";

/** What the viewer tells about itself. */
export interface Told {
  rests(place: Place): void;
  rate(framesPerSecond: number | null): void;
  waits(mode: Mode | null): void;
  /** Views cannot be had for now; what is drawn stays. */
  lacks(error: unknown): void;
  fails(error: unknown): void;
}

export class Viewer {
  readonly pace = new Pace();
  place: Place;
  mode: Mode;
  motion: Motion;
  /** Milliseconds from when the page was opened until it drew. */
  firstDrawn: number | null = null;
  private readonly data: PageData;
  private readonly grid: Grid;
  private readonly store: Store;
  private readonly told: Told;
  private engine: Engine | null = null;
  private isDirty = false;
  private asked = 0;
  private isMoving = true; // so the first picture is quick, and the rest follows
  private restTimer = 0;

  constructor(data: PageData, grid: Grid, store: Store, place: Place, mode: Mode, motion: Motion, told: Told) {
    this.data = data;
    this.grid = grid;
    this.store = store;
    this.place = grid.within(place);
    this.mode = mode;
    this.motion = motion;
    this.told = told;
  }

  /** Draw with an engine from now on; without one nothing is drawn. */
  use(engine: Engine | null): void {
    this.engine = engine;
    if (!engine) return;
    this.store.attach(engine);
    this.isMoving = true;
    this.ask();
  }

  turn(right: number, up: number): void {
    this.go([this.place[0] + right, this.place[1] + up]);
  }

  go(place: Place): void {
    this.place = this.grid.within(place);
    this.isMoving = true;
    clearTimeout(this.restTimer);
    this.ask();
  }

  choose(mode: Mode, motion: Motion): void {
    this.mode = mode;
    this.motion = motion;
    this.ask();
  }

  /** Draw a place at once with all passes, whatever the pace; views must be there. */
  drawNow(mode: Mode = this.mode): Engine {
    const moment = this.moment(mode);
    if (!moment || !this.engine) throw new PageError(STILL_TO_COME);
    this.engine.draw(moment);
    return this.engine;
  }

  /** The fields that the picture of this place is voted from, and their weights; views must be there. */
  fields(): { pixels: Uint16Array; weight: number }[] {
    const moment = this.moment(this.mode);
    if (!moment || !this.engine) throw new PageError(STILL_TO_COME);
    const { engine, mode } = this;
    // Fading frames are drawn one by one, since buffers hold the last one alone.
    const found = framesOf(moment).map(({ order, weight }) => {
      engine.draw({ ...moment, mode: mode === "fade" ? "limited" : mode, around: order.map((k) => moment.around[k]) });
      return { pixels: (engine.read(mode === "nnf" ? "shifted" : "searched") as Uint16Array).slice(), weight };
    });
    engine.draw(moment);
    return found;
  }

  /** The views that are needed here. */
  get needed(): number[] {
    return this.grid.around(this.place).map((neighbour) => neighbour.view);
  }

  private ask(): void {
    if (this.isDirty) return;
    this.isDirty = true;
    this.asked = performance.now();
    requestAnimationFrame((now) => this.tried(() => this.frame(now)));
  }

  private tried(step: () => void): void {
    try {
      step();
    } catch (error) {
      this.told.fails(error);
    }
  }

  private frame(now: number): void {
    this.isDirty = false;
    if (!this.engine) return;
    const waits = this.isMoving && this.pace.isSlow && this.mode !== quick(this.mode);
    const moment = this.moment(waits ? quick(this.mode) : this.mode);
    if (!moment) {
      const needed = this.needed;
      this.store.arrived(needed).then(() => this.ask(), (error: unknown) => this.told.lacks(error));
      return;
    }
    this.told.waits(waits ? this.mode : null);
    this.engine.draw(moment);
    this.firstDrawn ??= performance.now();
    clearTimeout(this.restTimer);
    if (this.isMoving) {
      this.pace.moved(this.asked, now, performance.now(), !waits);
      this.restTimer = setTimeout(() => this.tried(() => this.rest(waits)), REST);
    }
    this.told.rate(this.pace.framesPerSecond);
  }

  /** What had to wait is drawn now, and how long it takes is remembered. */
  private rest(hasWaited: boolean): void {
    this.isMoving = false;
    if (!this.engine) return;
    const begun = performance.now();
    if (hasWaited) {
      this.drawNow();
      this.engine.finish();
      this.told.waits(null);
    }
    this.pace.rested(hasWaited ? performance.now() - begun : null);
    this.told.rate(this.pace.framesPerSecond);
    this.told.rests(this.place);
    // What cannot be had is told when it is needed.
    this.store.prepare(this.grid.beyond(this.place)).catch(() => undefined);
  }

  private moment(mode: Mode): Moment | null {
    const around = this.grid.around(this.place);
    const slots = this.store.need(around.map((neighbour) => neighbour.view));
    if (!slots) return null;
    const { width, height, views } = this.data;
    const lens = (camera: Camera | null) => camera && lensOf(camera, width, height);
    return {
      mode,
      lens: lens(this.grid.hasCameras ? this.grid.camera(this.place) : null),
      around: around.map(({ view, linear, fading }, k) => ({ slot: slots[k], linear, fading, lens: lens(views[view].camera) })),
      step: STEPS[this.motion],
    };
  }
}

/** What takes the place of a mode that has to wait. */
const quick = (mode: Mode): Mode => (mode === "limited" || mode === "fade" ? "nnf" : mode);
