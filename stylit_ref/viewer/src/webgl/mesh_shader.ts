// Pass 1: the face that each pixel shows, and its inverse depth.
//
// Hardware moves corners to a grid of a sixteenth of a pixel or finer before it fills a triangle, and
// along every edge some pixels change sides. So triangles are drawn a little larger, and each fragment
// asks itself whether its centre lies inside. A corner is (x z, y z, z) here, in pixels from the middle,
// and an edge is the cross product of two of them (Olano and Greer 1997): this holds behind the camera too.

/** Texels of a triangle: three corners with its face, and its plane. */
export const TEXELS = 4;

export const MESH_VERTEX = `
uniform highp sampler2D triangles;
uniform vec4 lens[3];
uniform vec3 eye;
uniform mat3 ray;
uniform vec2 middle;
uniform ivec2 size;
uniform int step;
flat out vec3 edges[3];
flat out vec3 inverseDepth;
flat out uint label;
vec4 texel(int n) { int width = textureSize(triangles, 0).x; return texelFetch(triangles, ivec2(n % width, n / width), 0); }
void main() {
  int first = gl_VertexID / 3 * ${TEXELS};
  vec3 corners[3];
  for (int k = 0; k < 3; k++) {
    vec4 point = vec4(texel(first + k).xyz, 1.);
    float z = dot(lens[2], point);
    corners[k] = vec3(dot(lens[0], point) - middle.x * z, dot(lens[1], point) - middle.y * z, z);
  }
  for (int k = 0; k < 3; k++) edges[k] = cross(corners[(k + 1) % 3], corners[(k + 2) % 3] - corners[(k + 1) % 3]);
  float turn = dot(corners[0], edges[0]) < 0. ? -1. : 1.;
  for (int k = 0; k < 3; k++) edges[k] *= turn;
  vec4 plane = texel(first + 3);
  inverseDepth = plane.xyz * ray / -(dot(plane.xyz, eye) + plane.w);
  label = uint(texel(first).w);
  vec3 larger[2];
  for (int k = 0; k < 2; k++) {
    vec3 edge = edges[(gl_VertexID + k + 1) % 3];
    larger[k] = edge + vec3(0., 0., float(step) * (abs(edge.x) + abs(edge.y)));
  }
  vec3 corner = turn * cross(larger[0], larger[1]);
  corner.xy += middle * corner.z;
  vec2 clip = (2. * corner.xy + corner.z) / float(step) / vec2(size) - corner.z;
  gl_Position = vec4(clip, 0., corner.z);
}`;

export const SURFACE = `
flat in vec3 edges[3];
flat in vec3 inverseDepth;
flat in uint label;
uniform vec2 middle;
uniform float near;
uniform int step;
layout(location = 0) out uvec2 surface;  // face, bits of the inverse depth
void main() {
  vec2 at = gl_FragCoord.xy * float(step) - .5;
  vec3 centred = vec3(at - middle, 1.);
  for (int k = 0; k < 3; k++) if (!(dot(edges[k], centred) >= 0.)) discard;
  float inverse = dot(inverseDepth, vec3(at, 1.));
  if (!(inverse > 0. && inverse * near < 1.)) discard;
  surface = uvec2(label, floatBitsToUint(inverse));
  gl_FragDepth = inverse * near;
}`;
