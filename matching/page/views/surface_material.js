// How surfaces and lines between two positions are drawn.

import { DoubleSide, ShaderMaterial, Vector4 } from "three";

const moved = /* glsl */ `
attribute vec3 end;
uniform float t;
vec3 place() { return mix(position, end, t); }
`;

const surfaceVertex = /* glsl */ `
${moved}
attribute vec3 normalEnd, onGrid, color;
varying vec3 vNormal, vView, vGrid, vOrigin, vColor;
uniform vec3 patternLow;
uniform float patternScale;
void main() {
  vec4 view = modelViewMatrix * vec4(place(), 1.0);
  vNormal = normalMatrix * mix(normal, normalEnd, t);
  vView = view.xyz;
  vGrid = onGrid;
  vOrigin = (position - patternLow) * patternScale;
  vColor = color;
  gl_Position = projectionMatrix * view;
}`;

// Where the smooth normal is far from the facet's there is an edge, which stays sharp; fine meshes have no such places.
const surfaceFragment = /* glsl */ `
varying vec3 vNormal, vView, vGrid, vOrigin, vColor;
uniform float checker, opacity;
uniform vec4 cut;
void main() {
  if (dot(cut.xyz, vGrid) > cut.w) discard;
  vec3 facet = normalize(cross(dFdx(vView), dFdy(vView)));
  vec3 n = normalize(vNormal);
  if (dot(n, facet) < 0.0) n = -n;
  n = normalize(mix(facet, n, smoothstep(0.7, 0.92, dot(n, facet))));
  vec3 toEye = normalize(-vView);
  float key = max(dot(n, normalize(vec3(-0.45, 0.65, 0.75))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.8, -0.1, 0.5))), 0.0);
  vec3 color = vColor;
  vec3 square = mod(floor(vOrigin), 2.0);
  color *= 1.0 - 0.34 * checker * mod(square.x + square.y + square.z, 2.0);
  color *= 0.42 + 0.5 * key + 0.2 * fill;
  if (!gl_FrontFacing) color = mix(color, vec3(0.55), 0.75) * 0.8;
  float rim = 1.0 - abs(dot(n, toEye));
  gl_FragColor = vec4(color, opacity < 1.0 ? opacity + (1.0 - opacity) * 0.7 * rim * rim : 1.0);
}`;

const lineVertex = /* glsl */ `
${moved}
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(place(), 1.0); }`;

const lineFragment = /* glsl */ `
uniform vec3 color;
void main() { gl_FragColor = vec4(color, 1.0); }`;

/** A surface between its positions `position` and `end`, at t. The pattern of squares is of the former. */
export function surfaceMaterial(bounds) {
  return new ShaderMaterial({
    vertexShader: surfaceVertex,
    fragmentShader: surfaceFragment,
    extensions: { derivatives: true },
    side: DoubleSide,
    uniforms: {
      t: { value: 0 },
      checker: { value: 0 },
      opacity: { value: 1 },
      cut: { value: new Vector4(0, 0, 0, 1) },
      patternLow: { value: bounds.low },
      patternScale: { value: 14 / bounds.diagonal },
    },
  });
}

export function lineMaterial() {
  return new ShaderMaterial({ vertexShader: lineVertex, fragmentShader: lineFragment, uniforms: { t: { value: 0 }, color: { value: [0.5, 0.5, 0.5] } } });
}
