// What the page does when the server speaks: who paints, which painting, which scene.

import type { Artist } from "./artist.js";
import type { Connection, Heard } from "./connection.js";
import { byId } from "./elements.js";
import type { Exporting } from "./exporting.js";
import type { Guides } from "./guides.js";
import type { Looks } from "./looks.js";
import type { Notices } from "./notices.js";
import { Painting } from "./painting.js";
import type { Parameters } from "./parameters.js";
import { fromRgb } from "./pixels.js";
import type { Progress } from "./progress.js";
import { VERSION, type Chosen, type Frame, type Role, type Said, type SceneSaid, type Value, type Welcome, type Which } from "./protocol.js";
import { namePage, sentenceOf } from "./refusals.js";
import type { Result } from "./result.js";
import type { Sender } from "./sender.js";
import type { Steps } from "./steps.js";
import type { Texture } from "./texture.js";
import type { Turning } from "./turning.js";

export interface Parts {
  connection: Connection;
  sender: Sender;
  artist: Artist;
  result: Result;
  looks: Looks;
  turning: Turning;
  notices: Notices;
  guides: Guides;
  steps: Steps;
  exporting: Exporting;
  progress: Progress;
  texture: Texture;
  parameters: Parameters;
  /** Another painting lies on the easel. */
  uses(painting: Painting): void;
  /** The target is another one. */
  shows(scene: SceneSaid): void;
}

/** Pictures that come when somebody paints or turns. */
const LIVE: Which[] = ["replay", "coherent", "warm"];

export class Session implements Heard {
  painting: Painting | null = null;
  role: Role | null = null;
  private readonly parts: Parts;
  private scenes: SceneSaid[] = [];
  private scene = "";
  /** The folder of the painting. */
  private folder = "";
  /** Which painting comes next, after a welcome. */
  private awaited: { serial: number; keepsOwn: boolean } | null = null;
  private wasLost = false;
  /** Whether a scene is. */
  private isOpening = false;

  constructor(parts: Parts) {
    this.parts = parts;
    const { connection } = parts;
    const chosen = byId<HTMLSelectElement>("scene");
    chosen.onchange = () => this.open(chosen.value);
    const seed = byId<HTMLInputElement>("seed");
    seed.onchange = () => (seed.checkValidity() ? connection.ask({ do: "seed", value: seed.valueAsNumber }) : seed.reportValidity());
    byId("seed-next").onclick = () => {
      const before = seed.checkValidity() ? seed.valueAsNumber : -1;
      seed.value = String((before + 1) % 2 ** 32);
      connection.ask({ do: "seed", value: seed.valueAsNumber });
    };
  }

  said(said: Said): void {
    const { notices, progress, steps, exporting } = this.parts;
    switch (said.say) {
      case "welcome": return this.welcome(said);
      case "scene": return this.choose(said);
      case "role": return this.take(said.role);
      case "working":
        progress.working(said);
        return said.state === "failed" ? notices.problem(said.text) : undefined;
      case "compiling": return progress.compiling(said.text, said.done, said.total);
      case "problem":
        this.parts.looks.fail(said.of);
        exporting.fail(said.text);
        return notices.problem(said.text);
      case "saved": return void (byId("saved").textContent = said.text);
      case "stepped": return steps.tell(said);
      case "exported": return exporting.tell(said);
      case "notes": return said.texts.length ? notices.say(said.texts.join(" ")) : undefined;
    }
  }

  frame(frame: Frame): void {
    const { result, looks, steps } = this.parts;
    if (frame.isPainting) return this.repaint(frame);
    if (frame.which === "look") return looks.answer(frame);
    if (LIVE.includes(frame.which)) steps.leave();
    result.show(frame);
    looks.follow(frame.which);
  }

  lost(): void {
    const { notices, sender, progress } = this.parts;
    sender.allow(false);
    this.letAsk(false);
    this.isOpening = false;
    this.awaited = null;
    this.letPaint();
    progress.forget();
    const isAgain = this.wasLost;
    this.wasLost = true;
    if (!this.painting) return notices.while("line", { text: "The studio does not answer. The page tries again." });
    const text = "The connection is lost. Go on painting: the page tries again, and sends what you paint meanwhile.";
    notices.while("line", { text });
    // It may have been started anew, and know this browser no longer.
    if (isAgain) void fetch("/", { method: "HEAD" }).then(({ status }) => status === 403 && this.tellStranger(), () => undefined);
  }

  /** Somebody has chosen a parameter on the page. */
  changed(name: string, value: Value): void {
    if (name !== "levels") return;
    this.parts.looks.offer(this.now, value as number);
  }

  private tellStranger(): void {
    const text = "The studio was started anew. Open the address that it printed; then take over here, and nothing that you painted is lost.";
    if (!this.parts.connection.isOpen) this.parts.notices.while("line", { text });
  }

