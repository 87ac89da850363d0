// The guides: which layers they are of, what they show, and how much each of them weighs.

import type { Connection } from "./connection.js";
import { byId, made } from "./elements.js";
import { oncePerFrame } from "./frames.js";
import type { SceneSaid } from "./protocol.js";

const HEAVIEST = 8;

export class Guides {
  private readonly connection: Connection;
  private unsent: Record<string, number> = {};
  private picked = new Set<string>();
  private readonly askFrame: () => void;

  constructor(connection: Connection) {
    this.connection = connection;
    this.askFrame = oncePerFrame(() => {
      this.connection.ask({ do: "weights", values: this.unsent });
      this.unsent = {};
    });
  }

  offer(scene: SceneSaid, weights: Record<string, number>, picked: string[]): void {
    const names = [...new Set([...scene.layers, ...scene.buffers])];
    this.picked = new Set(picked.length ? picked : scene.buffers);
    byId("guides").replaceChildren(...names.map((name) => this.row(scene, name, weights[name] ?? 1)));
  }

  private row(scene: SceneSaid, name: string, weight: number): HTMLElement {
    const address = (side: string) => `/thumb/${[scene.name, side, name].map(encodeURIComponent).join("/")}`;
    const thumb = (side: string) => made("img", { src: address(side), alt: "", loading: "lazy", className: "thumb" });
    const shown = made("output", { textContent: String(weight) });
    const slider = made("input", { type: "range", min: "0", max: String(HEAVIEST), value: String(weight), ariaLabel: `Weight of ${name}` });
    slider.oninput = () => {
      shown.textContent = slider.value;
      this.unsent[name] = slider.valueAsNumber;
      this.askFrame();
    };
    const row = made("li", {}, thumb("A"), thumb("B"), this.named(scene, name, slider), slider, shown);
    return row;
  }

  /** The name; with a box where one can choose. */
  private named(scene: SceneSaid, name: string, slider: HTMLInputElement): HTMLElement {
    const text = made("span", { className: "name", textContent: name });
    if (!scene.layers.includes(name)) return text;
    const box = made("input", { type: "checkbox", checked: this.picked.has(name) });
    slider.disabled = !box.checked;
    box.onchange = () => {
      if (box.checked) this.picked.add(name);
      else if (this.picked.size > 1) this.picked.delete(name);
      else box.checked = true; // nothing is matched without any
      slider.disabled = !box.checked;
      this.connection.ask({ do: "layers", names: [...this.picked] });
    };
    return made("label", { className: "name" }, box, text);
  }
}
