// Pass 2: the buffer `beside`, from the buffer `surface`.

import type { Stage } from "../engine.js";
import type { Buffers } from "./buffers.js";
import { program, type Context, type Target } from "./context.js";
import { BESIDE, RIMS, RIMS_IN_ROW } from "./silhouettes.js";

export class Beside {
  private readonly context: Context;
  private readonly buffers: Buffers;
  private readonly stage: Stage;
  private readonly targets: Record<"rims" | "rimsInRow" | "beside", Target>;
  private readonly rims = program(RIMS);
  private readonly rimsInRow = program(RIMS_IN_ROW);
  private readonly beside = program(BESIDE);

  constructor(context: Context, buffers: Buffers, stage: Stage) {
    this.context = context;
    this.buffers = buffers;
    this.stage = stage;
    const target = (name: "rims" | "rimsInRow" | "beside") =>
      context.target([buffers[name]], stage.width, stage.height);
    this.targets = { rims: target("rims"), rimsInRow: target("rimsInRow"), beside: target("beside") };
  }

  find(step: number): void {
    const { surface, rims, rimsInRow } = this.buffers;
    const size = [this.stage.width, this.stage.height].map((side) => Math.ceil(side / step));
    const reach = Math.max(1, Math.round(this.stage.reach / step));
    const into = (target: Target) => ({ ...target, width: size[0], height: size[1] });
    this.context.fill(this.rims, { surface, size }, into(this.targets.rims));
    this.context.fill(this.rimsInRow, { rims, size, reach }, into(this.targets.rimsInRow));
    this.context.fill(this.beside, { surface, rims, rimsInRow, size, reach }, into(this.targets.beside));
  }
}
