// Pass 1 with a mesh: what a lens sees of it.

import type { Lens } from "../camera.js";
import { SKY, type Mesh, type Moment, type Stage } from "../engine.js";
import type { Buffers } from "./buffers.js";
import { program, type Context, type Target, type Texture } from "./context.js";
import { MESH_VERTEX, SURFACE, TEXELS } from "./mesh_shader.js";
import type { Surface } from "./surface.js";

export class MeshSurface implements Surface {
  private readonly context: Context;
  private readonly stage: Stage;
  private readonly count: number;
  private readonly triangles: Texture;
  private readonly target: Target;
  private readonly surface = program(SURFACE, MESH_VERTEX);

  constructor(context: Context, buffers: Buffers, stage: Stage, mesh: Mesh) {
    this.context = context;
    this.stage = stage;
    this.count = mesh.faces.length;
    this.triangles = uploaded(context, mesh);
    const { width, height } = stage;
    this.target = context.target([buffers.surface], width, height, { depth: context.depth(width, height) });
  }

  seeView(_slot: number, lens: Lens): void {
    this.see(lens, 1);
  }

  seePlace(moment: Moment): void {
    this.see(moment.lens as Lens, moment.step);
  }

  private see(lens: Lens, step: number): void {
    const { context } = this;
    const { gl } = context;
    const [width, height] = [this.stage.width, this.stage.height].map((side) => Math.ceil(side / step));
    const { eye, near, right, below, corner } = lens;
    const values = {
      triangles: this.triangles,
      lens: [lens.across, lens.down, lens.depth].flat(),
      eye, near, step,
      size: [width, height],
      ray: [...right, ...below, ...corner],
      middle: [this.stage.width / 2, this.stage.height / 2],
    };
    context.use(this.surface, values, { ...this.target, width, height });
    gl.clearBufferuiv(gl.COLOR, 0, [SKY, 0, 0, 0]);
    context.drawNearest(gl.TRIANGLES, 3 * this.count);
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
