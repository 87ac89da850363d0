// A WebGL 2 context, with what all passes do alike.

/** A pair of shaders; it is compiled when it is first used. */
export interface Program {
  fragment: string;
  vertex: string;
  linked: { program: WebGLProgram; uniforms: Map<string, Uniform> } | null;
}

interface Uniform {
  location: WebGLUniformLocation;
  type: number;
}

export interface Texture {
  texture: WebGLTexture;
  format: Format;
  isArray: boolean;
}

export interface Target {
  framebuffer: WebGLFramebuffer;
  width: number;
  height: number;
}

/** Whole numbers, and the model: nothing is filtered, and nothing is rounded by the hardware. */
export type Format = keyof typeof KINDS;

export type Value = Texture | number | readonly number[];

const HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp isampler2D;
precision highp usampler2DArray;
`;

/** A triangle that covers the target. */
const WHOLE = `
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4. - 1., 1., 1.);
}`;

export function program(fragment: string, vertex: string = WHOLE): Program {
  return { fragment, vertex, linked: null };
}

export class Context {
  readonly gl: WebGL2RenderingContext;

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
    gl.disable(gl.DITHER);
  }

  texture(format: Format, width: number, height: number, layers = 0): Texture {
    const { gl } = this;
    const target = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
    const texture = gl.createTexture();
    gl.bindTexture(target, texture);
    if (layers) gl.texStorage3D(target, 1, gl[format], width, height, layers);
    else gl.texStorage2D(target, 1, gl[format], width, height);
    // Textures of whole numbers count as missing with any other filter.
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, filter, gl.NEAREST);
    return { texture, format, isArray: layers > 0 };
  }

  /** Set all pixels of a texture, or of a layer of it. */
  set(to: Texture, width: number, height: number, values: ArrayBufferView, layer = 0): void {
    const { gl } = this;
    const kind = KINDS[to.format];
    const [format, type] = [gl[kind.format], gl[kind.type]];
    if (to.isArray) {
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, to.texture);
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, width, height, 1, format, type, values);
    } else {
      gl.bindTexture(gl.TEXTURE_2D, to.texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, values);
    }
  }

  target(textures: Texture[], width: number, height: number, options: { depth?: WebGLRenderbuffer; layer?: number } = {}): Target {
    const { gl } = this;
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    textures.forEach(({ texture, isArray }, i) => {
      if (isArray) gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, texture, 0, options.layer ?? 0);
      else gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0);
    });
    gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    if (options.depth) gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, options.depth);
    return { framebuffer, width, height };
  }

  depth(width: number, height: number): WebGLRenderbuffer {
    const { gl } = this;
    const depth = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
    return depth;
  }

  /** Take a program, its textures and its other uniforms, and a target; null is the canvas. */
  use(program: Program, values: Record<string, Value>, target: Target | null): void {
    const { gl } = this;
    const { program: linked, uniforms } = (program.linked ??= this.link(program));
    gl.bindFramebuffer(gl.FRAMEBUFFER, target ? target.framebuffer : null);
    if (target) gl.viewport(0, 0, target.width, target.height);
    else gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.useProgram(linked);
    let unit = 0;
    for (const [name, uniform] of uniforms) {
      const value = values[name];
      if (value === undefined) throw new Error(`the uniform ${name} is not set`);
      if (typeof value === "object" && "texture" in value) {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(value.isArray ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, value.texture);
        gl.uniform1i(uniform.location, unit++);
      } else this.setNumbers(uniform, typeof value === "number" ? [value] : value);
    }
  }

  /** Draw the whole target with a program. */
  fill(program: Program, values: Record<string, Value>, target: Target | null): void {
    this.use(program, values, target);
    this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
  }

  /** Draw with the program in use what is nearest, by inverse depths; of what is as near the first. */
  drawNearest(mode: number, vertices: number): void {
    const { gl } = this;
    gl.clearBufferfv(gl.DEPTH, 0, [0]);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.GREATER);
    gl.drawArrays(mode, 0, vertices);
    gl.disable(gl.DEPTH_TEST);
  }

  /** The pixels of a texture. */
  read(from: Texture, width: number, height: number): Numbers {
    const { gl } = this;
    const target = this.target([from], width, height);
    const isSigned = from.format === "RGBA16I";
    const all = isSigned ? new Int32Array(4 * width * height) : new Uint32Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, isSigned ? gl.INT : gl.UNSIGNED_INT, all);
    gl.deleteFramebuffer(target.framebuffer);
    const { channels, numbers } = KINDS[from.format];
    const read = new numbers(width * height * channels);
    for (let i = 0, to = 0; i < all.length; i += 4) for (let c = 0; c < channels; c++) read[to++] = all[i + c];
    return read;
  }

  private link({ fragment, vertex }: Program): { program: WebGLProgram; uniforms: Map<string, Uniform> } {
    const { gl } = this;
    const program = gl.createProgram();
    const shaders = ([["VERTEX_SHADER", vertex], ["FRAGMENT_SHADER", fragment]] as const).map(([kind, source]) => {
      const shader = gl.createShader(gl[kind]) as WebGLShader;
      gl.shaderSource(shader, HEAD + source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      return shader;
    });
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error([gl.getProgramInfoLog(program), ...shaders.map((each) => gl.getShaderInfoLog(each))].join(" "));
    const uniforms = new Map<string, Uniform>();
    const count = (gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) as number | null) ?? 0;
    for (let i = 0; i < count; i++) {
      const { name, type } = gl.getActiveUniform(program, i) as WebGLActiveInfo;
      const location = gl.getUniformLocation(program, name) as WebGLUniformLocation;
      uniforms.set(name.replace("[0]", ""), { location, type });
    }
    return { program, uniforms };
  }

  private setNumbers({ location, type }: Uniform, numbers: readonly number[]): void {
    const { gl } = this;
    if (type === gl.INT) gl.uniform1iv(location, numbers);
    else if (type === gl.INT_VEC2) gl.uniform2iv(location, numbers);
    else if (type === gl.INT_VEC4) gl.uniform4iv(location, numbers);
    else if (type === gl.FLOAT) gl.uniform1fv(location, numbers);
    else if (type === gl.FLOAT_VEC2) gl.uniform2fv(location, numbers);
    else if (type === gl.FLOAT_VEC3) gl.uniform3fv(location, numbers);
    else if (type === gl.FLOAT_VEC4) gl.uniform4fv(location, numbers);
    else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(location, false, numbers);
    else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(location, false, numbers);
    else throw new Error(`uniforms of type ${type} are not known here`);
  }
}

export type Numbers = Uint8Array | Uint16Array | Uint32Array | Int16Array | Float32Array;

/** Of each format: channels, the arrays that hold its numbers, and what WebGL calls both. */
const KINDS = {
  R8UI: { channels: 1, numbers: Uint8Array, format: "RED_INTEGER", type: "UNSIGNED_BYTE" },
  R16UI: { channels: 1, numbers: Uint16Array, format: "RED_INTEGER", type: "UNSIGNED_SHORT" },
  RG16UI: { channels: 2, numbers: Uint16Array, format: "RG_INTEGER", type: "UNSIGNED_SHORT" },
  RG32UI: { channels: 2, numbers: Uint32Array, format: "RG_INTEGER", type: "UNSIGNED_INT" },
  RGBA8UI: { channels: 4, numbers: Uint8Array, format: "RGBA_INTEGER", type: "UNSIGNED_BYTE" },
  RGBA16I: { channels: 4, numbers: Int16Array, format: "RGBA_INTEGER", type: "SHORT" },
  RGBA32F: { channels: 4, numbers: Float32Array, format: "RGBA", type: "FLOAT" },
} as const;