  private welcome(welcome: Welcome): void {
    const { notices, sender, result, texture } = this.parts;
    const isFirst = this.role === null;
    if (welcome.version !== VERSION) return notices.while("line", { text: "The studio is of another version than this page. Reload the page." });
    notices.while("line", null);
    namePage(welcome.page);
    // The studio was started anew on another folder, whose painting this one must not replace.
    if (this.folder !== welcome.painting.name) this.painting = null;
    this.folder = welcome.painting.name;
    const own = this.painting;
    const isOther = !own || own.width !== welcome.painting.width || own.height !== welcome.painting.height;
    const isAhead = !isOther && (sender.isBehind || (this.role === "painter" && sender.serial > welcome.painting.serial));
    this.awaited = { serial: welcome.painting.serial, keepsOwn: isAhead };
    if (isAhead) sender.serial = Math.max(sender.serial, welcome.painting.serial);
    result.forget();
    this.scenes = welcome.scenes;
    const chosen = byId<HTMLSelectElement>("scene");
    chosen.replaceChildren(...this.scenes.map(({ name, title }) => new Option(title, name)));
    const name = welcome.painting.name.split(/[\\/]/).at(-1) as string;
    Object.assign(byId("name"), { textContent: name, title: welcome.painting.name });
    document.title = `${name} · Studio`;
    if (welcome.seed !== undefined) byId<HTMLInputElement>("seed").value = String(welcome.seed);
    this.choose(welcome);
    this.take(welcome.role);
    byId("paper-panel").hidden = !welcome.panels.includes("scan");
    byId("views-panel").hidden = !welcome.panels.includes("views");
    if (welcome.panels.includes("texture") && byId("texture-panel").hidden)
      texture.open().catch((error: unknown) => notices.problem(sentenceOf(error)));
    if (welcome.notes.length && (isFirst || this.wasLost)) notices.say(welcome.notes.join(" "));
    else if (this.wasLost) notices.say(isAhead ? "Connected again; what you painted meanwhile is sent." : "Connected again.");
    this.wasLost = false;
  }

  /** Another scene. It may have a painting of its own, so the brush waits until it is there. */
  private open(name: string): void {
    const { artist, sender, connection, notices } = this.parts;
    artist.end();
    sender.flush();
    if (!connection.ask({ do: "scene", name })) return;
    this.isOpening = true;
    this.letPaint();
    notices.say("The scene is being opened; the brush waits for it.");
  }

  private choose({ scene, step, parameters, weights, layers }: Chosen): void {
    const { turning, looks, guides, steps } = this.parts;
    this.isOpening = false;
    this.letPaint();
    this.scene = byId<HTMLSelectElement>("scene").value = scene;
    this.parts.parameters.offer(parameters.fields, parameters.values);
    this.parts.shows(this.now);
    turning.offer(this.now.steps, step);
    guides.offer(this.now, weights, layers ?? []);
    steps.leave();
    looks.offer(this.now, Number(parameters.values.levels ?? 0));
  }

  private get now(): SceneSaid {
    return this.scenes.find(({ name }) => name === this.scene) as SceneSaid;
  }

  private take(role: Role): void {
    const { notices, connection, sender, looks } = this.parts;
    const isReader = role === "reader";
    if (isReader) looks.leave();
    this.role = role;
    this.letPaint();
    sender.allow(false); // until the painting has come that a welcome tells of
    document.body.classList.toggle("reads", isReader);
    allow("fieldset.brushes", !isReader);
    this.letAsk(!isReader);
    const text = sender.isBehind
      ? "Another page has the brush. This one holds strokes that the studio does not have: take over to keep them."
      : "Another page has the brush; this one looks on.";
    const button = { text: "Take over", press: () => void connection.ask({ do: "take_over" }) };
    notices.while("role", isReader ? { text, button } : null);
  }

  /** Whether what only a painter may ask can be asked: nothing while the studio does not answer. */
  private letAsk(may: boolean): void {
    allow("fieldset.painters", may);
  }

  /** A painter may paint, but for the time until another painting is there. */
  private letPaint(): void {
    const { artist } = this.parts;
    artist.mayPaint = this.role === "painter" && !this.isOpening && !this.awaited;
    artist.tell();
  }

  private repaint(frame: Frame): void {
    const { artist, sender } = this.parts;
    const { awaited } = this;
    const isBeginning = frame.serial === 0;
    const isOther = this.painting?.width !== frame.width || this.painting.height !== frame.height;
    if (isOther) this.begin(frame);
    if (isBeginning) artist.beginning = inkOf(frame);
    if (awaited) {
      if (frame.serial !== awaited.serial) return; // it is what the painting began with
      this.awaited = null;
      if (awaited.keepsOwn) {
        if (this.role === "painter") sender.sendAll();
      } else this.adopt(frame);
    } else if (isOther) this.adopt(frame);
    else if (this.role === "painter" && !isBeginning) {
      artist.replace(frame.rgb);
      if (frame.serial < sender.serial) sender.sendAll();
      else sender.forget(frame.serial);
    } else if (!isBeginning && !sender.isBehind) this.adopt(frame);
    this.letPaint();
    sender.allow(this.role === "painter");
  }

  private begin(frame: Frame): void {
    const { artist, uses, sender } = this.parts;
    this.painting = new Painting(byId("painting"), frame.width, frame.height);
    artist.use(this.painting);
    sender.forget(frame.serial);
    uses(this.painting);
    byId("no-painting").hidden = true;
  }

  private adopt(frame: Frame): void {
    const { artist, sender } = this.parts;
    this.painting?.replace(frame.rgb);
    if (frame.serial !== sender.serial) artist.forget(); // undo would bring back what others painted over
    sender.forget(frame.serial);
  }
}

function allow(fieldsets: string, may: boolean): void {
  for (const set of document.querySelectorAll<HTMLFieldSetElement>(fieldsets)) set.disabled = !may;
}

function inkOf({ width, height, rgb }: Frame) {
  const pixels = new Uint32Array(width * height);
  fromRgb(rgb, pixels);
  return { width, height, pixels };
}
