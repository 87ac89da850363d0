// A grid of views: which of them stand around a place, and how much each counts there.

import { onOrbit } from "./camera.js";
import type { Axis, Camera, PageData } from "./page_data.js";

/** To the right and upwards, in degrees from the middle of the grid; in steps where cameras are unknown. */
export type Place = [right: number, up: number];

/** A view around a place. Weights are whole numbers; those of all views around have the sum WHOLE. */
export interface Neighbour {
  view: number;
  linear: number;
  fading: number;
}

const ONE = 256;
export const WHOLE = ONE * ONE;

/** The two rows or columns around a place; the same one twice where an axis has one alone. */
interface Between {
  low: number;
  high: number;
  at: number;
  lowAt: number;
  highAt: number;
}

export class Grid {
  private readonly data: PageData;

  constructor(data: PageData) {
    this.data = data;
  }

  get hasCameras(): boolean {
    return this.data.views.every((view) => view.camera !== null);
  }

  /** What a grid reaches to the right and upwards, from the middle; a ring has no end. */
  get reach(): Place {
    return [reachOf(this.data.columns), reachOf(this.data.rows)];
  }

  /** The mean way from a view to the next. */
  get spacing(): Place {
    return [spacingOf(this.data.columns), spacingOf(this.data.rows)];
  }

  /** The nearest place that the grid has. */
  within(place: Place): Place {
    const { columns, rows } = this.data;
    return [held(place[0], columns), held(place[1], rows)];
  }

  /** The views around a place, the closest first; of those as close, by row and column. */
  around(place: Place): Neighbour[] {
    const { columns, rows, fadeBand } = this.data;
    const [across, upwards] = [between(place[0], columns), between(place[1], rows)];
    const found = sides(upwards, fadeBand).flatMap((row) =>
      sides(across, fadeBand).map((column) => ({
        view: row.number * columns.positions.length + column.number,
        linear: row.linear * column.linear,
        fading: row.fading * column.fading,
        distance: (across.at - column.at) ** 2 + (upwards.at - row.at) ** 2,
      })),
    );
    return found.sort((a, b) => a.distance - b.distance || a.view - b.view);
  }

  /** The views beyond those around, which a next turn may need: with them 16 at most. */
  beyond(place: Place): number[] {
    const { columns, rows } = this.data;
    const [across, upwards] = [beside(between(place[0], columns), columns), beside(between(place[1], rows), rows)];
    const around = this.around(place).map((neighbour) => neighbour.view);
    const all = upwards.flatMap((row) => across.map((column) => row * columns.positions.length + column));
    return all.filter((view) => !around.includes(view));
  }

  /** The camera at a place. Around a target it stays on its orbit; whatever else differs is blended. */
  camera(place: Place): Camera {
    const { columns, rows, views } = this.data;
    const [across, upwards] = [between(place[0], columns), between(place[1], rows)];
    const at = (row: number, column: number) => views[row * columns.positions.length + column].camera as Camera;
    const [low, high] = [upwards.low, upwards.high].map((row) =>
      blended(at(row, across.low), at(row, across.high), share(across)),
    );
    const camera = blended(low, high, share(upwards));
    if (columns.unit === "steps") return camera;
    const { target, up, turn, rise, distance } = camera;
    return { ...camera, origin: onOrbit(target, up, across.at + turn, upwards.at + rise, distance) };
  }
}

function reachOf(axis: Axis): number {
  const { positions, isRing } = axis;
  return isRing ? Infinity : (positions[positions.length - 1] - positions[0]) / 2;
}

function spacingOf(axis: Axis): number {
  const count = axis.positions.length;
  return axis.isRing ? 360 / count : count > 1 ? (2 * reachOf(axis)) / (count - 1) : 1;
}

function held(place: number, axis: Axis): number {
  const reach = reachOf(axis);
  return axis.isRing ? ((place % 360) + 360) % 360 : Math.min(Math.max(place, -reach), reach);
}

/** The rows or columns around, and one more on each side, where there is one. */
function beside({ low, high }: Between, { positions, isRing }: Axis): number[] {
  const count = positions.length;
  const four = [low - 1, low, high, high + 1];
  const there = isRing ? four.map((each) => (each + count) % count) : four.filter((each) => each >= 0 && each < count);
  return [...new Set(there)];
}

/** Of a place on a position it is the lower of the two, unless it is the last one. */
function between(place: number, axis: Axis): Between {
  const first = axis.positions[0];
  const count = axis.positions.length;
  const positions = axis.isRing ? [...axis.positions, first + 360] : axis.positions;
  const at = axis.isRing ? first + (((place % 360) + 360) % 360) : place + (first + positions[count - 1]) / 2;
  if (count === 1) return { low: 0, high: 0, at, lowAt: first, highAt: first };
  let low = 0;
  while (low < positions.length - 2 && at >= positions[low + 1]) low++;
  return { low, high: (low + 1) % count, at, lowAt: positions[low], highAt: positions[low + 1] };
}

/** Each row or column of the two, and its weights; once where both are one. */
function sides(between: Between, band: number): { number: number; at: number; linear: number; fading: number }[] {
  const { low, high, lowAt, highAt } = between;
  if (low === high) return [{ number: low, at: lowAt, linear: ONE, fading: ONE }];
  const linear = Math.floor(share(between) * ONE + 0.5);
  const fading = fadingWeight(between, band);
  return [
    { number: low, at: lowAt, linear: ONE - linear, fading: ONE - fading },
    { number: high, at: highAt, linear, fading },
  ];
}

/** Views fade into each other around the middle between them; with no band they switch there. */
function fadingWeight({ at, lowAt, highAt }: Between, band: number): number {
  const middle = (lowAt + highAt) / 2;
  const width = band * (highAt - lowAt);
  if (width === 0) return at > middle ? ONE : 0;
  return Math.min(Math.max(Math.floor((0.5 + (at - middle) / width) * ONE + 0.5), 0), ONE);
}

function share({ at, lowAt, highAt }: Between): number {
  return highAt === lowAt ? 0 : (at - lowAt) / (highAt - lowAt);
}

function blended(a: Camera, b: Camera, along: number): Camera {
  const mix = (p: number, q: number) => p + (q - p) * along;
  const mixAll = <T extends number[]>(p: T, q: T) => p.map((each, i) => mix(each, q[i])) as T;
  return {
    origin: mixAll(a.origin, b.origin),
    target: mixAll(a.target, b.target),
    up: mixAll(a.up, b.up),
    fieldOfView: mix(a.fieldOfView, b.fieldOfView),
    shift: mixAll(a.shift, b.shift),
    pixelAspect: mix(a.pixelAspect, b.pixelAspect),
    turn: mix(a.turn, b.turn),
    rise: mix(a.rise, b.rise),
    distance: mix(a.distance, b.distance),
  };
}
