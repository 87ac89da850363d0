// Pass 1 in JavaScript: the face that each pixel shows, and its inverse depth.

import type { Lens } from "../camera.js";
import { SKY, type Mesh } from "../engine.js";
import { dot } from "../vectors.js";

export interface Surface {
  width: number;
  height: number;
  faces: Uint16Array;
  /** 0 is the sky. */
  inverse: Float32Array;
}

/** Of every `step`-th pixel of a picture. */
export function raster(mesh: Mesh, lens: Lens, pictureWidth: number, pictureHeight: number, step: number): Surface {
  const [width, height] = [pictureWidth, pictureHeight].map((side) => Math.ceil(side / step));
  const surface: Surface = {
    width,
    height,
    faces: new Uint16Array(width * height).fill(SKY),
    inverse: new Float32Array(width * height),
  };
  for (let t = 0; t < mesh.faces.length; t++) {
    const plane = mesh.planes.subarray(4 * t, 4 * t + 4) as unknown as number[];
    const distance = -(dot(plane, lens.eye) + plane[3]);
    const polygon = seen(mesh.corners.subarray(9 * t, 9 * t + 9), lens, step);
    if (polygon.length < 3 || distance === 0) continue;
    const depth = [lens.right, lens.below, lens.corner].map((each) => dot(plane, each) / distance);
    fill(surface, polygon, mesh.faces[t], depth as [number, number, number], step);
  }
  return surface;
}

type Point = [x: number, y: number];

/** A triangle in pixels of the surface, without what is behind the near plane. */
function seen(corners: Float32Array, lens: Lens, step: number): Point[] {
  const rows = [lens.across, lens.down, lens.depth];
  const ends = [0, 3, 6].map((from) => {
    const point = corners.subarray(from, from + 3) as unknown as number[];
    return rows.map((row) => dot(row, point) + row[3]);
  });
  const polygon: Point[] = [];
  const add = (end: number[]) =>
    polygon.push([(end[0] / end[2] + 0.5) / step - 0.5, (end[1] / end[2] + 0.5) / step - 0.5]);
  ends.forEach((one, k) => {
    const other = ends[(k + 1) % 3];
    if (one[2] > lens.near) add(one);
    if (one[2] > lens.near !== other[2] > lens.near) {
      const along = (lens.near - one[2]) / (other[2] - one[2]);
      add(one.map((each, i) => each + along * (other[i] - each)));
    }
  });
  return polygon;
}

/** Fill a convex polygon row by row, where it is nearest. */
function fill(surface: Surface, polygon: Point[], face: number, [a, b, c]: [number, number, number], step: number): void {
  const { width, height, faces, inverse } = surface;
  const down = polygon.map((point) => point[1]);
  const first = Math.max(Math.ceil(Math.min(...down)), 0);
  const last = Math.min(Math.floor(Math.max(...down)), height - 1);
  for (let y = first; y <= last; y++) {
    let [left, right] = [Infinity, -Infinity];
    for (let k = 0; k < polygon.length; k++) {
      const [x0, y0] = polygon[k];
      const [x1, y1] = polygon[(k + 1) % polygon.length];
      if (y0 === y1 || y < Math.min(y0, y1) || y > Math.max(y0, y1)) continue;
      const x = x0 + ((y - y0) * (x1 - x0)) / (y1 - y0);
      left = Math.min(left, x);
      right = Math.max(right, x);
    }
    const row = b * ((y + 0.5) * step - 0.5) + c;
    for (let x = Math.max(Math.ceil(left), 0); x <= Math.min(Math.floor(right), width - 1); x++) {
      const depth = Math.fround(a * ((x + 0.5) * step - 0.5) + row);
      if (!(depth > inverse[y * width + x])) continue; // it is no number in a triangle seen edge-on
      inverse[y * width + x] = depth;
      faces[y * width + x] = face;
    }
  }
}
