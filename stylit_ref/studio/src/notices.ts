// What the page says: in passing, as a problem, or for as long as something lasts.

import { byId, made } from "./elements.js";

/** Something that lasts, and a way out of it. */
export interface Lasting {
  text: string;
  button?: { text: string; press: () => void };
}

/** Milliseconds to read a sentence in passing. */
const LONG_ENOUGH = 20_000;

export class Notices {
  private readonly said = byId("said");
  private readonly problems = byId("problems");
  private timer = 0;
  private readonly lasting = new Map<string, Lasting>();

  /** In the status line for a while, heard by screen readers when they are done. */
  say(text: string): void {
    this.said.textContent = text;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => (this.said.textContent = ""), LONG_ENOUGH);
  }

  /** Stays until it is put away, or the same is said again. */
  problem(text: string): void {
    const known = [...this.problems.children].find((shown) => shown.firstChild?.textContent === text);
    known?.remove();
    const away = made("button", { type: "button", className: "plain", textContent: "Close" });
    const shown = made("p", {}, made("span", { textContent: text }), away);
    away.onclick = () => shown.remove();
    this.problems.append(shown);
    while (this.problems.children.length > 3) this.problems.firstChild?.remove();
  }

  /** Show something for as long as it lasts; null when it is over. */
  while(name: string, lasting: Lasting | null): void {
    if (lasting) this.lasting.set(name, lasting);
    else this.lasting.delete(name);
    const banner = byId("banner");
    banner.hidden = !this.lasting.size;
    banner.replaceChildren(
      ...[...this.lasting.values()].map(({ text, button }) => {
        const shown = made("p", {}, made("span", { textContent: text }));
        if (button) shown.append(made("button", { type: "button", textContent: button.text, onclick: button.press }));
        return shown;
      }),
    );
  }
}
