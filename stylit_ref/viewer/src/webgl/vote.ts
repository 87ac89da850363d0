// Passes 5 and 7: each pixel is the mean of what the patches around it have there, rounded half up.

export const vote = (radius: number): string => `
const int R = ${radius};
uniform usampler2DArray field;
uniform usampler2D style;
uniform int layer;
uniform ivec2 size;
layout(location = 0) out uvec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uvec3 sum = uvec3(0u);
  uint votes = 0u;
  for (int y = -R; y <= R; y++) for (int x = -R; x <= R; x++) {
    ivec2 q = p + ivec2(x, y);
    if (q != clamp(q, ivec2(0), size - 1)) continue;
    ivec2 source = ivec2(texelFetch(field, ivec3(q, layer), 0).yx) - ivec2(x, y);
    sum += texelFetch(style, source, 0).xyz;
    votes++;
  }
  colour = uvec4((2u * sum + votes) / (2u * votes), 255u);
}`;
