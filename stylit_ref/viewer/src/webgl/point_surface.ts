// Pass 1 without a mesh: the points of the views around, carried to the pixels that they land on.

import { transferOf, type Lens } from "../camera.js";
import { SKY, type Moment, type Stage } from "../engine.js";
import { SLACK } from "../points.js";
import type { Buffers } from "./buffers.js";
import { program, type Context, type Target } from "./context.js";
import type { Surface } from "./surface.js";

/** A vertex for each pixel of each view around, the closest view's first. */
const SPLAT_VERTEX = `
uniform usampler2DArray points;
uniform vec4 transfers[12];
uniform ivec4 slots;
uniform ivec2 viewSize, size;
uniform int step;
flat out uint label;
flat out float inverse;
flat out float merit;
void main() {
  int pixels = viewSize.x * viewSize.y, k = gl_VertexID / pixels, n = gl_VertexID % pixels;
  ivec2 from = ivec2(n % viewSize.x, n / viewSize.x);
  uvec2 seen = texelFetch(points, ivec3(from, slots[k]), 0).xy;
  float v = uintBitsToFloat(seen.y);
  vec4 pixel = vec4(from, 1., v);
  float depth = dot(transfers[3 * k + 2], pixel);
  vec2 at = vec2(dot(transfers[3 * k], pixel), dot(transfers[3 * k + 1], pixel)) / depth;
  label = seen.x;
  inverse = v / depth;
  gl_PointSize = 1.;
  vec2 landed = floor((floor(at + .5) + .5) / float(step)) + .5;
  vec2 away = (at + .5) / float(step) - landed;
  merit = inverse * (1. - ${SLACK} * dot(away, away));
  gl_Position = v > 0. && depth > 0. ? vec4(2. * landed / vec2(size) - 1., 0., 1.) : vec4(2., 2., 0., 1.);
}`;

const SPLAT = `
flat in uint label;
flat in float inverse;
flat in float merit;
uniform float near;
layout(location = 0) out uvec2 surface;
void main() {
  surface = uvec2(label, floatBitsToUint(inverse));
  gl_FragDepth = merit * near;
}`;

/** A surface that is seen from closer by leaves gaps; of the two sides the farther one counts, to the left and right first. */
const FILL_HOLES = `
uniform usampler2D sparse;
uniform ivec2 size;
layout(location = 0) out uvec2 surface;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  surface = texelFetch(sparse, p, 0).xy;
  if (surface.x != ${SKY}u) return;
  for (int k = 0; k < 2; k++) {
    ivec2 d = ivec2(1 - k, k);
    if (p - d != clamp(p - d, ivec2(0), size - 1) || p + d != clamp(p + d, ivec2(0), size - 1)) continue;
    uvec2 one = texelFetch(sparse, p - d, 0).xy, other = texelFetch(sparse, p + d, 0).xy;
    if (one.x == ${SKY}u || other.x == ${SKY}u) continue;
    surface = uintBitsToFloat(other.y) < uintBitsToFloat(one.y) ? other : one;
    return;
  }
}`;

const COPY = `
uniform usampler2DArray points;
uniform int slot;
layout(location = 0) out uvec2 surface;
void main() { surface = texelFetch(points, ivec3(gl_FragCoord.xy, slot), 0).xy; }`;

export class PointSurface implements Surface {
  private readonly context: Context;
  private readonly buffers: Buffers;
  private readonly stage: Stage;
  private readonly sparse: Target;
  private readonly surface: Target;
  private readonly splat = program(SPLAT, SPLAT_VERTEX);
  private readonly fillHoles = program(FILL_HOLES);
  private readonly copy = program(COPY);

  constructor(context: Context, buffers: Buffers, stage: Stage) {
    const { width, height } = stage;
    this.context = context;
    this.buffers = buffers;
    this.stage = stage;
    this.sparse = context.target([buffers.sparse], width, height, { depth: context.depth(width, height) });
    this.surface = context.target([buffers.surface], width, height);
  }

  seeView(slot: number): void {
    this.context.fill(this.copy, { points: this.buffers.points, slot }, this.surface);
  }

  seePlace({ lens, around, step }: Moment): void {
    const { context, stage } = this;
    const { gl } = context;
    const [width, height] = [stage.width, stage.height].map((side) => Math.ceil(side / step));
    const place = lens as Lens;
    const rows = around.flatMap((view) => transferOf(view.lens as Lens, place)).flat();
    const { points, sparse } = this.buffers;
    const size = [width, height];
    const values = {
      points, size, step,
      transfers: [...rows, ...Array<number>(48 - rows.length).fill(0)],
      slots: [0, 1, 2, 3].map((k) => around[k]?.slot ?? 0),
      viewSize: [stage.width, stage.height],
      near: place.near,
    };
    context.use(this.splat, values, { ...this.sparse, width, height });
    gl.clearBufferuiv(gl.COLOR, 0, [SKY, 0, 0, 0]);
    context.drawNearest(gl.POINTS, around.length * stage.width * stage.height);
    context.fill(this.fillHoles, { sparse, size }, { ...this.surface, width, height });
  }
}
