// Pass 8: frames of several closest views are mixed near a switch. Pass 9: the canvas.

/** Weights are whole; the mean is rounded half up. */
export const MIX_FRAMES = `
uniform usampler2D frame0, frame1, frame2, frame3;
uniform ivec4 weights;
layout(location = 0) out uvec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uvec4 w = uvec4(weights);
  uint whole = w.x + w.y + w.z + w.w;
  uvec3 sum = w.x * texelFetch(frame0, p, 0).xyz + w.y * texelFetch(frame1, p, 0).xyz
            + w.z * texelFetch(frame2, p, 0).xyz + w.w * texelFetch(frame3, p, 0).xyz;
  colour = uvec4((2u * sum + whole) / (2u * whole), 255u);
}`;

/** The canvas begins at the bottom. */
export const SHOW = `
uniform usampler2D picture;
uniform ivec2 size;
layout(location = 0) out vec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  colour = vec4(vec3(texelFetch(picture, ivec2(p.x, size.y - 1 - p.y), 0).xyz) / 255., 1.);
}`;
