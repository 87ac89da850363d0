// All passes on the graphics processor, in textures of whole numbers.

import { transferOf, type Lens } from "../camera.js";
import { type Engine, type Moment, type Stage, type ViewPixels } from "../engine.js";
import { framesOf, shiftedWeights } from "../fading.js";
import { Beside } from "./beside.js";
import { makeBuffers, type Buffers, type Work } from "./buffers.js";
import { Context, program, type Numbers, type Target, type Texture, type Value } from "./context.js";
import { MIX_FRAMES, SHOW } from "./finish.js";
import { limitedSearch } from "./limited_search.js";
import { MeshSurface } from "./mesh_surface.js";
import { MOTION } from "./motion.js";
import { PointSurface } from "./point_surface.js";
import { MIX_SHIFTED, MIX_VIEWS, SHIFT } from "./shift.js";
import { LABELS } from "./silhouettes.js";
import type { Surface } from "./surface.js";
import { vote } from "./vote.js";

/** Motion between pixels is told in sixteenths of one, if it is not found at every pixel. */
const FINE_BITS = 4;

const FRAMES = ["frame0", "frame1", "frame2", "frame3"] as const;

type Values = Record<string, Value>;

export class WebglEngine implements Engine {
  readonly name = "webgl";
  private readonly context: Context;
  private readonly stage: Stage;
  private readonly buffers: Buffers;
  private readonly surface: Surface | null;
  private readonly beside: Beside;
  private readonly targets = new Map<string, Target>();
  private readonly hasPicture: boolean[];
  private readonly labels = program(LABELS);
  private readonly motion = program(MOTION);
  private readonly shift = program(SHIFT);
  private readonly vote;
  private readonly search;
  private readonly mixFrames = program(MIX_FRAMES);
  private readonly mixShifted = program(MIX_SHIFTED);
  private readonly mixViews = program(MIX_VIEWS);
  private readonly show = program(SHOW);

  constructor(gl: WebGL2RenderingContext, stage: Stage) {
    this.context = new Context(gl);
    this.stage = stage;
    this.hasPicture = Array<boolean>(stage.slots).fill(false);
    this.buffers = makeBuffers(this.context, stage);
    if (stage.mesh) this.surface = new MeshSurface(this.context, this.buffers, stage, stage.mesh);
    else this.surface = stage.hasPoints ? new PointSurface(this.context, this.buffers, stage) : null;
    this.beside = new Beside(this.context, this.buffers, stage);
    this.vote = program(vote(stage.patchRadius));
    this.search = program(limitedSearch(stage.patchRadius));
  }

  keep(slot: number, view: ViewPixels): void {
    const { context, buffers } = this;
    const { width, height } = this.stage;
    if (view.field) context.set(buffers.fields, width, height, view.field, slot);
    if (view.rgba) context.set(buffers.pictures, width, height, view.rgba, slot);
    this.hasPicture[slot] = view.rgba !== null;
    if (view.points) context.set(buffers.points, width, height, view.points, slot);
    if (!view.lens || !this.surface) return;
    this.surface.seeView(slot, view.lens);
    this.beside.find(1);
    const { surface, beside } = buffers;
    context.fill(this.labels, { surface, beside }, this.layer("labels", slot));
  }

  draw(moment: Moment): void {
    const picture = this.picture(moment);
    this.context.fill(this.show, { picture, size: this.size }, null);
  }

