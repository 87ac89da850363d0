// Bytes within the text of a page. Its encoding is windows-1252, in which each byte is a character of its
// own; stylit_ref/viewer/embedding.py writes them.

import { PageError } from "./page_data.js";

const DECODER = new TextDecoder("windows-1252");
const ESCAPE = 61;

/** The byte of each character. */
const BYTES = new Uint8Array(65536);
const LETTERS = DECODER.decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
for (let byte = 0; byte < 256; byte++) BYTES[LETTERS.charCodeAt(byte)] = byte;

/** After an escape there is a byte that HTML would change, 64 above itself. */
export function bytesIn(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(text.length);
  let length = 0;
  for (let i = 0; i < text.length; i++) {
    const byte = BYTES[text.charCodeAt(i)];
    bytes[length++] = byte === ESCAPE ? BYTES[text.charCodeAt(++i)] - 64 : byte;
  }
  return bytes.slice(0, length);
}

/** The element that holds the byte 255 alone. */
const PROBE = "stylit-probe";

/** The page as it was written. */
export async function pageAsWritten(): Promise<Document> {
  if (isAsWritten(document)) return document;
  const page = await loadedAgain();
  if (page && isAsWritten(page)) return page;
  throw new PageError("This page is damaged: a program saved it again in another text encoding. Ask for it again.");
}

/** A server may tell the browser another encoding, but what a page loads is told none. */
async function loadedAgain(): Promise<Document | null> {
  if (!location.protocol.startsWith("http")) return null;
  try {
    const page = await fetch(location.href);
    return new DOMParser().parseFromString(DECODER.decode(await page.arrayBuffer()), "text/html");
  } catch {
    return null;
  }
}

/** What has no probe is cut off, and says so by what else is missing. */
function isAsWritten(page: Document): boolean {
  const probe = page.getElementById(PROBE);
  return !probe || probe.textContent === LETTERS[255];
}
