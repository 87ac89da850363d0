// Passes 1 and 2: what a lens sees of the mesh, with strokes beside silhouettes.

import type { Lens } from "../camera.js";
import { SKY, type Mesh, type Stage } from "../engine.js";
import type { Buffers } from "./buffers.js";
import { program, type Context, type Target, type Texture } from "./context.js";
import { MESH_VERTEX, SURFACE, TEXELS } from "./mesh_shader.js";
import { BESIDE, RIMS, RIMS_IN_ROW } from "./silhouettes.js";

export class Surfaces {
  private readonly context: Context;
  private readonly buffers: Buffers;
  private readonly stage: Stage;
  private readonly triangles: Texture;
  private readonly depth: WebGLRenderbuffer;
  private readonly targets = new Map<string, Target>();
  private readonly surface = program(SURFACE, MESH_VERTEX);
  private readonly rims = program(RIMS);
  private readonly rimsInRow = program(RIMS_IN_ROW);
  private readonly beside = program(BESIDE);

  constructor(context: Context, buffers: Buffers, stage: Stage, mesh: Mesh) {
    this.context = context;
    this.buffers = buffers;
    this.stage = stage;
    this.triangles = uploaded(context, mesh);
    this.depth = context.depth(stage.width, stage.height);
    // The depth is an inverse one; of what is as near the first counts.
    context.gl.depthFunc(context.gl.GREATER);
  }

  /** Write `surface` and `beside` at every `step`-th pixel; returns their size. */
  see(lens: Lens, step: number): [number, number] {
    const { context, buffers, stage } = this;
    const { gl } = context;
    const [width, height] = [stage.width, stage.height].map((side) => Math.ceil(side / step));
    const size = [width, height];
    const { eye, near, right, below, corner } = lens;
    const values = {
      triangles: this.triangles,
      lens: [lens.across, lens.down, lens.depth].flat(),
      eye, near, size, step,
      ray: [...right, ...below, ...corner],
      middle: [stage.width / 2, stage.height / 2],
    };
    context.use(this.surface, values, this.target("surface", width, height));
    gl.clearBufferuiv(gl.COLOR, 0, [SKY, 0, 0, 0]);
    gl.clearBufferfv(gl.DEPTH, 0, [0]);
    gl.enable(gl.DEPTH_TEST);
    gl.drawArrays(gl.TRIANGLES, 0, 3 * (stage.mesh as Mesh).faces.length);
    gl.disable(gl.DEPTH_TEST);
    const { surface, rims, rimsInRow } = buffers;
    const reach = Math.max(1, Math.round(stage.reach / step));
    context.fill(this.rims, { surface, size }, this.target("rims", width, height));
    context.fill(this.rimsInRow, { rims, size, reach }, this.target("rimsInRow", width, height));
    context.fill(this.beside, { surface, rims, rimsInRow, size, reach }, this.target("beside", width, height));
    return [width, height];
  }

  private target(name: "surface" | "rims" | "rimsInRow" | "beside", width: number, height: number): Target {
    const key = `${name} ${width}`;
    let target = this.targets.get(key);
    if (!target) {
      const options = name === "surface" ? { depth: this.depth } : {};
      target = this.context.target([this.buffers[name]], width, height, options);
      this.targets.set(key, target);
    }
    return target;
  }
}

function uploaded(context: Context, mesh: Mesh): Texture {
  const count = mesh.faces.length;
  const width = TEXELS * Math.min(count, 512);
  const height = Math.ceil((TEXELS * count) / width);
  const texels = new Float32Array(4 * width * height);
  for (let t = 0; t < count; t++) {
    const to = 4 * TEXELS * t;
    for (let k = 0; k < 3; k++) {
      texels.set(mesh.corners.subarray(9 * t + 3 * k, 9 * t + 3 * k + 3), to + 4 * k);
      texels[to + 4 * k + 3] = mesh.faces[t];
    }
    texels.set(mesh.planes.subarray(4 * t, 4 * t + 4), to + 12);
  }
  const texture = context.texture("RGBA32F", width, height);
  context.set(texture, width, height, texels);
  return texture;
}
