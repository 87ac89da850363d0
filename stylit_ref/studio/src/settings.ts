// The tool in hand: which one, its brush, its colour. The browser remembers them.

import type { Brush } from "./brush.js";
import type { Rgb } from "./colour.js";

export type Tool = "brush" | "eraser" | "picker" | "hand";
/** What an eraser leaves: the picture that the painting began with, or white paper. */
export type Ground = "beginning" | "paper";

export interface Chosen {
  tool: Tool;
  brush: Brush;
  rgb: Rgb;
  /** Paint with the texture in place of the colour. */
  usesTexture: boolean;
  erasesTo: Ground;
  recent: Rgb[];
}

export const LARGEST = 400;
const KEY = "stylit-studio-tool";
const MOST_RECENT = 10;

const DEFAULTS: Chosen = {
  tool: "brush",
  brush: { size: 14, opacity: 1, hardness: 0.7, smoothing: 0.15, grain: "smooth", pressure: "size", tilts: true },
  rgb: [34, 51, 91],
  usesTexture: false,
  erasesTo: "beginning",
  recent: [[34, 51, 91], [178, 58, 42], [232, 163, 61], [74, 124, 89], [92, 158, 178], [246, 240, 226]],
};

export class Settings {
  chosen: Chosen = remembered();
  private readonly told: (() => void)[] = [];

  /** Call it now and whenever something is chosen. */
  onChange(tell: () => void): void {
    this.told.push(tell);
    tell();
  }

  choose(change: Partial<Chosen>): void {
    this.chosen = { ...this.chosen, ...change };
    this.told.forEach((tell) => tell());
    localStorage.setItem(KEY, JSON.stringify(this.chosen));
  }

  shape(change: Partial<Brush>): void {
    this.choose({ brush: { ...this.chosen.brush, ...change } });
  }

  /** A colour has been painted with. */
  used(rgb: Rgb): void {
    const isOther = (known: Rgb) => known.join() !== rgb.join();
    if (isOther(this.chosen.recent[0])) this.choose({ recent: [rgb, ...this.chosen.recent.filter(isOther)].slice(0, MOST_RECENT) });
  }
}

function remembered(): Chosen {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Chosen>;
    const tool = kept.tool === "eraser" ? "eraser" : "brush";
    return { ...DEFAULTS, ...kept, tool, usesTexture: false, brush: { ...DEFAULTS.brush, ...kept.brush } };
  } catch {
    return DEFAULTS;
  }
}
