// What the server is busy with.

import { byId } from "./elements.js";
import type { Working } from "./protocol.js";

export class Progress {
  private readonly busy = new Map<string, string>();

  /** Kernels are compiled, once for every installation. */
  compiling(text: string, done: number, total: number): void {
    const bar = byId<HTMLProgressElement>("compiled");
    bar.max = Math.max(total, 1);
    bar.value = done;
    byId("compiling-text").textContent = text;
    byId("compiling").hidden = done >= total;
  }

  working({ which, state, text }: Working): void {
    if (state === "started") this.busy.set(which, `${which} ${text || "is being made"}`);
    else this.busy.delete(which);
    byId("working").textContent = [...this.busy.values()].join(", ");
    byId("finish").classList.toggle("busy", this.busy.has("full"));
  }

  forget(): void {
    this.busy.clear();
    byId("working").textContent = "";
    byId("compiling").hidden = true;
  }
}
