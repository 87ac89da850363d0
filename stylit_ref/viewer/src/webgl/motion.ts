// Pass 3: where the views around show the point that a pixel shows, and which of them hide it.

/** Motion is in units of 2^-bits pixels; the sky is paper, and does not move. */
export const MOTION = `
uniform usampler2D surface, beside;
uniform usampler2DArray labels;
uniform vec4 transfers[12];
uniform ivec4 slots;
uniform ivec2 size;
uniform int count, step, bits;
layout(location = 0) out ivec4 motion01;
layout(location = 1) out ivec4 motion23;
layout(location = 2) out uint hidden;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy), near = ivec2(texelFetch(beside, p, 0).xy);
  uvec2 seen = texelFetch(surface, near, 0).xy;
  float v = uintBitsToFloat(seen.y);
  // Of what lies beside it a pixel takes the motion, not the place.
  vec2 at = (vec2(near) + .5) * float(step) - .5, own = (vec2(p) + .5) * float(step) - .5;
  ivec2 offsets[4];
  hidden = 0u;
  for (int k = 0; k < 4; k++) {
    offsets[k] = ivec2(0);
    if (k >= count) continue;
    vec2 motion = vec2(0.);
    if (v > 0.) {
      vec4 pixel = vec4(at, 1., v);
      float depth = dot(transfers[3 * k + 2], pixel);
      motion = vec2(dot(transfers[3 * k], pixel), dot(transfers[3 * k + 1], pixel)) / depth - at;
      if (!(depth > 0.) || any(greaterThan(abs(motion), vec2(size)))) { hidden |= 1u << k; continue; }
    }
    ivec2 q = ivec2(floor(own + motion + .5));
    bool shown = q == clamp(q, ivec2(0), size - 1) && texelFetch(labels, ivec3(q, slots[k]), 0).x == seen.x;
    if (!shown) hidden |= 1u << k;
    offsets[k] = ivec2(clamp(floor(motion * float(1 << bits) + .5), -32767., 32767.));
  }
  motion01 = ivec4(offsets[0], offsets[1]);
  motion23 = ivec4(offsets[2], offsets[3]);
}`;
