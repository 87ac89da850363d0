// The eyedropper.

import { hexOf, type Rgb } from "./colour.js";
import type { Notices } from "./notices.js";
import type { Painting } from "./painting.js";
import type { Settings, Tool } from "./settings.js";

export class Picker {
  painting: Painting | null = null;
  private readonly settings: Settings;
  private readonly notices: Notices;
  /** The tool that it was taken up from. */
  private before: Tool = "brush";

  constructor(settings: Settings, notices: Notices) {
    this.settings = settings;
    this.notices = notices;
    settings.onChange(() => {
      if (settings.chosen.tool === "brush" || settings.chosen.tool === "eraser") this.before = settings.chosen.tool;
    });
  }

  pick(x: number, y: number): void {
    const pixel = this.painting?.at(x, y) ?? null;
    if (pixel === null) return;
    const rgb: Rgb = [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255];
    this.settings.choose({ rgb, usesTexture: false });
  }

  /** A colour is picked: back to the brush, as whoever picks one wants to paint with it. */
  done(): void {
    this.notices.say(`Picked ${hexOf(this.settings.chosen.rgb)}.`);
    if (this.settings.chosen.tool === "picker") this.settings.choose({ tool: "brush" });
  }

  /** Take it up, or lay it down. */
  toggle(): void {
    const { tool } = this.settings.chosen;
    this.settings.choose({ tool: tool === "picker" ? this.before : "picker" });
  }
}
