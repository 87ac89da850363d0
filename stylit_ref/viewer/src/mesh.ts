// The model, from the bytes of a page.

import { SKY, type Mesh } from "./engine.js";
import type { MeshData } from "./page_data.js";
import { cross, dot, minus, unit } from "./vectors.js";

/**
 * Planes are computed here: the point that a pixel shows is where its ray meets the plane. Positions that
 * are interpolated over a large triangle are off by more.
 */
export function meshOf(data: MeshData, bytes: Uint8Array<ArrayBuffer>): Mesh {
  const count = data.triangles;
  const corners = new Float32Array(bytes.buffer, 0, 9 * count);
  const labels = new Uint32Array(bytes.buffer, 36 * count, count);
  const planes = new Float32Array(4 * count);
  for (let t = 0; t < count; t++) {
    const [a, b, c] = [0, 3, 6].map((from) => corners.subarray(9 * t + from, 9 * t + from + 3) as unknown as number[]);
    const normal = unit(cross(minus(b, a), minus(c, a)));
    planes.set([...normal, -dot(normal, a)], 4 * t);
  }
  return { corners, faces: Uint16Array.from(labels, (label) => label % SKY), planes };
}
