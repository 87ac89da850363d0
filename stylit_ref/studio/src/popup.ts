// What opens over the pictures, and goes when one presses beside it.

export class Popup {
  private readonly button: HTMLElement;
  private readonly panel: HTMLElement;
  private readonly open: (isOpen: boolean) => void;

  /** `open` shows or hides the panel. */
  constructor(button: HTMLElement, panel: HTMLElement, open: (isOpen: boolean) => void) {
    this.button = button;
    this.panel = panel;
    this.open = open;
    button.onclick = () => this.turn(!this.isOpen);
    addEventListener("pointerdown", ({ target }) => {
      if (this.isOpen && target instanceof Node && !panel.contains(target) && !button.contains(target)) this.turn(false);
    });
    addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !this.isOpen) return;
      const hadFocus = this.panel.contains(document.activeElement);
      this.turn(false);
      if (hadFocus) this.button.focus();
    });
  }

  private get isOpen(): boolean {
    return this.button.ariaExpanded === "true";
  }

  private turn(isOpen: boolean): void {
    this.button.ariaExpanded = String(isOpen);
    this.open(isOpen);
  }
}
