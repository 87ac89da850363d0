// From a piece to its bytes: exactly those that were exported, or a sentence.

import { PageError, type Piece } from "./page_data.js";
import type { Source } from "./source.js";

/** Reads red, green, blue and alpha of a bitmap, untouched. */
export type ReadBitmap = (bitmap: ImageBitmap) => Uint8Array | Uint8ClampedArray;

export async function decode(piece: Piece, source: Source, readBitmap: ReadBitmap): Promise<Uint8Array<ArrayBuffer>> {
  const text = await source(piece.name);
  let bytes: Uint8Array<ArrayBuffer>;
  try {
    const packed = fromBase64(text);
    bytes = piece.coding === "webp" ? await ofWebp(packed, readBitmap) : await inflate(packed);
  } catch (error) {
    if (error instanceof ReferenceError || error instanceof TypeError && typeof DecompressionStream === "undefined")
      throw new PageError("This browser is too old for the page. Open it in a current one.");
    throw damaged(piece);
  }
  if (bytes.length !== piece.bytes || crc32(bytes) !== piece.sum) throw damaged(piece);
  return bytes;
}

function damaged(piece: Piece): PageError {
  return new PageError(`This page is damaged: ${piece.name} does not hold what was exported. Ask for it again.`);
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text.trim());
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

async function inflate(packed: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Colours must stay numbers: no alpha is multiplied, no colour space converted. */
async function ofWebp(packed: Uint8Array<ArrayBuffer>, readBitmap: ReadBitmap): Promise<Uint8Array<ArrayBuffer>> {
  const blob = new Blob([packed], { type: "image/webp" });
  const bitmap = await createImageBitmap(blob, { premultiplyAlpha: "none", colorSpaceConversion: "none" });
  const pixels = readBitmap(bitmap);
  bitmap.close();
  const bytes = new Uint8Array((pixels.length / 4) * 3);
  for (let from = 0, to = 0; from < pixels.length; from += 4, to += 3) {
    bytes[to] = pixels[from];
    bytes[to + 1] = pixels[from + 1];
    bytes[to + 2] = pixels[from + 2];
  }
  return bytes;
}

const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; bit++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
});

function crc32(bytes: Uint8Array): number {
  let sum = 0xffffffff;
  for (let i = 0; i < bytes.length; i++) sum = TABLE[(sum ^ bytes[i]) & 255] ^ (sum >>> 8);
  return (sum ^ 0xffffffff) >>> 0;
}
