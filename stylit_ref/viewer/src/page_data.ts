// What a page holds, as stylit_ref/viewer/contents.py writes it.

/** Bytes that lie in the page or in the folder beside it. */
export interface Piece {
  /** Where they lie: the id of an element, or the name of a script. */
  name: string;
  /** A lossless WebP of red, green, blue; or raw deflate. */
  coding: "webp" | "deflate";
  /** How many bytes there are when decoded, and their CRC-32. */
  bytes: number;
  sum: number;
}

/** A pinhole camera; angles in degrees. */
export interface Camera {
  origin: [number, number, number];
  target: [number, number, number];
  up: [number, number, number];
  /** Vertical. */
  fieldOfView: number;
  /** Of the lens to the right and upwards, in heights of the picture. */
  shift: [number, number];
  /** How wide a pixel is for its height. */
  pixelAspect: number;
  /** How far it stands from its column and its row of the grid, and from its target. */
  turn: number;
  rise: number;
  distance: number;
}

/** Where the rows or columns of a grid stand, ascending. */
export interface Axis {
  positions: number[];
  /** Steps where cameras do not turn around what they look at, or are unknown. */
  unit: "degrees" | "steps";
  /** Whether the first follows the last, 360 degrees after itself. */
  isRing: boolean;
}

export interface View {
  /** Null where nothing is known of it. */
  camera: Camera | null;
  /** A nearest-neighbour field; see fields.ts. */
  nnf: Piece | null;
  /** Red, green, blue; where there is no field. */
  picture: Piece | null;
  /** Where there is no mesh; see points.ts. */
  points: Piece | null;
}

export interface StyleData {
  width: number;
  height: number;
  /** Red, green, blue. */
  piece: Piece;
}

export interface MeshData {
  triangles: number;
  /** Nine float32 a triangle, then a uint32: the face that it belongs to. */
  piece: Piece;
}

export interface PageData {
  format: number;
  title: string;
  width: number;
  height: number;
  /** Of a grid of views, which stand row by row, from below and from the left. */
  rows: Axis;
  columns: Axis;
  patchRadius: number;
  /** How far strokes reach beyond a silhouette, in pixels. */
  reach: number;
  /** How wide a fade is, as a part of the way from view to view. */
  fadeBand: number;
  views: View[];
  style: StyleData | null;
  mesh: MeshData | null;
  /** The style at its own size, `scale` times that of `style`. */
  still: { scale: number; piece: Piece } | null;
  /** The folder of scripts that hold the pieces; null if they are in the page. */
  folder: string | null;
}

export const FORMAT = 1;

/** A sentence for whoever looks at the page. */
export class PageError extends Error {}

export function readPageData(): PageData {
  const text = document.getElementById("stylit-data")?.textContent;
  if (!text) throw new PageError("This page is incomplete: it holds no drawing. Ask for it again.");
  let data: PageData;
  try {
    data = JSON.parse(text) as PageData;
  } catch {
    throw new PageError("This page is damaged: its table of contents cannot be read. Ask for it again.");
  }
  if (data.format !== FORMAT)
    throw new PageError(`This page holds data of format ${data.format}, and its program reads ${FORMAT}.`);
  return data;
}
