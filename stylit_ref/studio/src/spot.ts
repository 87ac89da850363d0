// A place on a small picture that is pointed at, or led by arrow keys.

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export class Spot {
  readonly canvas: HTMLCanvasElement;
  x = 0;
  y = 0;
  private readonly ring: HTMLElement;

  /** `moved` is called when it is led elsewhere, `pressed` by Enter or Space. */
  constructor(canvas: HTMLCanvasElement, ring: HTMLElement, moved: () => void, pressed: () => void) {
    this.canvas = canvas;
    this.ring = ring;
    canvas.addEventListener("keydown", (event) => {
      const arrow = ARROWS[event.key];
      if (arrow) {
        const step = event.shiftKey ? 8 : 1;
        this.put(this.x + arrow[0] * step, this.y + arrow[1] * step);
        moved();
      } else if (event.key === "Enter" || event.key === " ") pressed();
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  /** Whether a place of the window lies on it; if so, the spot goes there. */
  pointAt(event: PointerEvent): boolean {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const [x, y] = [(event.clientX - left) / width, (event.clientY - top) / height];
    if (x < 0 || y < 0 || x >= 1 || y >= 1) return false;
    this.put(Math.floor(x * this.canvas.width), Math.floor(y * this.canvas.height));
    return true;
  }

  put(x: number, y: number): void {
    const { width, height } = this.canvas;
    this.x = Math.min(Math.max(x, 0), width - 1);
    this.y = Math.min(Math.max(y, 0), height - 1);
    this.ring.style.left = `${(100 * (this.x + 0.5)) / width}%`;
    this.ring.style.top = `${(100 * (this.y + 0.5)) / height}%`;
  }

  async show(answer: Response): Promise<void> {
    const bitmap = await createImageBitmap(await answer.blob());
    const isNew = this.canvas.width !== bitmap.width || this.canvas.height !== bitmap.height;
    if (isNew) Object.assign(this.canvas, { width: bitmap.width, height: bitmap.height });
    this.canvas.getContext("2d", { alpha: false, willReadFrequently: true })?.drawImage(bitmap, 0, 0);
    if (isNew) this.put(Math.floor(bitmap.width / 2), Math.floor(bitmap.height / 2));
    bitmap.close();
  }
}