  /** Only what is read is surely there. */
  finish(): void {
    const { gl } = this.context;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  read(buffer: string): Numbers {
    const { width, height } = this.stage;
    return this.context.read(this.buffers[buffer as Work], width, height);
  }

  private get size(): [number, number] {
    return [this.stage.width, this.stage.height];
  }

  /** Run the passes of a mode; returns the texture that they end in. */
  private picture(moment: Moment): Texture {
    const { mode, around } = moment;
    const { pictures, voted, mixed } = this.buffers;
    const slots = around.map((view) => view.slot);
    const views = { slots: four(slots), count: slots.length };
    if (mode === "linear") {
      this.votePictures(slots);
      const weights = four(around.map((view) => view.linear));
      this.fill(this.mixViews, { ...views, weights, pictures }, "mixed");
      return mixed;
    }
    const places = { ...views, ...this.findMotion(moment) };
    if (mode === "image" || mode === "blend") {
      this.votePictures(slots);
      const values = { ...places, weights: four(shiftedWeights(moment)), order: four([0, 1, 2, 3]), pictures };
      this.fill(this.mixShifted, values, "mixed");
      return mixed;
    }
    const frames = framesOf(moment);
    // The closest view's frame is the last one, so that it is what buffers hold afterwards.
    for (const n of [...frames.keys()].reverse()) this.makeFrame(mode === "nnf", frames[n].order, places, FRAMES[n]);
    if (mode === "nnf") return voted;
    if (frames.length === 1) return this.buffers.frame0;
    const { frame0, frame1, frame2, frame3 } = this.buffers;
    const weights = four(frames.map((frame) => frame.weight));
    this.fill(this.mixFrames, { frame0, frame1, frame2, frame3, weights }, "mixed");
    return mixed;
  }

  /** Shift and vote; search and vote. */
  private makeFrame(isShiftAlone: boolean, order: number[], places: Values, into: Work): void {
    const { fields, shifted, voted, searched, style } = this.buffers;
    const asked = { ...places, order: four(order), fields };
    this.fill(this.shift, asked, "shifted");
    this.fill(this.vote, { field: shifted, layer: 0, style, size: this.size }, "voted");
    if (isShiftAlone) return;
    this.fill(this.search, { ...asked, field: shifted, picture: voted, style }, "searched");
    this.fill(this.vote, { field: searched, layer: 0, style, size: this.size }, into);
  }

  /** Find the motion of a moment; returns what passes need to read it. */
  private findMotion(moment: Moment): Values {
    const { lens, around, step } = moment;
    const { surface, beside, labels, motion01, motion23, hidden } = this.buffers;
    if (!lens || !this.surface) throw new Error("this mode needs the model");
    this.see(this.surface, moment);
    const [width, height] = this.size.map((side) => Math.ceil(side / step));
    const rows = around.flatMap((view) => transferOf(lens, view.lens as Lens)).flat();
    const transfers = [...rows, ...Array<number>(48 - rows.length).fill(0)];
    const values = {
      surface, beside, labels, transfers, slots: four(around.map((view) => view.slot)), size: this.size,
      count: around.length, step, bits: step === 1 ? 0 : FINE_BITS,
    };
    const target = this.made(`motion ${step}`, () =>
      this.context.target([motion01, motion23, hidden], width, height),
    );
    this.context.fill(this.motion, values, target);
    const { size, bits } = values;
    return { motion01, motion23, hidden, size, step, bits };
  }

  /** What a lens sees at every `step`-th pixel, and the pixel whose face and motion each takes. */
  private see(surface: Surface, moment: Moment): void {
    surface.seePlace(moment);
    this.beside.find(moment.step);
  }

  /** The pictures of views, which their fields give; made when a mode first needs them. */
  private votePictures(slots: number[]): void {
    const { fields, style } = this.buffers;
    for (const layer of slots.filter((slot) => !this.hasPicture[slot])) {
      this.context.fill(this.vote, { field: fields, layer, style, size: this.size }, this.layer("pictures", layer));
      this.hasPicture[layer] = true;
    }
  }

  private fill(of: ReturnType<typeof program>, values: Values, into: Work): void {
    const { width, height } = this.stage;
    const target = this.made(into, () => this.context.target([this.buffers[into]], width, height));
    this.context.fill(of, values, target);
  }

  private layer(of: "labels" | "pictures", layer: number): Target {
    const { width, height } = this.stage;
    return this.made(`${of} ${layer}`, () => this.context.target([this.buffers[of]], width, height, { layer }));
  }

  private made(name: string, make: () => Target): Target {
    let target = this.targets.get(name);
    if (!target) this.targets.set(name, (target = make()));
    return target;
  }
}

/** Four numbers, since passes take as many views. */
function four(numbers: readonly number[]): number[] {
  return [0, 1, 2, 3].map((k) => numbers[k] ?? 0);
}
