// Which engine draws.

import type { Engine, Stage } from "./engine.js";
import type { Parameters } from "./parameters.js";
import { PageError } from "./page_data.js";
import { ScriptEngine } from "./script/engine.js";
import { WebglEngine } from "./webgl/engine.js";

const SETTINGS: WebGLContextAttributes = {
  alpha: false,
  antialias: false,
  depth: false,
  powerPreference: "high-performance",
};

/** Names of programs that stand in for a graphics processor. */
const EMULATED = /swiftshader|llvmpipe|softpipe|basic render/i;

/** WebGL 2 where a graphics processor runs it, else JavaScript, which is faster than an emulated one. */
export class Engines {
  private readonly canvas: HTMLCanvasElement;
  private readonly gl: WebGL2RenderingContext | null;
  private readonly flat: CanvasRenderingContext2D | null;

  /** `longest` is the longest side of all images, which textures have to hold. */
  constructor(canvas: HTMLCanvasElement, width: number, height: number, longest: number, asked: Parameters["engine"]) {
    canvas.width = width;
    canvas.height = height;
    this.canvas = canvas;
    const chosen = asked ?? (hasProcessor(longest) ? "webgl" : "script");
    this.gl = chosen === "webgl" ? canvas.getContext("webgl2", SETTINGS) : null;
    this.flat = this.gl ? null : canvas.getContext("2d");
    if (!this.gl && !this.flat)
      throw new PageError("This browser can draw neither with WebGL 2 nor on a canvas. Open the page in another one.");
  }

  make(stage: Stage): Engine {
    return this.gl ? new WebglEngine(this.gl, stage) : new ScriptEngine(this.flat as CanvasRenderingContext2D, stage);
  }

  /** A browser may take a WebGL context away, and give it back without what was in it. */
  onRestored(lost: () => void, restored: () => void): void {
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      lost();
    });
    this.canvas.addEventListener("webglcontextrestored", restored);
  }
}

function hasProcessor(longest: number): boolean {
  const gl = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  if (!gl || gl.getParameter(gl.MAX_TEXTURE_SIZE) < longest) return false;
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return !EMULATED.test(name);
}
