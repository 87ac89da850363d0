// What passes ask about the views around: where each shows the point of a pixel, if it does.

export const PLACES = `
uniform isampler2D motion01, motion23;
uniform usampler2D hidden;
uniform ivec2 size;
uniform ivec4 order, slots;
uniform int count, step, bits;
/** Whether view k shows the point of pixel p, and where; if it does not, where it would. */
bool shows(int k, ivec2 p, out ivec3 place) {
  ivec2 m = p / step;
  ivec4 two = k < 2 ? texelFetch(motion01, m, 0) : texelFetch(motion23, m, 0);
  ivec2 offset = (k & 1) == 0 ? two.xy : two.zw;
  ivec2 there = p + ((offset + ((1 << bits) >> 1)) >> bits);
  ivec2 q = clamp(there, ivec2(0), size - 1);
  place = ivec3(q, slots[k]);
  return q == there && (texelFetch(hidden, m, 0).x >> uint(k) & 1u) == 0u;
}
/** The place in the first view that shows the point of p; if none does, in the first of all. */
ivec3 chosen(ivec2 p) {
  ivec3 place;
  for (int n = 0; n < count; n++) if (shows(order[n], p, place)) return place;
  shows(order[0], p, place);
  return place;
}
`;
