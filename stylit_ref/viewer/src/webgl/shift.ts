// Pass 4: the closest view's patch at every pixel; and the same with pictures.

import { PLACES } from "./candidates.js";

export const SHIFT = `
${PLACES}
uniform usampler2DArray fields;
layout(location = 0) out uvec2 patchAt;
void main() { patchAt = texelFetch(fields, chosen(ivec2(gl_FragCoord.xy)), 0).xy; }`;

/** The mean of the pictures of all views that show the point; if they weigh nothing, the first one. */
export const MIX_SHIFTED = `
${PLACES}
uniform usampler2DArray pictures;
uniform ivec4 weights;
layout(location = 0) out uvec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uvec3 sum = uvec3(0u);
  uint whole = 0u;
  for (int k = 0; k < count; k++) {
    ivec3 place;
    uint weight = uint(weights[k]);
    if (weight == 0u || !shows(k, p, place)) continue;
    sum += weight * texelFetch(pictures, place, 0).xyz;
    whole += weight;
  }
  colour = whole == 0u ? texelFetch(pictures, chosen(p), 0) : uvec4((2u * sum + whole) / (2u * whole), 255u);
}`;

/** The mean of the views' pictures, where they are. */
export const MIX_VIEWS = `
uniform usampler2DArray pictures;
uniform ivec4 slots, weights;
uniform int count;
layout(location = 0) out uvec4 colour;
void main() {
  uvec3 sum = uvec3(0u);
  uint whole = 0u;
  for (int k = 0; k < count; k++) {
    sum += uint(weights[k]) * texelFetch(pictures, ivec3(gl_FragCoord.xy, slots[k]), 0).xyz;
    whole += uint(weights[k]);
  }
  colour = uvec4((2u * sum + whole) / (2u * whole), 255u);
}`;
