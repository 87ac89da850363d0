// Pass 2: strokes that leave a thing belong to it. A pixel beside something nearer takes its motion, as
// far as strokes reach. stylit_ref/views/passes/silhouettes.py has the rule.

const DEPTH = `
uniform usampler2D surface;
uniform ivec2 size;
float inverseAt(ivec2 p) { return uintBitsToFloat(texelFetch(surface, p, 0).y); }
bool isInside(ivec2 p) { return p == clamp(p, ivec2(0), size - 1); }
bool isNearer(float inverse, float other) { return inverse > 1.05 * other; }
`;

/** Pixels beside which depth steps back. */
export const RIMS = `
${DEPTH}
layout(location = 0) out uint rim;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  float near = inverseAt(p);
  rim = 0u;
  for (int turn = 0; turn < 4; turn++) {
    ivec2 d = turn % 2 == 0 ? ivec2(0, turn - 1) : ivec2(turn - 2, 0);
    ivec2 q = p + d;
    if (!isInside(q)) continue;
    float far = inverseAt(q);
    // Outside of the picture the plane goes on.
    float before = isInside(p - d) ? inverseAt(p - d) : 2. * near - far;
    float behind = isInside(q + d) ? inverseAt(q + d) : 2. * far - near;
    float slope = min(abs(before - near), abs(far - behind));
    if (isNearer(near, far) && near - far > 2. * slope) rim = 1u;
  }
}`;

/** Whether a rim is within reach in the row; the search over rows asks that first. */
export const RIMS_IN_ROW = `
uniform usampler2D rims;
uniform ivec2 size;
uniform int reach;
layout(location = 0) out uint rim;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  rim = 0u;
  for (int x = max(p.x - reach, 0); x <= min(p.x + reach, size.x - 1); x++)
    rim |= texelFetch(rims, ivec2(x, p.y), 0).x;
}`;

/** The closest rim that is nearer, and past it; of several as close the nearest, then the first. */
export const BESIDE = `
${DEPTH}
uniform usampler2D rims, rimsInRow;
uniform int reach;
layout(location = 0) out uvec2 beside;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy), found = p;
  float own = inverseAt(p), nearest = 1e30;
  int closest = reach * reach + 1;
  for (int y = max(p.y - reach, 0); y <= min(p.y + reach, size.y - 1); y++) {
    if (texelFetch(rimsInRow, ivec2(p.x, y), 0).x == 0u) continue;
    for (int x = max(p.x - reach, 0); x <= min(p.x + reach, size.x - 1); x++) {
      ivec2 q = ivec2(x, y), d = q - p;
      int away = d.x * d.x + d.y * d.y;
      if (away > closest || texelFetch(rims, q, 0).x == 0u) continue;
      float there = inverseAt(q);
      if ((away < closest || there > nearest) && isNearer(there, own)) {
        closest = away;
        nearest = there;
        found = q;
      }
    }
  }
  if (closest <= reach * reach) {
    ivec2 past = found + sign(found - p);
    if (isInside(past) && !isNearer(nearest, inverseAt(past))) found = past;
  }
  beside = uvec2(found);
}`;

/** The face that each pixel of a grid's view belongs to. */
export const LABELS = `
uniform usampler2D surface, beside;
layout(location = 0) out uint label;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  label = texelFetch(surface, ivec2(texelFetch(beside, p, 0).xy), 0).x;
}`;
