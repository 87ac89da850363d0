// Sliders of the parameters that the server names.

import type { Connection } from "./connection.js";
import { byId, made } from "./elements.js";
import { oncePerFrame } from "./frames.js";
import type { Field, Value } from "./protocol.js";

/** Ranges of whole numbers up to this long have a slider. */
const LONGEST = 64;
/** With the letters of the thesis. */
const NAMES: Record<string, string> = {
  patch_width: "patch width w",
  spacing: "spacing r",
  levels: "levels L",
  mu: "style μ",
  depth: "depth D",
  uniformity: "uniformity λ",
};

export class Parameters {
  private readonly connection: Connection;
  private readonly changed: (name: string, value: Value) => void;
  private unsent: Record<string, Value> = {};
  private readonly askFrame: () => void;

  constructor(connection: Connection, changed: (name: string, value: Value) => void) {
    this.connection = connection;
    this.changed = changed;
    this.askFrame = oncePerFrame(() => {
      this.connection.ask({ do: "parameters", values: this.unsent });
      this.unsent = {};
    });
    for (const of of ["live", "dense"] as const) byId(`of-${of}`).onchange = () => this.meant(of);
  }

  offer(fields: Field[], values: Record<string, Value>): void {
    for (const of of ["live", "dense"] as const) {
      const rows = fields.filter((field) => field.of === of).map((field) => this.row(field, values[field.name]));
      byId(`${of}-fields`).replaceChildren(...rows);
    }
    byId("of").hidden = !fields.some((field) => field.of === "dense");
    this.meant(byId<HTMLInputElement>("of-dense").checked ? "dense" : "live");
  }

  /** Parameters of the other kind of method move nothing, so they are greyed. */
  private meant(of: "live" | "dense"): void {
    for (const each of ["live", "dense"]) byId<HTMLFieldSetElement>(`${each}-fields`).disabled = each !== of;
  }

  private row(field: Field, value: Value): HTMLElement {
    const textContent = NAMES[field.name] ?? field.name.replaceAll("_", " ");
    const name = made("span", { textContent, title: field.help });
    const set = (now: Value) => {
      this.unsent[field.name] = now;
      this.changed(field.name, now);
      this.askFrame();
    };
    if (field.kind === "several") return this.severalRow(field, name, value as number[], set);
    const control =
      field.kind === "flag" ? flag(value as boolean, set)
      : field.kind === "choice" ? choice(field.choices ?? [], String(value), set)
      : number(field, value as number | null, set);
    return made("label", { className: field.kind === "flag" ? "row flag" : "row" }, name, ...control);
  }

  /** A value for each level, the finest first; the last goes for all above. */
  private severalRow(field: Field, name: HTMLElement, begun: number[], set: (value: Value) => void): HTMLElement {
    const values = [...begun];
    const rows = made("div", { className: "levels" });
    const set_ = () => set([...values]);
    const button = (text: string, label: string, press: () => void) =>
      made("button", { type: "button", className: "small", textContent: text, ariaLabel: label, onclick: press });
    const fewer = button("−", `One level fewer for ${name.textContent}`, () => change(() => values.pop()));
    const more = button("+", `One level more for ${name.textContent}`, () => change(() => values.push(values.at(-1) as number)));
    const change = (step: () => unknown) => {
      step();
      draw();
      set_();
    };
    const draw = () => {
      fewer.disabled = values.length < 2;
      more.disabled = values.length > 11;
      rows.replaceChildren(
        ...values.map((value, level) => {
          const isLast = level === values.length - 1;
          const text = isLast && level ? `from ${level}` : isLast ? "all" : `level ${level}`;
          const control = number(field, value, (now) => {
            values[level] = now as number;
            set_();
          });
          return made("label", { className: "row" }, made("span", { textContent: text }), ...control);
        }),
      );
    };
    draw();
    const head = made("div", { className: "row" }, name, made("span", { className: "push" }), fewer, more);
    return made("div", { className: "several", role: "group", ariaLabel: name.textContent }, head, rows);
  }
}

function flag(value: boolean, set: (value: Value) => void): HTMLElement[] {
  const box = made("input", { type: "checkbox", checked: value });
  box.onchange = () => set(box.checked);
  return [box];
}

function choice(choices: string[], value: string, set: (value: Value) => void): HTMLElement[] {
  const select = made("select", {}, ...choices.map((each) => new Option(each, each, false, each === value)));
  select.onchange = () => set(select.value);
  return [select];
}

/** A slider with its number where the range is short, else a number to type. */
function number({ least, most, kind, optional, odd }: Field, value: number | null, set: (value: Value) => void): HTMLElement[] {
  const range = (most ?? Infinity) - (least ?? -Infinity);
  const step = kind === "number" ? String(range / 100) : odd ? "2" : "1";
  const limits = { step, min: String(least ?? ""), max: String(most ?? "") };
  if ((range > LONGEST && kind !== "number") || optional) {
    const box = made("input", { type: "number", ...limits, value: value === null ? "" : String(value) });
    if (optional) box.placeholder = "auto";
    box.onchange = () => {
      if (box.value === "" ? !optional : !box.checkValidity()) box.reportValidity();
      else set(box.value === "" ? null : box.valueAsNumber);
    };
    return [box];
  }
  const shown = made("output", { textContent: String(value) });
  const slider = made("input", { type: "range", ...limits, value: String(value) });
  slider.oninput = () => {
    shown.textContent = String(+slider.valueAsNumber.toFixed(2));
    set(slider.valueAsNumber);
  };
  return [slider, shown];
}
