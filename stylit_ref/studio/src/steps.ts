// Single operations of the method, one press each.

import type { Connection } from "./connection.js";
import { byId, made } from "./elements.js";
import type { Stepped } from "./protocol.js";

const OPERATIONS: Record<string, [string, string]> = {
  restart: ["Begin", "Begin again at the coarsest level"],
  pyramid: ["Pyramid", "Make the levels of A, A′ and B"],
  upsample: ["Upsample", "Bring the matches to the next finer level"],
  half: ["Half iteration", "Search for every second entry of the grid"],
  blend: ["Blend", "Average the patches into B′"],
  iteration: ["Iteration", "Both halves, and a blend"],
  level: ["Level", "All that is left of this level"],
};

export class Steps {
  private readonly buttons: Map<string, HTMLButtonElement>;

  constructor(connection: Connection) {
    this.buttons = new Map(
      Object.entries(OPERATIONS).map(([operation, [textContent, title]]) => [
        operation,
        made("button", { type: "button", textContent, title, onclick: () => connection.ask({ do: "step", operation }) }),
      ]),
    );
    byId("operations").replaceChildren(...this.buttons.values());
    this.leave();
  }

  /** Nothing is begun: the live picture has gone on. */
  leave(): void {
    this.allow(["restart"]);
    byId("stepped").textContent = "Go through the method step by step. Painting goes on live.";
  }

  tell({ level, iteration, done, possible }: Stepped): void {
    this.allow(possible);
    byId("stepped").textContent = done ? "The picture is done." : `Level ${level}, iteration ${iteration}.`;
  }

  private allow(possible: string[]): void {
    for (const [operation, button] of this.buttons) button.disabled = !possible.includes(operation);
  }
}
