// Choosing a colour: by hue, saturation and value, by its number, or one that was used before.

import { colourOf, fromHex, hexOf, rgbOf, type Colour, type Rgb } from "./colour.js";
import { byId, made } from "./elements.js";
import { Popup } from "./popup.js";
import type { Settings } from "./settings.js";

const PARTS = { hue: 360, saturation: 100, value: 100 } as const;
type Part = keyof typeof PARTS;

export class Palette {
  private readonly settings: Settings;
  private readonly button = byId<HTMLButtonElement>("colour");
  private readonly number = byId<HTMLInputElement>("colour-number");
  private colour: Colour;

  constructor(settings: Settings) {
    this.settings = settings;
    this.colour = colourOf(settings.chosen.rgb);
    const panel = byId("palette");
    new Popup(this.button, panel, (isOpen) => (panel.hidden = !isOpen));
    for (const part of Object.keys(PARTS) as Part[]) {
      const slider = byId<HTMLInputElement>(part);
      slider.oninput = () => {
        this.colour = { ...this.colour, [part]: part === "hue" ? slider.valueAsNumber % 360 : slider.valueAsNumber / 100 };
        this.choose(rgbOf(this.colour));
      };
    }
    this.number.onchange = () => {
      const rgb = fromHex(this.number.value);
      if (rgb) this.choose(rgb);
      else this.number.value = hexOf(settings.chosen.rgb);
    };
    settings.onChange(() => this.show());
  }

  private choose(rgb: Rgb): void {
    this.settings.choose({ rgb, usesTexture: false });
  }

  private show(): void {
    const { rgb, recent } = this.settings.chosen;
    // Black and greys keep the hue that led to them.
    if (rgbOf(this.colour).join() !== rgb.join()) this.colour = colourOf(rgb, this.colour);
    const { hue, saturation, value } = this.colour;
    byId<HTMLInputElement>("hue").value = String(Math.round(hue));
    byId<HTMLInputElement>("saturation").value = String(Math.round(100 * saturation));
    byId<HTMLInputElement>("value").value = String(Math.round(100 * value));
    this.number.value = hexOf(rgb);
    const { style } = document.documentElement;
    style.setProperty("--colour", hexOf(rgb));
    style.setProperty("--full", hexOf(rgbOf({ hue, saturation: 1, value })));
    style.setProperty("--grey", hexOf(rgbOf({ hue, saturation: 0, value })));
    style.setProperty("--bright", hexOf(rgbOf({ hue, saturation, value: 1 })));
    this.button.ariaLabel = `Colour, ${hexOf(rgb)}`;
    byId("recent").replaceChildren(
      ...recent.map((each) => {
        const label = hexOf(each);
        const swatch = made("button", { type: "button", className: "swatch", title: label, ariaLabel: `Colour ${label}` });
        swatch.style.background = label;
        swatch.onclick = () => this.choose(each);
        return swatch;
      }),
    );
  }
}
