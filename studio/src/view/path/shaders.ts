// Programs for the path. Vertices are in textures, so that one buffer serves lines of any width and any level
// of detail: part k is from vertex first + k * stride - 1 of a texture to the next one drawn.

const precisionHeader = `precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
`;

const header = `#version 300 es
${precisionHeader}`;

const segmentVertexShader = `
uniform sampler2D points;
uniform sampler2D colours;
uniform mat4 matrix;
uniform int first;
uniform int base;
uniform float small_mm;
uniform int stride;
uniform vec2 size_px;
uniform float width_px;
uniform vec4 paint;
uniform uint robot;
uniform bool rapids;
uniform bool clean;
uniform float nearer;
uniform float join_px;
flat out vec3 colour;
flat out uint id;
flat out int dash;
out float t_s;
out float side_px;
out float along_mm;

ivec2 place(int i) { return ivec2(i & 4095, i >> 12); }

// A step over several vertices is used if the path hardly turns, or not visibly; else a single part
// represents them.
int lastOf(int from, vec3 a) {
  if (stride == 1) return from + 1;
  vec3 b = texelFetch(points, place(from + stride), 0).xyz;
  vec3 middle = texelFetch(points, place(from + stride / 2), 0).xyz;
  float long_mm = distance(a, b);
  bool straight = distance(middle, 0.5 * (a + b)) < 0.2 * long_mm;
  return straight || long_mm < small_mm ? from + stride : from + 1;
}

void main() {
  int corner = gl_VertexID % CORNERS;
  int from = first - 1 + (gl_VertexID / CORNERS) * stride;
  vec4 a = texelFetch(points, place(from), 0);
  int to = lastOf(from, a.xyz);
  vec4 b = texelFetch(points, place(to), 0);
  vec4 look = texelFetch(colours, place(to), 0);
  bool rapid = look.a > 0.0;
  vec3 begin = a.xyz;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (rapid && !rapids) return;
  vec4 p = matrix * vec4(a.xyz, 1.0);
  vec4 q = matrix * vec4(b.xyz, 1.0);
  // The part behind the camera is cut off before lines get a width.
  vec2 depth = vec2(p.z + p.w, q.z + q.w);
  if (depth.x < 0.0 && depth.y < 0.0) return;
  float cut = depth.x / (depth.x - depth.y);
  if (depth.x < 0.0) { p = mix(p, q, cut); a = mix(a, b, cut); }
  if (depth.y < 0.0) { q = mix(p, q, cut); b = mix(a, b, cut); }
  vec2 way_px = (q.xy / q.w - p.xy / p.w) * 0.5 * size_px;
  dash = rapid && !clean ? (abs(way_px.x) > abs(way_px.y) ? 1 : 2) : 0;
  colour = mix(look.rgb, paint.rgb, paint.a);
  id = ((robot << 27) | uint(base + to)) + 1u;
  bool end = END;
  side_px = SIDE * (0.5 * width_px + 0.5);
  t_s = end ? b.w : a.w;
  along_mm = distance(begin, (end ? b : a).xyz);
  gl_Position = end ? q : p;
  float long_px = length(way_px);
  vec2 along = long_px > 0.0 ? way_px / long_px : vec2(1.0, 0.0);
  vec2 shift_px = SIDE * abs(side_px) * vec2(-along.y, along.x) + (end ? along : -along) * JOIN;
  gl_Position.xy += 2.0 * shift_px / size_px * gl_Position.w;
  gl_Position.z -= nearer * gl_Position.w;
}`;

const thinDefines = `#define CORNERS 2
#define END (corner == 1)
#define SIDE 0.0
#define JOIN 0.0`;

// Two triangles: corners 0 1 2 and 2 1 3 of a strip.
const wide = `#define CORNERS 6
#define END (corner == 2 || corner == 3 || corner == 5)
#define SIDE ((corner == 1 || corner == 4 || corner == 5) ? 1.0 : -1.0)
#define JOIN join_px`;

const coverageCode = `
flat in vec3 colour;
flat in uint id;
flat in int dash;
in float t_s;
in float side_px;
uniform float width_px;
uniform float opacity;
uniform float dash_px;

float covered() {
  float at_px = dash == 1 ? gl_FragCoord.x : gl_FragCoord.y;
  if (dash != 0 && mod(at_px, dash_px) > 0.6 * dash_px) discard;
  return clamp(0.5 * width_px + 0.5 - abs(side_px), 0.0, 1.0) * opacity;
}
`;

const storedFragmentShader = `
layout(location = 0) out vec4 seen;
layout(location = 1) out uvec2 known;
void main() {
  float share = covered();
  if (share < 0.05) discard;
  seen = vec4(colour, share);
  known = uvec2(id, floatBitsToUint(t_s));
}`;

const displayedFragmentShader = `
layout(location = 0) out vec4 seen;
void main() { seen = vec4(colour, covered()); }`;

// For an eye of a headset: the remaining path is dimmed at once, and dashes are placed along the path, so
// that both eyes see the same.
const eyeFragmentShader = `
flat in vec3 colour;
flat in int dash;
in float t_s;
in float side_px;
in float along_mm;
uniform float width_px;
uniform float dash_mm;
uniform float now_s;
uniform float dimmed;
uniform float lightened;
layout(location = 0) out vec4 seen;
void main() {
  if (dash != 0 && mod(along_mm, dash_mm) > 0.6 * dash_mm) discard;
  float share = clamp(0.5 * width_px + 0.5 - abs(side_px), 0.0, 1.0);
  if (share < 0.05) discard;
  seen = vec4(mix(colour, vec3(1.0), lightened), share * (t_s > now_s ? dimmed : 1.0));
}`;

const screenVertexShader = `
out vec2 at;
void main() {
  at = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * at - 1.0, 0.0, 1.0);
}`;

// Each pixel of the kept picture stores its time, so the remaining path is dimmed without a redraw.
const screenFragmentShader = `
in vec2 at;
uniform sampler2D kept;
uniform usampler2D known;
uniform sampler2D depth;
uniform float now_s[32];
uniform float dimmed;
uniform float lightened;
out vec4 seen;
void main() {
  uvec2 what = texture(known, at).rg;
  if (what.x == 0u) discard;
  float t_s = uintBitsToFloat(what.y);
  seen = texture(kept, at);
  seen.rgb = mix(seen.rgb, vec3(seen.a), lightened);
  seen *= t_s > now_s[int((what.x - 1u) >> 27)] ? dimmed : 1.0;
  gl_FragDepth = texture(depth, at).r;
}`;

export const storedThin = [header + thinDefines + segmentVertexShader, header + coverageCode + storedFragmentShader] as const;
export const storedWide = [header + wide + segmentVertexShader, header + coverageCode + storedFragmentShader] as const;
export const displayedWide = [header + wide + segmentVertexShader, header + coverageCode + displayedFragmentShader] as const;
/** For three.js, which adds the version itself. */
export const eyeShaders = [precisionHeader + wide + segmentVertexShader, precisionHeader + eyeFragmentShader] as const;
export const screen = [header + screenVertexShader, header + screenFragmentShader] as const;
