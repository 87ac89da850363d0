// A painted sheet of paper: its photograph is sent, and its corners are dragged where they were not found.

import { byId } from "./elements.js";
import { Refusal, answerTo, sentenceOf } from "./refusals.js";

type Corner = [number, number];
interface Found {
  text: string;
  corners: Corner[] | null;
  width: number;
  height: number;
}

const NAMES = ["top left", "top right", "bottom right", "bottom left"];

export class Scanning {
  private readonly dialog = byId<HTMLDialogElement>("scan-dialog");
  private readonly state = byId("scan-state");
  private readonly photo = byId<HTMLCanvasElement>("photo");
  private readonly handles: HTMLButtonElement[];
  private readonly send = byId<HTMLButtonElement>("scan-send");
  private corners: Corner[] = [];
  private size: Corner = [1, 1];

  constructor() {
    const file = byId<HTMLInputElement>("scan-file");
    byId("scan-open").onclick = () => file.click();
    file.onchange = () => {
      const [chosen] = file.files ?? [];
      file.value = "";
      if (chosen) void this.read(chosen).catch((error: unknown) => this.tell(sentenceOf(error)));
    };
    this.handles = NAMES.map((name, k) => this.handle(name, k));
    byId("photo-frame").append(...this.handles);
    this.send.onclick = () => void this.sendCorners().catch((error: unknown) => this.tell(sentenceOf(error)));
  }

  private async read(file: File): Promise<void> {
    this.show(false);
    this.tell("The photograph is being read.");
    this.dialog.showModal();
    let bitmap: ImageBitmap;
    try {
      bitmap = await createImageBitmap(file);
    } catch {
      throw new Refusal(`${file.name} is no picture that this browser can read. Use PNG or JPEG.`);
    }
    const found = (await (await answerTo("/scan", { method: "POST", body: file })).json()) as Found;
    this.size = [found.width, found.height];
    Object.assign(this.photo, { width: bitmap.width, height: bitmap.height });
    this.photo.getContext("2d")?.drawImage(bitmap, 0, 0);
    bitmap.close();
    const [right, bottom] = [0.9 * found.width, 0.9 * found.height];
    const [left, top] = [0.1 * found.width, 0.1 * found.height];
    this.corners = found.corners ?? [[left, top], [right, top], [right, bottom], [left, bottom]];
    this.tell(found.text);
    this.show(true);
    this.draw();
  }

  private async sendCorners(): Promise<void> {
    const headers = { "Content-Type": "application/json" };
    const body = JSON.stringify({ corners: this.corners });
    const answer = (await (await answerTo("/scan/corners", { method: "POST", headers, body })).json()) as { text: string };
    this.tell(answer.text);
  }

  /** A corner to drag, or to move by arrow keys. */
  private handle(name: string, k: number): HTMLButtonElement {
    const handle = document.createElement("button");
    Object.assign(handle, { type: "button", className: "corner", ariaLabel: `Corner ${name}; arrow keys move it` });
    handle.onpointerdown = (event) => handle.setPointerCapture(event.pointerId);
    handle.onpointermove = (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      const { left, top, width, height } = this.photo.getBoundingClientRect();
      this.move(k, ((event.clientX - left) / width) * this.size[0], ((event.clientY - top) / height) * this.size[1]);
    };
    handle.onkeydown = (event) => {
      const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!arrow) return;
      event.preventDefault();
      const step = (this.size[0] / 1000) * (event.shiftKey ? 20 : 1);
      this.move(k, this.corners[k][0] + arrow[0] * step, this.corners[k][1] + arrow[1] * step);
    };
    return handle;
  }

  private move(k: number, x: number, y: number): void {
    const [width, height] = this.size;
    this.corners[k] = [Math.min(Math.max(x, 0), width), Math.min(Math.max(y, 0), height)];
    this.draw();
  }

  private draw(): void {
    const [width, height] = this.size;
    this.corners.forEach(([x, y], k) => {
      this.handles[k].style.left = `${(100 * x) / width}%`;
      this.handles[k].style.top = `${(100 * y) / height}%`;
    });
    const points = this.corners.map(([x, y]) => `${(100 * x) / width},${(100 * y) / height}`);
    byId("photo-outline").firstElementChild?.setAttribute("points", points.join(" "));
  }

  private show(isRead: boolean): void {
    byId("photo-frame").hidden = !isRead;
    this.send.hidden = !isRead;
  }

  private tell(text: string): void {
    this.state.textContent = text;
  }
}
