// The ways to make a picture between the views.

export const MODES = {
  linear: "Linear blending of the views",
  image: "Image shifting",
  blend: "Blend of the shifted images",
  nnf: "NNF shifting",
  limited: "NNF shifting, limited search",
  fade: "Limited search, cross-fade",
} as const;

export type Mode = keyof typeof MODES;

/** Those that need fields; the others take pictures, which fields give too. */
export const needsFields = (mode: Mode): boolean => mode === "nnf" || mode === "limited" || mode === "fade";

/** Those that need to know where points of the model are. */
export const needsModel = (mode: Mode): boolean => mode !== "linear";

/** Motion is found for every pixel, for every second or for every fourth. */
export const STEPS = { full: 1, half: 2, quarter: 4 } as const;

export type Motion = keyof typeof STEPS;
