// The controls below the drawing, and what is said about it.

import { MODES, STEPS, needsFields, needsModel, type Mode, type Motion } from "./modes.js";

export interface Chosen {
  mode(mode: Mode): void;
  motion(motion: Motion): void;
  save(): void;
}

const byId = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

export class Panel {
  readonly canvas = byId<HTMLCanvasElement>("drawing");
  private readonly message = byId("message");
  private readonly mode = byId<HTMLSelectElement>("mode");
  private readonly motion = byId<HTMLSelectElement>("motion");
  private readonly save = byId<HTMLButtonElement>("save");
  private readonly view = byId("view");
  private readonly rate = byId("rate");
  private readonly waiting = byId("waiting");
  private remark = "";

  /** A sentence in place of the drawing; an empty one shows it again. */
  say(sentence: string): void {
    this.message.textContent = sentence;
    this.message.hidden = !sentence;
    byId("viewer").hidden = !!sentence;
  }

  /** Offer the modes that the page has data for. */
  offer(hasFields: boolean, hasModel: boolean, mode: Mode, motion: Motion, chosen: Chosen): void {
    for (const [name, text] of Object.entries(MODES) as [Mode, string][]) {
      if ((needsFields(name) && !hasFields) || (needsModel(name) && !hasModel)) continue;
      this.mode.add(new Option(text, name, false, name === mode));
    }
    for (const name of Object.keys(STEPS)) this.motion.add(new Option(`${name} resolution`, name, false, name === motion));
    this.motion.disabled = !hasModel;
    this.mode.onchange = () => chosen.mode(this.mode.value as Mode);
    this.motion.onchange = () => chosen.motion(this.motion.value as Motion);
    this.save.onclick = () => chosen.save();
  }

  /** Where one is; screen readers hear it, so it is told when the drawing rests. */
  tellView(text: string): void {
    this.view.textContent = text;
    this.canvas.setAttribute("aria-label", `${document.title}, seen ${text}. Arrow keys turn it.`);
  }

  tellRate(framesPerSecond: number | null): void {
    const number = framesPerSecond === null ? "" : framesPerSecond.toFixed(framesPerSecond < 9.95 ? 1 : 0);
    this.rate.textContent = number && `${number} frames a second`;
  }

  tellWaiting(text: string): void {
    this.waiting.textContent = text || this.remark;
  }

  /** What is told as long as there is nothing else. */
  tellRemark(text: string): void {
    this.remark = text;
    this.tellWaiting("");
  }

  /** Give the still to the user as a file. */
  download(blob: Blob, name: string): void {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }
}
