// The tools, and the shape of the brush.

import type { Brush } from "./brush.js";
import { byId } from "./elements.js";
import { GRAINS } from "./grains.js";
import { LARGEST, type Ground, type Settings, type Tool } from "./settings.js";

const PERCENT = ["opacity", "hardness", "smoothing"] as const;
/** Steps of the slider of sizes, which are finer for small ones. */
const SIZE_STEPS = 200;
const GROWTH = 1.15;

export function toolbox(settings: Settings): void {
  const tools = [...document.querySelectorAll<HTMLButtonElement>("[data-tool]")].filter((each) => each.matches("button"));
  for (const button of tools) button.onclick = () => settings.choose({ tool: button.dataset.tool as Tool });

  const size = byId<HTMLInputElement>("size");
  size.max = String(SIZE_STEPS);
  size.oninput = () => settings.shape({ size: rounded(LARGEST ** (size.valueAsNumber / SIZE_STEPS)) });
  for (const name of PERCENT) {
    const slider = byId<HTMLInputElement>(name);
    slider.oninput = () => settings.shape({ [name]: slider.valueAsNumber / 100 });
  }
  const grain = byId<HTMLSelectElement>("grain");
  for (const [name, text] of Object.entries(GRAINS)) grain.add(new Option(text, name));
  grain.onchange = () => settings.shape({ grain: grain.value as Brush["grain"] });
  const pressure = byId<HTMLSelectElement>("pressure");
  pressure.onchange = () => settings.shape({ pressure: pressure.value as Brush["pressure"] });
  const tilts = byId<HTMLInputElement>("tilts");
  tilts.onchange = () => settings.shape({ tilts: tilts.checked });
  const ground = byId<HTMLSelectElement>("erases-to");
  ground.onchange = () => settings.choose({ erasesTo: ground.value as Ground });

  settings.onChange(() => {
    const { tool, brush, erasesTo } = settings.chosen;
    for (const button of tools) button.setAttribute("aria-pressed", String(button.dataset.tool === tool));
    size.value = String((SIZE_STEPS * Math.log(brush.size)) / Math.log(LARGEST));
    size.ariaValueText = `${brush.size} pixels`;
    byId("size-shown").textContent = String(brush.size);
    for (const name of PERCENT) {
      byId<HTMLInputElement>(name).value = String(Math.round(100 * brush[name]));
      byId(`${name}-shown`).textContent = `${Math.round(100 * brush[name])}%`;
    }
    grain.value = brush.grain;
    pressure.value = brush.pressure;
    tilts.checked = brush.tilts;
    ground.value = erasesTo;
    byId("erases").hidden = tool !== "eraser";
  });
}

/** A size that is larger or smaller by a step, for keys. */
export function resized(size: number, by: 1 | -1): number {
  const next = rounded(by > 0 ? size * GROWTH : size / GROWTH);
  return Math.min(Math.max(next === size ? size + by : next, 1), LARGEST);
}

const rounded = (size: number) => (size < 10 ? Math.round(2 * size) / 2 : Math.round(size));
