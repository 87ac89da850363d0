// Painting by keys alone: arrows move the brush, Space or Enter lowers and lifts it.

import type { Artist } from "./artist.js";
import { space } from "./hands.js";
import type { Notices } from "./notices.js";
import type { Painting } from "./painting.js";
import type { Picker } from "./picker.js";
import type { Settings } from "./settings.js";
import type { Tip } from "./tip.js";

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export class KeyboardHand {
  painting: Painting | null = null;
  private readonly artist: Artist;
  private readonly picker: Picker;
  private readonly settings: Settings;
  private readonly tip: Tip;
  private readonly notices: Notices;
  private place: [number, number] | null = null;
  private isDown = false;

  constructor(pane: HTMLElement, artist: Artist, picker: Picker, settings: Settings, tip: Tip, notices: Notices) {
    this.artist = artist;
    this.picker = picker;
    this.settings = settings;
    this.tip = tip;
    this.notices = notices;
    pane.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey) return;
      const arrow = ARROWS[event.key];
      if (arrow) this.move(arrow, event);
      else if (event.key === "Enter") this.press();
      else if (event.key === "Escape") this.lift();
      else return;
      event.preventDefault();
    });
    // Space moves the sheet if a pointer drags meanwhile; so it counts when it is let go.
    pane.addEventListener("keyup", (event) => event.key === " " && !space.hasMoved && this.press());
    pane.addEventListener("pointerdown", () => this.leave());
    pane.addEventListener("blur", () => this.leave());
  }

  private move([right, down]: [number, number], event: KeyboardEvent): void {
    if (!this.painting) return;
    const { width, height } = this.painting;
    const [x, y] = this.place ?? [width / 2, height / 2];
    const step = event.altKey ? 1 : Math.max(1, Math.round(this.settings.chosen.brush.size / 4)) * (event.shiftKey ? 8 : 1);
    const kept = (value: number, most: number) => Math.min(Math.max(value, 0), most - 1);
    this.place = [kept(x + right * step, width), kept(y + down * step, height)];
    this.tip.showAt(...this.place);
    if (this.isDown) this.artist.move([this.sample], event.timeStamp);
  }

  private press(): void {
    if (!this.painting) return;
    this.place ??= [this.painting.width / 2, this.painting.height / 2];
    this.tip.showAt(...this.place);
    if (this.settings.chosen.tool === "picker") {
      this.picker.pick(...this.place);
      this.picker.done();
    } else if (this.isDown) this.lift();
    else if (this.artist.mayPaint && this.settings.chosen.tool !== "hand") {
      this.isDown = true;
      this.artist.begin(this.sample);
      this.notices.say("The brush is down. Arrow keys draw; Space lifts it.");
    }
  }

  private lift(): void {
    if (!this.isDown) return;
    this.isDown = false;
    this.artist.end();
    this.notices.say("The brush is lifted.");
  }

  private leave(): void {
    this.lift();
    if (this.place) this.tip.hide();
    this.place = null;
  }

  private get sample() {
    const [x, y] = this.place as [number, number];
    return { x, y, pressure: 1, lean: 0, azimuth: 0 };
  }
}
