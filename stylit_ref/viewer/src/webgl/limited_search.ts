// Pass 6: of the patches that the views around show, the one most like the picture so far.

import { PLACES } from "./candidates.js";

/** The shifted one comes first, then the others, the closest view's first; only a better one wins. */
export const limitedSearch = (radius: number): string => `
const int R = ${radius}, WIDTH = 2 * R + 1;
${PLACES}
uniform usampler2DArray fields, field;
uniform usampler2D style, picture;
layout(location = 0) out uvec2 patchAt;
ivec3 own[WIDTH * WIDTH];
int difference(ivec2 source) {
  int sum = 0;
  for (int y = -R; y <= R; y++) for (int x = -R; x <= R; x++) {
    ivec3 e = ivec3(texelFetch(style, source + ivec2(x, y), 0).xyz) - own[(y + R) * WIDTH + x + R];
    sum += e.x * e.x + e.y * e.y + e.z * e.z;
  }
  return sum;
}
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  for (int y = -R; y <= R; y++) for (int x = -R; x <= R; x++)
    own[(y + R) * WIDTH + x + R] = ivec3(texelFetch(picture, clamp(p + ivec2(x, y), ivec2(0), size - 1), 0).xyz);
  patchAt = texelFetch(field, ivec3(p, 0), 0).xy;
  int best = difference(ivec2(patchAt.yx));
  for (int n = 0; n < count; n++) {
    ivec3 place;
    if (!shows(order[n], p, place)) continue;
    uvec2 candidate = texelFetch(fields, place, 0).xy;
    if (candidate == patchAt) continue;
    int found = difference(ivec2(candidate.yx));
    if (found < best) { best = found; patchAt = candidate; }
  }
}`;
