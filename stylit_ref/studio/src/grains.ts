// Textures of a brush: how high the ground stands under it. Paint reaches the peaks first.

export const GRAINS = {
  smooth: "Smooth",
  paper: "Paper",
  canvas: "Canvas",
  speckle: "Speckle",
  bristles: "Bristles",
} as const;
export type GrainName = keyof typeof GRAINS;

/** Pixels along a grain; it is repeated. */
export const GRAIN = 128;
/** Hairs of a bristle brush. */
export const HAIRS = 64;

/** Heights from 0 to 255: of places of the ground, or across a stroke. */
export interface Grain {
  follows: "ground" | "stroke";
  /** How quickly paint fills a valley once it has reached it. */
  fill: number;
  heights: Uint8Array;
}

const made = new Map<GrainName, Grain | null>();

/** Null for the smooth one. */
export function grainOf(name: GrainName): Grain | null {
  if (!made.has(name)) made.set(name, make(name));
  return made.get(name) as Grain | null;
}

function make(name: GrainName): Grain | null {
  if (name === "smooth") return null;
  if (name === "bristles") return { follows: "stroke", fill: 1.6, heights: levelled(hairs()) };
  const height = { paper: paperAt, canvas: weaveAt, speckle: speckleAt }[name];
  const heights = Float32Array.from({ length: GRAIN * GRAIN }, (_, k) => height(k % GRAIN, Math.floor(k / GRAIN)));
  return { follows: "ground", fill: 3, heights: levelled(heights) };
}

const paperAt = (x: number, y: number) => 0.5 * noise(x, y, 2, 1) + 0.35 * noise(x, y, 4, 2) + 0.15 * noise(x, y, 1, 3);
const speckleAt = (x: number, y: number) => noise(x, y, 1, 4) + 0.4 * noise(x, y, 8, 5);

function weaveAt(x: number, y: number): number {
  const thread = (2 * Math.PI) / 8;
  const [across, along] = [Math.sin(thread * x), Math.sin(thread * y)];
  return Math.max(across * Math.sign(along), along * Math.sign(-across)) + 0.5 * noise(x, y, 2, 6);
}

const hairs = () => Float32Array.from({ length: HAIRS }, (_, k) => noise(k, 0, 1, 7) + noise(k, 0, 4, 8));

/** Smooth noise whose cells are `size` pixels wide; it repeats with the grain. */
function noise(x: number, y: number, size: number, seed: number): number {
  const cells = GRAIN / size;
  const [left, top] = [Math.floor(x / size), Math.floor(y / size)];
  const [right, down] = [ease(x / size - left), ease(y / size - top)];
  const at = (column: number, row: number) => random((column % cells) + cells * (row % cells), seed);
  const upper = at(left, top) * (1 - right) + at(left + 1, top) * right;
  const lower = at(left, top + 1) * (1 - right) + at(left + 1, top + 1) * right;
  return upper * (1 - down) + lower * down;
}

const ease = (t: number) => t * t * (3 - 2 * t);

/** From 0 to 1, the same on every machine. */
function random(place: number, seed: number): number {
  let mixed = Math.imul(place + 1, 0x9e3779b1) ^ Math.imul(seed, 0x85ebca6b);
  mixed = Math.imul(mixed ^ (mixed >>> 15), 0x2c1b3c6d);
  mixed = Math.imul(mixed ^ (mixed >>> 12), 0x297a2d39);
  return ((mixed ^ (mixed >>> 15)) >>> 0) / 2 ** 32;
}

/** Ranks in place of values, so every grain takes up the same share of paint. */
function levelled(heights: Float32Array): Uint8Array {
  const order = [...heights.keys()].sort((a, b) => heights[a] - heights[b]);
  const ranks = new Uint8Array(heights.length);
  order.forEach((place, rank) => (ranks[place] = Math.floor((256 * rank) / heights.length)));
  return ranks;
}
