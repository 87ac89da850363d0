// How a sheet lies in its pane: how large it is shown, and where.

const LARGEST = 32;
const SMALLEST = 0.05;
/** Pixels of the pane that stay free around a sheet that fits. */
const MARGIN = 14;
/** From here on pixels are shown as squares. */
const SQUARES = 3;

export class Viewport {
  readonly pane: HTMLElement;
  scale = 1;
  private readonly sheet: HTMLElement;
  private readonly told: (scale: number) => void;
  private left = 0;
  private top = 0;
  private width = 1;
  private height = 1;
  private isFitted = true;
  private isSized = false;

  constructor(pane: HTMLElement, sheet: HTMLElement, told: (scale: number) => void) {
    this.pane = pane;
    this.sheet = sheet;
    this.told = told;
    new ResizeObserver(() => (this.isFitted ? this.fit() : this.keepInside())).observe(pane);
    pane.addEventListener("wheel", (event) => {
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode ? 16 : 1);
      // A pinch on a pad comes as a wheel with Control, in small steps.
      this.zoom(Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0015)), event.clientX, event.clientY);
    }, { passive: false });
  }

  /** The sheet has so many pixels. */
  resize(width: number, height: number): void {
    if (this.isSized && width === this.width && height === this.height) return;
    this.isSized = true;
    [this.width, this.height] = [width, height];
    this.fit();
  }

  fit(): void {
    const { clientWidth, clientHeight } = this.pane;
    const fitting = Math.min((clientWidth - 2 * MARGIN) / this.width, (clientHeight - 2 * MARGIN) / this.height);
    // A pixel for a pixel, where only the margin is in the way.
    const isWhole = fitting < 1 && this.width <= clientWidth && this.height <= clientHeight;
    this.scale = isWhole ? 1 : Math.max(fitting, SMALLEST);
    this.left = Math.round((clientWidth - this.scale * this.width) / 2);
    this.top = Math.round((clientHeight - this.scale * this.height) / 2);
    this.isFitted = true;
    this.lay();
  }

  /** Larger by a factor, around a place of the window; else around the middle. */
  zoom(factor: number, clientX?: number, clientY?: number): void {
    const { left, top, width, height } = this.pane.getBoundingClientRect();
    const [x, y] = [(clientX ?? left + width / 2) - left, (clientY ?? top + height / 2) - top];
    const scale = Math.min(Math.max(this.scale * factor, SMALLEST), LARGEST);
    this.left = x - ((x - this.left) * scale) / this.scale;
    this.top = y - ((y - this.top) * scale) / this.scale;
    this.scale = scale;
    this.keepInside();
  }

  pan(right: number, down: number): void {
    this.left += right;
    this.top += down;
    this.keepInside();
  }

  /** The place of the sheet under a place of the window, in pixels of the sheet. */
  placeAt(clientX: number, clientY: number): [number, number] {
    const { left, top } = this.pane.getBoundingClientRect();
    return [(clientX - left - this.left) / this.scale, (clientY - top - this.top) / this.scale];
  }

  /** The place of the pane over a place of the sheet. */
  paneAt(x: number, y: number): [number, number] {
    return [this.left + x * this.scale, this.top + y * this.scale];
  }

  /** Some of the sheet can always be seen. */
  private keepInside(): void {
    const kept = (start: number, length: number, room: number) => {
      const least = Math.min(48, length, room);
      return Math.min(Math.max(start, least - length), room - least);
    };
    this.left = kept(this.left, this.scale * this.width, this.pane.clientWidth);
    this.top = kept(this.top, this.scale * this.height, this.pane.clientHeight);
    this.isFitted = false;
    this.lay();
  }

  private lay(): void {
    const { style } = this.sheet;
    style.width = `${this.width}px`;
    style.height = `${this.height}px`;
    style.setProperty("--scale", String(this.scale));
    style.transform = `translate(${this.left}px, ${this.top}px) scale(${this.scale})`;
    this.sheet.classList.toggle("squares", this.scale >= SQUARES);
    if (this.isSized) this.told(this.scale);
  }
}
