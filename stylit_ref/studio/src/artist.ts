// Who paints: strokes, undo and redo, whichever hand leads the brush.

import type { Dab } from "./brush.js";
import { History } from "./history.js";
import type { Painting } from "./painting.js";
import { Path } from "./path.js";
import type { Sample } from "./pen.js";
import { pack } from "./pixels.js";
import { around, type Rect } from "./rect.js";
import type { Sender } from "./sender.js";
import type { Settings } from "./settings.js";
import { Stroke, type Ink } from "./stroke.js";

const PAPER: Ink = { width: 1, height: 1, pixels: Uint32Array.of(0xffffffff) };

export class Artist {
  history = new History();
  /** What the painting began with. */
  beginning: Ink = PAPER;
  texture: Ink | null = null;
  /** Whether the page may paint; a reader may not. */
  mayPaint = false;
  private readonly settings: Settings;
  private readonly sender: Sender;
  /** Called whenever undo and redo may have become possible or not. */
  readonly tell: () => void;
  private painting: Painting | null = null;
  private stroke: Stroke | null = null;
  private path: Path | null = null;

  constructor(settings: Settings, sender: Sender, tell: () => void) {
    this.settings = settings;
    this.sender = sender;
    this.tell = tell;
  }

  /** Work on a painting, which has no history yet. */
  use(painting: Painting): void {
    this.painting = this.sender.painting = painting;
    this.beginning = PAPER;
    this.stroke = this.path = null;
    this.forget();
  }

  /** Nothing that was painted can be undone. */
  forget(): void {
    this.history = new History();
    this.tell();
  }

  get isPainting(): boolean {
    return this.stroke !== null;
  }

  begin(sample: Sample, time?: number): void {
    if (!this.mayPaint || !this.painting) return;
    this.end();
    const { brush, rgb, tool } = this.settings.chosen;
    if (tool !== "eraser" && !this.paintsTexture) this.settings.used(rgb);
    this.stroke = new Stroke(this.painting, this.ink, brush);
    this.path = new Path(brush, sample);
    this.add(this.path.begin(), time);
  }

  /** Go on to places, one after the other. */
  move(samples: Sample[], time?: number): void {
    const { path } = this;
    if (path) this.add(samples.flatMap((sample) => [...path.move(sample)]), time);
  }

  end(time?: number): void {
    if (!this.stroke || !this.path) return;
    this.add(this.path.finish(), time);
    this.history.add(this.stroke.before);
    this.stroke = this.path = null;
    this.sender.rest();
    this.tell();
  }

  /** It was no stroke: a second finger came. */
  cancel(): void {
    if (!this.stroke) return;
    this.sender.changed(this.stroke.cancel());
    this.stroke = this.path = null;
    this.sender.rest();
  }

  undo(): void {
    this.turnBack((painting) => this.history.undo(painting));
  }

  redo(): void {
    this.turnBack((painting) => this.history.redo(painting));
  }

  /** Take over a painting from elsewhere; it can be undone. */
  replace(rgb: Uint8Array): void {
    const painting = this.painting as Painting;
    this.cancel();
    this.history.add(new Map([...painting.tilesOf(painting.whole)].map((tile) => [tile, painting.copyTile(tile)])));
    painting.replace(rgb);
    this.tell();
  }

  private turnBack(turn: (painting: Painting) => Rect | null): void {
    if (!this.mayPaint || !this.painting) return;
    this.end();
    this.sender.changed(turn(this.painting));
    this.sender.rest();
    this.tell();
  }

  private add(dabs: Iterable<Dab>, time?: number): void {
    let changed: Rect | null = null;
    for (const dab of dabs) changed = around(changed, (this.stroke as Stroke).add(dab));
    this.sender.changed(changed, time);
  }

  private get paintsTexture(): boolean {
    return this.settings.chosen.usesTexture && this.texture !== null;
  }

  private get ink(): Ink {
    const { tool, rgb, erasesTo } = this.settings.chosen;
    if (tool === "eraser") return erasesTo === "beginning" ? this.beginning : PAPER;
    if (this.paintsTexture) return this.texture as Ink;
    return { width: 1, height: 1, pixels: Uint32Array.of(pack(...rgb)) };
  }
}
