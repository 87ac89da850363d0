// Passes 1 and 2: what a lens sees of the mesh, with strokes beside silhouettes.

import { clipMatrix, type Lens } from "../camera.js";
import { SKY, type Mesh, type Stage } from "../engine.js";
import type { Buffers } from "./buffers.js";
import { program, type Context, type Target } from "./context.js";
import { MESH_ATTRIBUTES, MESH_VERTEX, SURFACE } from "./mesh_shader.js";
import { BESIDE, RIMS, RIMS_IN_ROW } from "./silhouettes.js";

export class Surfaces {
  private readonly context: Context;
  private readonly buffers: Buffers;
  private readonly stage: Stage;
  private readonly triangles: WebGLVertexArrayObject;
  private readonly depth: WebGLRenderbuffer;
  private readonly targets = new Map<string, Target>();
  private readonly surface = program(SURFACE, MESH_VERTEX, MESH_ATTRIBUTES);
  private readonly rims = program(RIMS);
  private readonly rimsInRow = program(RIMS_IN_ROW);
  private readonly beside = program(BESIDE);

  constructor(context: Context, buffers: Buffers, stage: Stage, mesh: Mesh) {
    this.context = context;
    this.buffers = buffers;
    this.stage = stage;
    this.triangles = uploaded(context.gl, mesh);
    this.depth = context.depth(stage.width, stage.height);
    context.gl.depthFunc(context.gl.LEQUAL);
  }

  /** Write `surface` and `beside` at every `step`-th pixel; returns their size. */
  see(lens: Lens, step: number): [number, number] {
    const { context, buffers, stage } = this;
    const { gl } = context;
    const [width, height] = [stage.width, stage.height].map((side) => Math.ceil(side / step));
    const size = [width, height];
    const { eye, right, below, corner } = lens;
    const values = { clip: clipMatrix(lens, width, height, step), eye, ray: [...right, ...below, ...corner], step };
    context.use(this.surface, values, this.target("surface", width, height));
    gl.clearBufferuiv(gl.COLOR, 0, [SKY, 0, 0, 0]);
    gl.clearBufferfv(gl.DEPTH, 0, [1]);
    gl.enable(gl.DEPTH_TEST);
    gl.bindVertexArray(this.triangles);
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

function uploaded(gl: WebGL2RenderingContext, mesh: Mesh): WebGLVertexArrayObject {
  const vertices = new Float32Array(24 * mesh.faces.length);
  mesh.faces.forEach((face, t) => {
    const plane = mesh.planes.subarray(4 * t, 4 * t + 4);
    for (let k = 0; k < 3; k++) {
      const to = 24 * t + 8 * k;
      vertices.set(mesh.corners.subarray(9 * t + 3 * k, 9 * t + 3 * k + 3), to);
      vertices[to + 3] = face;
      vertices.set(plane, to + 4);
    }
  });
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
  for (const place of [0, 1]) {
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 4, gl.FLOAT, false, 32, 16 * place);
  }
  return array;
}
