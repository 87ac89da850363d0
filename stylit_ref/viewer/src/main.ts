// The page.

import { control } from "./controls.js";
import { decode } from "./decode.js";
import { SLOTS, type Stage } from "./engine.js";
import { Engines } from "./engines.js";
import { Grid, type Place } from "./grid.js";
import { meshOf } from "./mesh.js";
import { needsFields, needsModel, type Mode } from "./modes.js";
import { PageError, readPageData, type PageData } from "./page_data.js";
import { Panel } from "./panel.js";
import { readParameters } from "./parameters.js";
import { toRgba } from "./pixels.js";
import { sourceOf, type Source } from "./source.js";
import { mixed, replay } from "./still.js";
import { Store } from "./store.js";
import { Viewer } from "./viewer.js";

declare global {
  interface Window {
    /** For whoever embeds or tests the page. */
    stylitViewer?: { viewer: Viewer; store: Store; engines: Engines };
  }
}

const MIDDLE: Place = [0, 0];

async function start(panel: Panel): Promise<void> {
  const data = readPageData();
  const parameters = readParameters(location.search);
  const { width, height, style } = data;
  const longest = Math.max(width, height, style?.width ?? 0, style?.height ?? 0);
  const engines = new Engines(panel.canvas, width, height, longest, parameters.engine);
  const source = sourceOf(data);
  const grid = new Grid(data);
  const [hasFields, hasModel] = [style !== null, (data.mesh !== null || hasPoints(data)) && grid.hasCameras];
  const isPossible = (mode: Mode) => (hasFields || !needsFields(mode)) && (hasModel || !needsModel(mode));
  const best = (["fade", "image", "linear"] as const).find(isPossible) as Mode;
  const mode = parameters.mode && isPossible(parameters.mode) ? parameters.mode : best;
  if (parameters.mode && mode !== parameters.mode)
    parameters.strange.push(`The address asks for mode=${parameters.mode}, and this page has no data for it.`);
  panel.tellRemark(parameters.strange.join(" "));

  const store = new Store(data, source);
  const fail = (error: unknown) => panel.say(sentence(error));
  const warn = (error: unknown) => panel.tellWaiting(sentence(error));
  const viewer = new Viewer(data, grid, store, parameters.view ?? MIDDLE, mode, parameters.motion, {
    rests: (place) => panel.tellView(placeText(place, data)),
    rate: (framesPerSecond) => panel.tellRate(framesPerSecond),
    waits: (waiting) => panel.tellWaiting(waiting ? "Limited search waits until the drawing rests." : ""),
    lacks: warn,
    fails: fail,
  });
  let whole: Stage | null = null;
  engines.onRestored(() => viewer.use(null), () => whole && viewer.use(engines.make(whole)));
  const [stage] = await Promise.all([readStage(data, source), store.arrived(viewer.needed)]);

  panel.offer(hasFields, hasModel, mode, parameters.motion, {
    mode: (chosen) => viewer.choose(chosen, viewer.motion),
    motion: (chosen) => viewer.choose(viewer.mode, chosen),
    save: () => void save(panel, viewer, data, stage, source).catch(warn),
  });
  control(panel.canvas, grid, { by: (right, up) => viewer.turn(right, up), home: () => viewer.go(MIDDLE) });
  panel.say("");
  whole = stage;
  viewer.use(engines.make(stage));
  window.stylitViewer = { viewer, store, engines };
}

const hasPoints = (data: PageData): boolean => data.views.every((view) => view.points !== null);

async function readStage(data: PageData, source: Source): Promise<Stage> {
  const { width, height, patchRadius, reach, style, mesh } = data;
  const bytes = (piece: { piece: Parameters<typeof decode>[0] } | null) => piece && decode(piece.piece, source);
  const [colours, triangles] = await Promise.all([bytes(style), bytes(mesh)]);
  return {
    width,
    height,
    patchRadius,
    reach,
    style: style && colours && { width: style.width, height: style.height, rgba: toRgba(colours) },
    mesh: mesh && triangles && meshOf(mesh, triangles),
    hasPoints: hasPoints(data),
    slots: Math.min(SLOTS, data.views.length),
  };
}

/** Save what is shown; where there is a field, with the style at its own size. */
async function save(panel: Panel, viewer: Viewer, data: PageData, stage: Stage, source: Source): Promise<void> {
  let canvas = panel.canvas;
  if (data.still && data.style && needsFields(viewer.mode)) {
    const { scale, piece } = data.still;
    const fields = viewer.fields();
    const style = { scale, width: scale * data.style.width, rgba: toRgba(await decode(piece, source)) };
    const image = mixed(
      fields.map((field) => replay(field.pixels, stage.width, stage.height, stage.patchRadius, style)),
      fields.map((field) => field.weight),
    );
    canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    canvas.getContext("2d")?.putImageData(image, 0, 0);
  } else viewer.drawNow();
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve));
  if (!blob) throw new PageError("The still is too large for this browser. Save it in another one.");
  panel.download(blob, "still.png");
}

function placeText([right, up]: Place, { columns }: PageData): string {
  const told = (value: number, way: string, back: string) =>
    `${Math.abs(value).toFixed(2)} ${columns.unit} ${value < 0 ? back : way}`;
  return `${told(right, "to the right", "to the left")} and ${told(up, "up", "down")}`;
}

function sentence(error: unknown): string {
  if (error instanceof PageError) return error.message;
  console.error(error);
  return `The drawing cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
}

document.addEventListener("DOMContentLoaded", () => {
  const panel = new Panel();
  start(panel).catch((error: unknown) => panel.say(sentence(error)));
});
