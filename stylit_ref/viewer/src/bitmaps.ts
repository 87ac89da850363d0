// The numbers that a bitmap holds. Some browsers add noise to what a canvas is asked for, so that pages
// cannot recognize their users; the sum of the bytes shows it, and a texture is asked instead.

/** Red, green, blue and alpha; null if the browser cannot tell. */
export type ReadBitmap = (bitmap: ImageBitmap) => Uint8Array | Uint8ClampedArray | null;

export const READERS: ReadBitmap[] = [byCanvas, byTexture];

function byCanvas(bitmap: ImageBitmap): Uint8ClampedArray | null {
  const { width, height } = bitmap;
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const context = canvas.getContext("2d", { willReadFrequently: true, colorSpace: "srgb" });
  if (!context) return null;
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, width, height).data;
}

function byTexture(bitmap: ImageBitmap): Uint8Array | null {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return null;
  const { width, height } = bitmap;
  const pixels = new Uint8Array(4 * width * height);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8UI, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE, bitmap);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  const texture = gl.getParameter(gl.TEXTURE_BINDING_2D) as WebGLTexture;
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE, pixels);
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return pixels;
}
