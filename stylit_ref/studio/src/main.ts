// The page, and what it is made of.

import { Artist } from "./artist.js";
import { Connection } from "./connection.js";
import { easel } from "./easel.js";
import { byId } from "./elements.js";
import { Exporting } from "./exporting.js";
import { Guides } from "./guides.js";
import { Hands } from "./hands.js";
import { KeyboardHand } from "./keyboard_hand.js";
import { Latency } from "./latency.js";
import { Looks } from "./looks.js";
import { Notices } from "./notices.js";
import { Palette } from "./palette.js";
import { Parameters } from "./parameters.js";
import { Picker } from "./picker.js";
import { Progress } from "./progress.js";
import { Result } from "./result.js";
import { room } from "./room.js";
import { Scanning } from "./scanning.js";
import { Sender } from "./sender.js";
import { Session } from "./session.js";
import { Settings, type Tool } from "./settings.js";
import { shortcuts } from "./shortcuts.js";
import { Steps } from "./steps.js";
import { Texture } from "./texture.js";
import { Tip } from "./tip.js";
import { resized, toolbox } from "./toolbox.js";
import { Turning } from "./turning.js";
import { Viewport } from "./viewport.js";

declare global {
  interface Window {
    /** For whoever tests or measures the page. */
    stylitStudio?: { session: Session; artist: Artist; sender: Sender; latency: Latency; result: Result };
  }
}

function start(): void {
  const notices = new Notices();
  const settings = new Settings();
  const latency = new Latency();
  const connection = new Connection();
  const sender = new Sender(connection, latency);
  const artist = new Artist(settings, sender, () => {
    byId<HTMLButtonElement>("undo").disabled = !artist.mayPaint || !artist.history.canUndo;
    byId<HTMLButtonElement>("redo").disabled = !artist.mayPaint || !artist.history.canRedo;
  });

  const zoomed = (id: string) => (scale: number) => (byId(id).textContent = `${Math.round(100 * scale)}%`);
  const left = new Viewport(byId("easel"), byId("painting-sheet"), zoomed("painting-zoom"));
  const right = new Viewport(byId("target"), byId("picture-sheet"), zoomed("picture-zoom"));
  const picker = new Picker(settings, notices);
  const tip = new Tip(byId("tip"), left, settings);
  const keys = new KeyboardHand(left.pane, artist, picker, settings, tip, notices);
  const result = new Result(latency);
  const looks = new Looks(connection);
  const turning = new Turning(connection, right.pane, () => looks.turned());
  new Hands(left, easel(left, artist, picker, settings, tip));
  new Hands(right, turning.drag);

  const session = new Session({
    connection, sender, artist, result, looks, turning, notices,
    guides: new Guides(connection),
    steps: new Steps(connection),
    exporting: new Exporting(connection, byId("export")),
    progress: new Progress(),
    texture: new Texture(artist, settings, notices),
    parameters: new Parameters(connection, (name, value) => session.changed(name, value)),
    uses: (painting) => {
      picker.painting = keys.painting = painting;
      left.resize(painting.width, painting.height);
    },
    shows: ({ width, height }) => right.resize(width, height),
  });
  const finish = () => connection.ask({ do: "finish" });
  const fit = () => [left, right].forEach((viewport) => viewport.fit());
  const zoom = (factor: number) => () => [left, right].forEach((viewport) => viewport.zoom(factor));
  const undo = () => artist.undo();
  const redo = () => artist.redo();
  byId("finish").onclick = finish;
  byId("undo").onclick = undo;
  byId("redo").onclick = redo;
  byId("fit").onclick = fit;
  toolbox(settings);
  new Palette(settings);
  new Scanning();
  const { togglePanels, showHelp } = room();

  const take = (tool: Tool) => () => settings.choose({ tool });
  const resize = (by: 1 | -1) => () => settings.shape({ size: resized(settings.chosen.brush.size, by) });
  const opacities = Array.from({ length: 10 }, (_, k) => [`${(k + 1) % 10}`, () => settings.shape({ opacity: (k + 1) / 10 })]);
  shortcuts({
    b: take("brush"), e: take("eraser"), h: take("hand"), i: () => picker.toggle(),
    "[": resize(-1), "]": resize(1),
    z: undo, Z: redo, f: fit, F: finish, "+": zoom(1.25), "=": zoom(1.25), "-": zoom(0.8),
    p: togglePanels, "?": showHelp,
    ...(Object.fromEntries(opacities) as Record<string, () => void>),
  }, undo, redo);
  addEventListener("beforeunload", (event) => sender.isBehind && !connection.isOpen && event.preventDefault());
  window.stylitStudio = { session, artist, sender, latency, result };
  connection.begin(session);
}

document.addEventListener("DOMContentLoaded", start);
