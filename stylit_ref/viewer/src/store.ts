// The views that are kept ready. They are decoded when they are first needed; the one that was not
// needed for longest gives way.

import { lensOf } from "./camera.js";
import { decode } from "./decode.js";
import { SLOTS, type Engine, type ViewPixels } from "./engine.js";
import { fieldOf } from "./fields.js";
import type { PageData } from "./page_data.js";
import { toRgba } from "./pixels.js";
import { pointsOf } from "./points.js";
import type { Source } from "./source.js";

export class Store {
  private readonly data: PageData;
  private readonly source: Source;
  private readonly pixels = new Map<number, ViewPixels>();
  /** By view; the one that was needed last stands last. */
  private readonly slots = new Map<number, number>();
  private readonly coming = new Map<number, Promise<void>>();
  private wanted: readonly number[] = [];
  private engine: Engine | null = null;

  constructor(data: PageData, source: Source) {
    this.data = data;
    this.source = source;
  }

  /** Hand all views to an engine, now and as they come. */
  attach(engine: Engine): void {
    this.engine = engine;
    for (const [view, slot] of this.slots) engine.keep(slot, this.pixels.get(view) as ViewPixels);
  }

  /** Where views are kept; null if some are still to come, which are asked for. */
  need(views: readonly number[]): number[] | null {
    this.want(views);
    return views.every((view) => this.slots.has(view)) ? views.map((view) => this.slots.get(view) as number) : null;
  }

  /** When views are there, or a sentence says why not. */
  async arrived(views: readonly number[]): Promise<void> {
    this.want(views);
    await Promise.all(views.filter((view) => !this.slots.has(view)).map((view) => this.fetch(view)));
  }

  /** Ask for views that may be needed next, one after the other, until others are needed. */
  async prepare(views: readonly number[]): Promise<void> {
    const { wanted } = this;
    for (const view of views) {
      if (this.wanted !== wanted) return;
      if (this.slots.has(view)) continue;
      await this.fetch(view);
      await new Promise((resolve) => setTimeout(resolve));
    }
  }

  /** None of these gives way; and of the others those before them do. */
  private want(views: readonly number[]): void {
    this.wanted = views;
    for (const view of views) {
      const slot = this.slots.get(view);
      if (slot === undefined) continue;
      this.slots.delete(view);
      this.slots.set(view, slot);
    }
  }

  private fetch(view: number): Promise<void> {
    let coming = this.coming.get(view);
    if (!coming) {
      coming = this.decoded(view)
        .then((pixels) => this.keep(view, pixels))
        .finally(() => this.coming.delete(view));
      this.coming.set(view, coming);
    }
    return coming;
  }

  private async decoded(view: number): Promise<ViewPixels> {
    const { nnf, picture, points, camera } = this.data.views[view];
    const { width, height } = this.data;
    const bytes = (piece: typeof nnf) => piece && decode(piece, this.source);
    const [field, colours, planes] = await Promise.all([bytes(nnf), bytes(picture), bytes(points)]);
    return {
      field: field && fieldOf(field, width, height),
      rgba: colours && toRgba(colours),
      points: planes && pointsOf(planes, width, height),
      lens: camera && lensOf(camera, width, height),
    };
  }

  private keep(view: number, pixels: ViewPixels): void {
    const slot = this.freeSlot();
    this.pixels.set(view, pixels);
    this.slots.set(view, slot);
    this.engine?.keep(slot, pixels);
  }

  private freeSlot(): number {
    if (this.slots.size < SLOTS) return this.slots.size;
    const oldest = [...this.slots.keys()].find((view) => !this.wanted.includes(view)) as number;
    const slot = this.slots.get(oldest) as number;
    this.slots.delete(oldest);
    this.pixels.delete(oldest);
    return slot;
  }
}
