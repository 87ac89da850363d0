// The textures that passes write to and read from.

import type { Stage } from "../engine.js";
import type { Context, Texture } from "./context.js";

/** Of the views that are kept: a layer for each. */
export type Kept = "fields" | "pictures" | "points" | "labels";

/** Of the frame that is being made; each is a target of its own. */
export type Work =
  | "sparse" | "surface" | "rims" | "rimsInRow" | "beside" | "motion01" | "motion23" | "hidden"
  | "shifted" | "voted" | "searched" | "frame0" | "frame1" | "frame2" | "frame3" | "mixed";

export type Buffers = Record<Kept | Work | "style", Texture>;

export function makeBuffers(context: Context, stage: Stage): Buffers {
  const { width, height, style, mesh, hasPoints, slots } = stage;
  const kept = (format: Texture["format"], isNeeded: boolean) =>
    isNeeded ? context.texture(format, width, height, slots) : context.texture(format, 1, 1, 1);
  const work = (format: Texture["format"]) => context.texture(format, width, height);
  // Fields are arrays, so that a vote reads those of views and those of frames alike.
  const field = () => context.texture("RG16UI", width, height, 1);
  const buffers: Buffers = {
    fields: kept("RG16UI", style !== null),
    pictures: kept("RGBA8UI", true),
    points: kept("RG32UI", hasPoints),
    labels: kept("R16UI", mesh !== null || hasPoints),
    style: context.texture("RGBA8UI", style?.width ?? 1, style?.height ?? 1),
    sparse: work("RG32UI"),
    surface: work("RG32UI"),
    rims: work("R8UI"),
    rimsInRow: work("R8UI"),
    beside: work("RG16UI"),
    motion01: work("RGBA16I"),
    motion23: work("RGBA16I"),
    hidden: work("R8UI"),
    shifted: field(),
    voted: work("RGBA8UI"),
    searched: field(),
    frame0: work("RGBA8UI"),
    frame1: work("RGBA8UI"),
    frame2: work("RGBA8UI"),
    frame3: work("RGBA8UI"),
    mixed: work("RGBA8UI"),
  };
  if (style) context.set(buffers.style, style.width, style.height, style.rgba);
  return buffers;
}
