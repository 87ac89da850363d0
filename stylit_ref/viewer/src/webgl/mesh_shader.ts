// Pass 1: the face that each pixel shows, and how deep it lies.

export const MESH_ATTRIBUTES = ["corner", "plane"];

/** The inverse depth of a plane is linear in x and y; it is the same at all corners of a triangle. */
export const MESH_VERTEX = `
in vec4 corner;  // x, y, z, face
in vec4 plane;
uniform mat4 clip;
uniform vec3 eye;
uniform mat3 ray;
flat out vec3 inverseDepth;
flat out uint label;
void main() {
  inverseDepth = plane.xyz * ray / -(dot(plane.xyz, eye) + plane.w);
  label = uint(corner.w);
  gl_Position = clip * vec4(corner.xyz, 1.);
}`;

/** It is met exactly: what is interpolated from corners is off by more on large triangles. */
export const SURFACE = `
flat in vec3 inverseDepth;
flat in uint label;
uniform int step;
layout(location = 0) out uvec2 surface;  // face, bits of the inverse depth
void main() {
  vec2 at = gl_FragCoord.xy * float(step) - .5;
  surface = uvec2(label, floatBitsToUint(dot(inverseDepth, vec3(at, 1.))));
}`;
