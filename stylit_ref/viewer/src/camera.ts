// A pinhole camera as passes need it. Rows of all buffers go down, as those of images do.

import type { Camera } from "./page_data.js";
import { combine, cross, dot, minus, unit, type Vector } from "./vectors.js";

/** A row of a matrix: it is multiplied by (x, y, z, 1). */
export type Row = [number, number, number, number];

export interface Lens {
  eye: Vector;
  near: number;
  /** A point is at pixel (across / depth, down / depth), whole at pixel centres, if depth > 0. */
  across: Row;
  down: Row;
  depth: Row;
  /** The ray through a pixel (x, y) is x * right + y * below + corner; of depth 1. */
  right: Vector;
  below: Vector;
  corner: Vector;
}

const RADIANS = Math.PI / 180;

/** What is nearer than that part of the way to the camera's target is not seen. */
const NEAR = 0.01;

export function lensOf(camera: Camera, width: number, height: number): Lens {
  const eye = camera.origin;
  const away = minus(camera.target, eye);
  const forward = unit(away);
  const rightward = unit(cross(forward, camera.up));
  const upward = cross(rightward, forward);
  const focal = height / (2 * Math.tan((camera.fieldOfView * RADIANS) / 2));
  const focalAcross = focal / camera.pixelAspect;
  const middle = (width - 1) / 2 - (camera.shift[0] * height) / camera.pixelAspect;
  const centre = (height - 1) / 2 + camera.shift[1] * height;
  const row = (axis: Vector): Row => [...axis, -dot(axis, eye)];
  return {
    eye,
    near: NEAR * Math.hypot(...away),
    across: row(combine([focalAcross, rightward], [middle, forward])),
    down: row(combine([-focal, upward], [centre, forward])),
    depth: row(forward),
    right: combine([1 / focalAcross, rightward]),
    below: combine([-1 / focal, upward]),
    corner: combine([1, forward], [-middle / focalAcross, rightward], [centre / focal, upward]),
  };
}

/** Where the camera of an orbit stands, at an azimuth and an elevation in degrees. */
export function onOrbit(target: Vector, up: Vector, azimuth: number, elevation: number, distance: number): Vector {
  const axis = unit(up);
  const inFront = Math.abs(axis[1]) < Math.abs(axis[2]) ? [0, -1, 0] : [0, 0, 1];
  const front = unit(combine([1, inFront], [-dot(inFront, axis), axis]));
  const [a, e] = [azimuth * RADIANS, elevation * RADIANS];
  const level = combine([Math.cos(a), front], [Math.sin(a), cross(axis, front)]);
  return combine([1, target], [distance * Math.cos(e), level], [distance * Math.sin(e), axis]);
}

/**
 * The matrix that takes (x, y, 1, v), a pixel of one lens and its inverse depth v, to where another one
 * sees the point: (across, down, depth), up to a factor. Row by row.
 */
export function transferOf(from: Lens, to: Lens): Row[] {
  return [to.across, to.down, to.depth].map((row) => [
    dot(row, from.right),
    dot(row, from.below),
    dot(row, from.corner),
    dot(row, from.eye) + row[3],
  ]);
}
