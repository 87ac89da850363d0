// Turning the target: by a slider, by dragging the picture, by arrow keys on it.

import type { Connection } from "./connection.js";
import { byId } from "./elements.js";
import { oncePerFrame } from "./frames.js";
import type { Drag } from "./hands.js";

/** Pixels of a drag for a step. */
const STRIDE = 14;

export class Turning {
  private readonly connection: Connection;
  private readonly told: () => void;
  private readonly slider = byId<HTMLInputElement>("turn");
  private readonly follows = byId<HTMLInputElement>("turn-follows");
  private readonly askFrame: () => void;
  private steps = 1;
  private step = 0;
  private isForced = false;

  constructor(connection: Connection, pane: HTMLElement, told: () => void) {
    this.connection = connection;
    this.told = told;
    this.askFrame = oncePerFrame(() => this.send());
    this.slider.oninput = () => this.go(this.slider.valueAsNumber);
    byId("turn-now").onclick = () => {
      this.isForced = true;
      this.askFrame();
    };
    pane.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!by || !this.canTurn || event.ctrlKey || event.metaKey || event.altKey) return;
      this.go(this.step + by);
      event.preventDefault();
    });
  }

  get canTurn(): boolean {
    return this.steps > 1;
  }

  offer(steps: number, step: number): void {
    this.steps = steps;
    this.step = step;
    byId("turn-panel").hidden = !this.canTurn;
    this.slider.max = String(steps - 1);
    this.tell();
  }

  /** Dragging the picture sideways. */
  get drag(): Drag {
    let [from, begun] = [0, 0];
    return {
      begin: (event) => {
        [from, begun] = [event.clientX, this.step];
        return this.canTurn;
      },
      move: (event) => this.go(begun + Math.round((event.clientX - from) / STRIDE)),
      end: () => undefined,
      cancel: () => this.go(begun),
    };
  }

  /** The last step follows the first. */
  private go(step: number): void {
    const around = ((step % this.steps) + this.steps) % this.steps;
    if (around === this.step) return;
    this.step = around;
    this.tell();
    this.askFrame();
  }

  private tell(): void {
    this.slider.value = String(this.step);
    byId("turn-step").textContent = `${this.step + 1} of ${this.steps}`;
  }

  private send(): void {
    this.connection.ask({ do: "turn", step: this.step, restylize: this.follows.checked || this.isForced });
    this.isForced = false;
    this.told();
  }
}
