// A texture made of an exemplar: patches are dragged onto it, and the brush can paint with it.

import type { Artist } from "./artist.js";
import { byId } from "./elements.js";
import type { Notices } from "./notices.js";
import { answerTo, sentenceOf } from "./refusals.js";
import type { Settings } from "./settings.js";
import { Spot } from "./spot.js";

export class Texture {
  private readonly artist: Artist;
  private readonly notices: Notices;
  private readonly exemplar: Spot;
  private readonly texture: Spot;
  /** Whether the patch is still held in what is asked next; null if nothing is. */
  private next: "held" | "dropped" | null = null;
  private isAsking = false;

  constructor(artist: Artist, settings: Settings, notices: Notices) {
    this.artist = artist;
    this.notices = notices;
    this.exemplar = new Spot(byId("exemplar"), byId("exemplar-spot"), () => undefined, () => this.texture.canvas.focus());
    this.texture = new Spot(byId("texture"), byId("texture-spot"), () => this.ask("held"), () => this.ask("dropped"));
    const { canvas } = this.exemplar;
    let isOver = false;
    canvas.onpointerdown = (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.exemplar.pointAt(event);
      isOver = false;
    };
    canvas.onpointermove = (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      const wasOver = isOver;
      isOver = this.texture.pointAt(event);
      if (isOver) this.ask("held");
      else if (wasOver) void this.reload();
    };
    canvas.onpointerup = () => isOver && this.ask("dropped");
    const paints = byId<HTMLInputElement>("paints-texture");
    paints.onchange = () => settings.choose({ usesTexture: paints.checked, tool: "brush" });
    settings.onChange(() => (paints.checked = settings.chosen.usesTexture));
  }

  async open(): Promise<void> {
    byId("texture-panel").hidden = false;
    await this.exemplar.show(await answerTo("/texture/exemplar"));
    await this.reload();
  }

  private ask(how: "held" | "dropped"): void {
    this.next = how;
    if (!this.isAsking) void this.drag();
  }

  private async drag(): Promise<void> {
    this.isAsking = true;
    try {
      while (this.next) {
        const keep = this.next === "dropped";
        this.next = null;
        const { exemplar, texture } = this;
        const body = JSON.stringify({ from: [exemplar.x, exemplar.y], to: [texture.x, texture.y], keep });
        const headers = { "Content-Type": "application/json" };
        await this.texture.show(await answerTo("/texture/drop", { method: "POST", headers, body }));
        if (keep) this.take();
      }
    } catch (error) {
      this.notices.problem(sentenceOf(error));
    } finally {
      this.isAsking = false;
    }
  }

  private async reload(): Promise<void> {
    try {
      await this.texture.show(await answerTo("/texture/picture"));
      this.take();
    } catch (error) {
      this.notices.problem(sentenceOf(error));
    }
  }

  /** The brush paints with what the texture is now. */
  private take(): void {
    const { canvas } = this.texture;
    const { width, height } = canvas;
    const image = canvas.getContext("2d", { alpha: false, willReadFrequently: true })?.getImageData(0, 0, width, height);
    if (!image) return;
    this.artist.texture = { width, height, pixels: new Uint32Array(image.data.buffer) };
    byId("texture-caption").textContent = "Texture";
    byId<HTMLInputElement>("paints-texture").disabled = false;
  }
}
