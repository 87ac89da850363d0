// From a piece to its bytes: exactly those that were exported, or a sentence.

import { READERS } from "./bitmaps.js";
import { PageError, type Piece } from "./page_data.js";
import type { Bytes, Source } from "./source.js";

export async function decode(piece: Piece, source: Source): Promise<Bytes> {
  if (typeof DecompressionStream === "undefined" || typeof createImageBitmap === "undefined")
    throw new PageError("This browser is too old for the page. Open it in a current one.");
  const packed = await source(piece.name);
  try {
    const attempts = piece.coding === "webp" ? ofWebp(packed) : [inflate(packed)];
    for await (const bytes of attempts) if (bytes.length === piece.bytes && crc32(bytes) === piece.sum) return bytes;
  } catch {
    // What is no WebP or no deflate is damaged too.
  }
  throw damaged(piece);
}

function damaged(piece: Piece): PageError {
  return new PageError(`This page is damaged: ${piece.name} does not hold what was exported. Ask for it again.`);
}

async function inflate(packed: Bytes): Promise<Bytes> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Colours must stay numbers: no alpha is multiplied, no colour space converted. */
async function* ofWebp(packed: Bytes): AsyncGenerator<Bytes> {
  const blob = new Blob([packed], { type: "image/webp" });
  const bitmap = await createImageBitmap(blob, { premultiplyAlpha: "none", colorSpaceConversion: "none" });
  for (const read of READERS) {
    const pixels = read(bitmap);
    if (pixels) yield withoutAlpha(pixels);
  }
}

function withoutAlpha(pixels: Uint8Array | Uint8ClampedArray): Bytes {
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
