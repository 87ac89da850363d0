// What the address asks for: viewer.html?view=2.5,-1.25&mode=nnf&motion=half&engine=script

import { type Place } from "./grid.js";
import { MODES, STEPS, type Mode, type Motion } from "./modes.js";

export interface Parameters {
  view: Place | null;
  mode: Mode | null;
  motion: Motion;
  engine: "webgl" | "script" | null;
}

export function readParameters(search: string): Parameters {
  const given = new URLSearchParams(search);
  const view = (given.get("view") ?? "").split(",").map(Number);
  const mode = given.get("mode") ?? "";
  const motion = given.get("motion") ?? "";
  const engine = given.get("engine");
  return {
    view: given.has("view") && view.length === 2 && view.every(Number.isFinite) ? (view as Place) : null,
    mode: isOneOf(mode, MODES) ? (mode as Mode) : null,
    motion: isOneOf(motion, STEPS) ? (motion as Motion) : "full",
    engine: engine === "webgl" || engine === "script" ? engine : null,
  };
}

const isOneOf = (name: string, table: object): boolean => Object.keys(table).includes(name);
