// All passes in JavaScript, for browsers without WebGL 2, and for computers that emulate it.

import type { Lens } from "../camera.js";
import type { Engine, Moment, Stage, ViewPixels } from "../engine.js";
import { framesOf, shiftedWeights } from "../fading.js";
import type { Points } from "../points.js";
import { limitedSearch } from "./limited_search.js";
import { mix, mixShifted } from "./mix.js";
import { placesIn, type Places } from "./motion.js";
import { raster, type Surface } from "./raster.js";
import { shift } from "./shift.js";
import { beside } from "./silhouettes.js";
import { splat, surfaceOf } from "./splat.js";
import { vote } from "./vote.js";

/** A view that is kept, with what was made of it. */
interface Kept extends ViewPixels {
  labels: Uint16Array | null;
}

export class ScriptEngine implements Engine {
  readonly name = "script";
  private readonly canvas: CanvasRenderingContext2D;
  private readonly stage: Stage;
  private readonly kept: Kept[] = [];
  private readonly shown: ImageData;
  private readonly fields: { shifted: Uint16Array; searched: Uint16Array };
  private readonly voted: Uint8Array;
  private found: Places[] = [];
  private frames: Uint8Array[] = [];

  constructor(canvas: CanvasRenderingContext2D, stage: Stage) {
    const { width, height } = stage;
    this.canvas = canvas;
    this.stage = stage;
    this.shown = canvas.createImageData(width, height);
    this.fields = { shifted: new Uint16Array(2 * width * height), searched: new Uint16Array(2 * width * height) };
    this.voted = new Uint8Array(4 * width * height);
  }

  keep(slot: number, view: ViewPixels): void {
    this.kept[slot] = { ...view, labels: this.labelsOf(view) };
  }

  draw(moment: Moment): void {
    this.shown.data.set(this.picture(moment));
    this.canvas.putImageData(this.shown, 0, 0);
  }

  finish(): void {}

  /** `places` are those of the views around, in every pixel one after the other. */
  read(buffer: string): Uint8Array | Uint16Array | Int32Array {
    if (buffer === "shifted" || buffer === "searched") return this.fields[buffer];
    if (buffer === "places") {
      const views = this.found.length;
      return Int32Array.from({ length: views * this.found[0].length }, (_, i) => this.found[i % views][Math.floor(i / views)]);
    }
    if (buffer === "voted") return this.voted;
    return buffer === "mixed" ? Uint8Array.from(this.shown.data) : this.frames[Number(buffer.replace("frame", ""))];
  }

  /** Run the passes of a mode; returns four bytes a pixel. */
  private picture(moment: Moment): Uint8Array {
    const { mode, around } = moment;
    const views = around.map((view) => this.kept[view.slot]);
    const mixed = new Uint8Array(this.voted.length);
    if (mode === "linear") {
      mix(views.map((view) => this.pictureOf(view)), around.map((view) => view.linear), mixed);
      return mixed;
    }
    const places = (this.found = this.places(moment));
    if (mode === "image" || mode === "blend") {
      mixShifted(places, views.map((view) => this.pictureOf(view)), shiftedWeights(moment), mixed);
      return mixed;
    }
    const fields = views.map((view) => view.field as Uint16Array);
    const frames = framesOf(moment);
    // The closest view's frame is the last one, so that it is what buffers hold afterwards.
    const made = [...frames].reverse().map(({ order }) => {
      const [ownPlaces, ownFields] = [order.map((k) => places[k]), order.map((k) => fields[k])];
      return this.frame(ownPlaces, ownFields, mode === "nnf");
    });
    this.frames = made.reverse();
    if (made.length === 1) return made[0];
    mix(this.frames, frames.map((frame) => frame.weight), mixed);
    return mixed;
  }

  private frame(places: Places[], fields: Uint16Array[], isShiftAlone: boolean): Uint8Array {
    const { shifted, searched } = this.fields;
    shift(places, fields, shifted);
    vote(shifted, this.stage, this.voted);
    if (isShiftAlone) return this.voted;
    limitedSearch(places, fields, shifted, this.voted, this.stage, searched);
    const picture = new Uint8Array(this.voted.length);
    vote(searched, this.stage, picture);
    return picture;
  }

  private places(moment: Moment): Places[] {
    const { lens, around, step } = moment;
    const { width, height } = this.stage;
    if (!lens) throw new Error("this mode needs the model");
    const [surface, near] = this.see(lens, moment);
    return around.map((view) => {
      const labels = this.kept[view.slot].labels as Uint16Array;
      return placesIn(labels, lens, view.lens as Lens, surface, near, step, width, height);
    });
  }

  /** What a lens sees at every `step`-th pixel, and the pixel whose face and motion each takes. */
  private see(lens: Lens, { around, step }: Moment): [Surface, Int32Array] {
    const { width, height, mesh, reach } = this.stage;
    const views = around.map((view) => ({ points: this.kept[view.slot].points as Points, lens: view.lens as Lens }));
    const surface = mesh ? raster(mesh, lens, width, height, step) : splat(views, lens, width, height, step);
    return [surface, beside(surface, Math.max(1, Math.round(reach / step)))];
  }

  private labelsOf({ lens, points }: ViewPixels): Uint16Array | null {
    const { width, height, reach, mesh } = this.stage;
    if (!lens || (!mesh && !points)) return null;
    const surface = mesh ? raster(mesh, lens, width, height, 1) : surfaceOf(points as Points, width, height);
    return Uint16Array.from(beside(surface, reach), (q) => surface.faces[q]);
  }

  /** The picture of a view, which its field gives; made when a mode first needs it. */
  private pictureOf(view: Kept): Uint8Array {
    if (!view.rgba) {
      view.rgba = new Uint8Array(this.voted.length);
      vote(view.field as Uint16Array, this.stage, view.rgba);
    }
    return view.rgba;
  }
}
