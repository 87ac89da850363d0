// Where pieces come from: the page itself, or scripts in a folder beside it. Browsers let a page that
// was opened from the disk load scripts, and nothing else.

import { PageError, type PageData } from "./page_data.js";

declare global {
  interface Window {
    stylitPiece?: (name: string, text: string) => void;
  }
}

/** Gives the text of a piece, in base64. */
export type Source = (name: string) => Promise<string>;

export function sourceOf(data: PageData): Source {
  return data.folder === null ? inPage : inFolder(data.folder);
}

async function inPage(name: string): Promise<string> {
  const text = document.getElementById(name)?.textContent;
  if (text == null) throw new PageError(`This page is incomplete: ${name} is missing. Ask for it again.`);
  return text;
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
        if (text === undefined) reject(new PageError(`${file} is damaged. Copy the whole folder again.`));
        else resolve(text);
      };
      script.onerror = () => {
        script.remove();
        reject(new PageError(`${file} is missing. Copy the whole folder again.`));
      };
      document.head.append(script);
    });
}
