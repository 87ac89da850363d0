// Where pieces come from: the page itself, or scripts in a folder beside it. Browsers let a page that
// was opened from the disk load scripts, and nothing else.

import { bytesIn, pageAsWritten } from "./embedding.js";
import { PageError, type PageData } from "./page_data.js";

declare global {
  interface Window {
    stylitPiece?: (name: string, text: string) => void;
  }
}

export type Bytes = Uint8Array<ArrayBuffer>;

/** Gives the packed bytes of a piece. */
export type Source = (name: string) => Promise<Bytes>;

export function sourceOf(data: PageData): Source {
  return data.folder === null ? inPage() : inFolder(data.folder);
}

function inPage(): Source {
  const page = pageAsWritten();
  return async (name) => {
    const text = (await page).getElementById(name)?.textContent;
    if (text == null) throw new PageError(`This page is incomplete: ${name} is missing. Ask for it again.`);
    return bytesIn(text);
  };
}

function inFolder(folder: string): Source {
  const arrived = new Map<string, string>();
  window.stylitPiece = (name, text) => arrived.set(name, text);
  return (name) =>
    new Promise((resolve, reject) => {
      const script = document.createElement("script");
      const file = `${folder}/${name}.js`;
      script.src = file;
      script.onload = () => {
        const text = arrived.get(name);
        arrived.delete(name);
        script.remove();
        const bytes = text === undefined ? null : fromBase64(text);
        if (bytes) resolve(bytes);
        else reject(new PageError(`${file} is damaged. Copy the whole folder again.`));
      };
      script.onerror = () => {
        script.remove();
        reject(new PageError(`${file} is missing. Copy the whole folder again.`));
      };
      document.head.append(script);
    });
}

function fromBase64(text: string): Bytes | null {
  try {
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    return null;
  }
}
