// What the address asks for: viewer.html?view=2.5,-1.25&mode=nnf&motion=half&engine=script

import { type Place } from "./grid.js";
import { MODES, STEPS, type Mode, type Motion } from "./modes.js";

const ENGINES = ["webgl", "script"] as const;

export interface Parameters {
  view: Place | null;
  mode: Mode | null;
  motion: Motion;
  engine: (typeof ENGINES)[number] | null;
  /** A sentence for each value that means nothing. */
  strange: string[];
}

export function readParameters(search: string): Parameters {
  const given = new URLSearchParams(search);
  const strange: string[] = [];
  const oneOf = <T extends string>(key: string, names: readonly T[]): T | null => {
    const value = given.get(key);
    const found = names.find((name) => name === value) ?? null;
    if (value !== null && found === null)
      strange.push(`The address asks for ${key}=${value}; choose one of ${names.join(", ")}.`);
    return found;
  };
  const place = (): Place | null => {
    const text = given.get("view");
    if (text === null) return null;
    const numbers = text.split(",").map((word) => (word.trim() ? Number(word) : NaN));
    if (numbers.length === 2 && numbers.every(Number.isFinite)) return numbers as Place;
    strange.push(`The address asks for view=${text}; a place is two numbers, such as 2.5,-1.25.`);
    return null;
  };
  return {
    view: place(),
    mode: oneOf("mode", Object.keys(MODES) as Mode[]),
    motion: oneOf("motion", Object.keys(STEPS) as Motion[]) ?? "full",
    engine: oneOf("engine", ENGINES),
    strange,
  };
}
