// Undo and redo: what tiles held before, byte for byte.

import { TILE, type Painting } from "./painting.js";
import { around, type Rect } from "./rect.js";

/** Tiles by their numbers. */
export type Tiles = Map<number, Uint32Array>;

const MOST_BYTES = 256 * 1024 * 1024;
/** After an hour of painting the page is not larger than after ten minutes. */
const MOST_STEPS = 100;
const TILE_BYTES = 4 * TILE * TILE;

export class History {
  private readonly most: number;
  private undoable: Tiles[] = [];
  private redoable: Tiles[] = [];

  /** Keeps so many bytes at most; the oldest changes give way. */
  constructor(most = MOST_BYTES) {
    this.most = most;
  }

  get canUndo(): boolean {
    return this.undoable.length > 0;
  }

  get canRedo(): boolean {
    return this.redoable.length > 0;
  }

  get bytes(): number {
    return [...this.undoable, ...this.redoable].reduce((sum, tiles) => sum + tiles.size, 0) * TILE_BYTES;
  }

  /** A change has been made; `before` is what it changed. */
  add(before: Tiles): void {
    if (!before.size) return;
    this.redoable = [];
    this.undoable.push(before);
    while (this.bytes > this.most || this.undoable.length > MOST_STEPS) this.undoable.shift();
  }

  /** Take the last change back; where the painting differs now, or null. */
  undo(painting: Painting): Rect | null {
    return swap(painting, this.undoable, this.redoable);
  }

  redo(painting: Painting): Rect | null {
    return swap(painting, this.redoable, this.undoable);
  }
}

function swap(painting: Painting, from: Tiles[], to: Tiles[]): Rect | null {
  const tiles = from.pop();
  if (!tiles) return null;
  let changed: Rect | null = null;
  for (const [tile, copy] of tiles) {
    tiles.set(tile, painting.copyTile(tile));
    changed = around(changed, painting.writeTile(tile, copy));
  }
  to.push(tiles);
  return changed;
}
