// Looks at what goes in and what lies between, laid over the painting and over the picture.

import type { Connection } from "./connection.js";
import { byId, made } from "./elements.js";
import type { Frame, SceneSaid, Which } from "./protocol.js";
import { Screen } from "./screen.js";

/** Those that a new picture or stroke leaves as they are. */
const isStill = (what: string) => what.startsWith("A:") || what.startsWith("B:");

class Look {
  readonly choice: HTMLSelectElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly screen: Screen;

  constructor(side: "painting" | "picture", chosen: (look: Look) => void) {
    this.choice = byId(`${side}-look-choice`);
    this.canvas = byId(`${side}-look`);
    this.screen = new Screen(this.canvas);
    const strength = byId<HTMLInputElement>(`${side}-look-strength`);
    this.choice.onchange = () => chosen(this);
    strength.oninput = () => (this.canvas.style.opacity = String(strength.valueAsNumber / 100));
  }

  get what(): string {
    return this.choice.value;
  }

  offer(groups: Record<string, Record<string, string>>): void {
    const { what } = this;
    this.choice.replaceChildren(
      new Option("Nothing", ""),
      ...Object.entries(groups).map(([label, options]) =>
        made("optgroup", { label }, ...Object.entries(options).map(([value, text]) => new Option(text, value))),
      ),
    );
    this.choice.value = what;
    if (!this.choice.value) this.choice.value = "";
    this.canvas.hidden = !this.what;
  }

  hide(): void {
    this.canvas.hidden = true;
  }

  leave(): void {
    this.choice.value = "";
    this.hide();
  }

  draw({ width, height, rgb }: Frame): void {
    this.screen.show(width, height, rgb);
    this.canvas.hidden = false;
  }
}

export class Looks {
  private readonly connection: Connection;
  private readonly looks: Look[];
  private readonly waiting = new Set<Look>();
  /** The server answers one look at a time. */
  private asked: Look | null = null;

  constructor(connection: Connection) {
    this.connection = connection;
    this.looks = (["painting", "picture"] as const).map((side) => new Look(side, (look) => this.want(look)));
  }

  offer({ buffers }: SceneSaid, levels: number): void {
    const [painting, picture] = this.looks;
    const named = (side: string) => Object.fromEntries(buffers.map((name) => [`${side}:${name}`, name]));
    const texts = Array.from({ length: levels }, (_, level) => [`level:${level}`, `Level ${level}`]);
    painting.offer({
      "Guides of A": named("A"),
      "What is made of it": { usage: "Heat map of use", style: "A′ as it is used" },
    });
    picture.offer({
      "Guides of B": named("B"),
      "What lies between": { nnf: "Matches (NNF)", ...Object.fromEntries(texts) },
    });
    this.asked = null;
    this.waiting.clear();
    this.looks.forEach((look) => this.want(look));
  }

  /** A new picture has come; looks follow it. */
  follow(which: Which): void {
    if (which !== "replay") this.refresh((what) => !isStill(what));
  }

  /** The target has been turned. */
  turned(): void {
    this.refresh((what) => what.startsWith("B:"));
  }

  answer(frame: Frame): void {
    const look = this.asked;
    this.asked = null;
    if (look?.what) look.draw(frame);
    this.next();
  }

  /** There is no answer to what was asked. */
  fail(): void {
    this.asked?.hide();
    this.asked = null;
    this.next();
  }

  /** A page that looks on cannot ask. */
  leave(): void {
    this.looks.forEach((look) => look.leave());
    this.waiting.clear();
    this.asked = null;
  }

  private refresh(isMeant: (what: string) => boolean): void {
    this.looks.filter(({ what }) => what && isMeant(what)).forEach((look) => this.want(look));
  }

  private want(look: Look): void {
    if (!look.what) return look.hide();
    this.waiting.add(look);
    this.next();
  }

  private next(): void {
    if (this.asked) return;
    const [look] = this.waiting;
    if (!look || !this.connection.ask({ do: "look", what: look.what })) return;
    this.waiting.delete(look);
    this.asked = look;
  }
}
