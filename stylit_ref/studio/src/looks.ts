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
  private readonly caption: HTMLElement;

  constructor(side: "painting" | "picture", chosen: (look: Look) => void) {
    this.choice = byId(`${side}-look-choice`);
    this.canvas = byId(`${side}-look`);
    this.screen = new Screen(this.canvas);
    this.caption = byId(`${side}-looked`);
    byId(`${side}-look-away`).onclick = () => this.leave();
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
    if (!this.what) this.hide();
  }

  hide(): void {
    this.canvas.hidden = this.caption.hidden = true;
  }

  leave(): void {
    this.choice.value = "";
    this.hide();
  }

  draw({ width, height, rgb }: Frame): void {
    this.screen.show(width, height, rgb);
    (this.caption.firstElementChild as HTMLElement).textContent = this.choice.selectedOptions[0].text;
    this.canvas.hidden = this.caption.hidden = false;
  }
}

export class Looks {
  private readonly connection: Connection;
  private readonly looks: Look[];
  private readonly waiting = new Set<Look>();
  /** What the server has not answered yet; it is not asked again before. */
  private readonly asked = new Set<string>();

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
    this.asked.clear();
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
    this.asked.delete(frame.of);
    this.looksAt(frame.of)?.draw(frame);
    this.next();
  }

  /** There is no answer: to what was asked, or nobody knows to what. */
  fail(of?: string): void {
    if (of) {
      this.asked.delete(of);
      this.looksAt(of)?.hide();
    } else this.asked.clear();
    this.next();
  }

  /** A page that looks on cannot ask. */
  leave(): void {
    this.looks.forEach((look) => look.leave());
    this.waiting.clear();
    this.asked.clear();
  }

  private looksAt(what: string): Look | undefined {
    return this.looks.find((look) => look.what === what);
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
    for (const look of this.waiting) {
      const { what } = look;
      if (this.asked.has(what)) continue;
      if (!this.connection.ask({ do: "look", what })) return;
      this.waiting.delete(look);
      this.asked.add(what);
    }
  }
}
