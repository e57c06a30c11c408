// SPDX-License-Identifier: GPL-3.0-or-later
// The shaders: clay lit from the eye and from above, and markers of constant size on the screen.
import * as THREE from "three";
import { chartPalette } from "./colours";

const light = /* glsl */ `
  vec3 lit(vec3 colour, vec3 normal, vec3 toEye) {
    vec3 n = normalize(normal);
    if (!gl_FrontFacing) n = -n;
    float key = max(dot(n, normalize(vec3(-0.45, 0.75, 0.55))), 0.0);
    float fill = max(dot(n, normalize(vec3(0.7, -0.15, 0.6))), 0.0);
    float head = max(dot(n, toEye), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    vec3 half_ = normalize(normalize(vec3(-0.45, 0.75, 0.55)) + toEye);
    float gloss = pow(max(dot(n, half_), 0.0), 40.0);
    vec3 result = colour * (0.32 + 0.16 * sky + 0.4 * key + 0.12 * fill + 0.22 * head) + vec3(0.06 * gloss);
    if (!gl_FrontFacing) result *= vec3(0.62, 0.55, 0.55);
    return result;
  }`;

/** What one looks through has to stand out from the ground, and so have lines on it. */
const seeThrough = { tint: { value: 1 }, ink: { value: new THREE.Vector3() } };

export function setGround(isDark: boolean): void {
  seeThrough.tint.value = isDark ? 1 : 0.6;
  seeThrough.ink.value.setScalar(isDark ? 0.92 : 0.1);
}

/** The colour, of which `line` is covered by a line; of what is seen through, more towards the rim. It is not lit then, so that it does not
 * matter which face is drawn first; but with LIT_GHOST, where only the nearest face is drawn. */
const shade = /* glsl */ `
  uniform float opacity, tint;
  uniform vec3 ink;
  varying vec3 vNormal2, vPosition;
  ${light}
  vec4 shaded(vec3 colour, float line) {
    vec3 toEye = normalize(-vPosition);
    if (opacity >= 1.0) return vec4(lit(mix(colour, vec3(0.13, 0.12, 0.15), line), vNormal2, toEye), 1.0);
    float rim = 1.0 - abs(dot(normalize(vNormal2), toEye));
    #ifdef LIT_GHOST
      return vec4(lit(colour, vNormal2, toEye), opacity + 0.55 * rim * rim);
    #endif
    return vec4(mix(tint * colour, ink, line), max(opacity + 0.6 * rim * rim * rim, 0.8 * line));
  }`;

const place = /* glsl */ `
  varying vec3 vNormal2, vPosition;
  void placeVertex() {
    vNormal2 = normalMatrix * normal;
    vec4 p = modelViewMatrix * vec4(position, 1.0);
    vPosition = p.xyz;
    gl_Position = projectionMatrix * p;
  }`;

/** Behind the lines that lie on it. */
const behindLines = { side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 2 } as const;

export enum SurfaceColour {
  plain = 0,
  field = 1,
  charts = 2,
  deviation = 3,
}

export function surfaceMaterial(): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    defines: { PALETTE: chartPalette.length },
    uniforms: {
      palette: { value: chartPalette.map((c) => new THREE.Vector3(...c)) },
      mode: { value: SurfaceColour.plain },
      clay: { value: new THREE.Vector3(0.82, 0.79, 0.74) },
      isolines: { value: 0 },
      lowest: { value: 0 },
      highest: { value: 1 },
      opacity: { value: 1 },
      ...seeThrough,
      hovered: { value: -1 },
      selected: { value: -1 },
      accent: { value: new THREE.Vector3(0.37, 0.7, 1) },
    },
    vertexShader: /* glsl */ `
      attribute float field;
      attribute float chart;
      varying float vField;
      flat varying float vChart;
      ${place}
      void main() {
        vField = field;
        vChart = chart;
        placeVertex();
        if (chart < -1.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // drawn in pieces
      }`,
    fragmentShader: /* glsl */ `
      uniform int mode;
      uniform vec3 clay;
      uniform float isolines, lowest, highest, hovered, selected;
      uniform vec3 accent;
      uniform vec3 palette[PALETTE];
      varying float vField;
      flat varying float vChart;
      ${shade}
      vec3 fieldColour(float t) {
        vec3 a = vec3(0.184, 0.388, 0.710), b = vec3(0.498, 0.698, 0.867), c = vec3(0.937, 0.902, 0.824);
        vec3 d = vec3(0.933, 0.604, 0.420), e = vec3(0.722, 0.196, 0.184);
        float x = clamp(t, 0.0, 1.0) * 4.0;
        return x < 1.0 ? mix(a, b, x) : x < 2.0 ? mix(b, c, x - 1.0) : x < 3.0 ? mix(c, d, x - 2.0) : mix(d, e, x - 3.0);
      }
      vec3 deviationColour(float t) {
        vec3 a = vec3(0.914, 0.906, 0.878), b = vec3(0.969, 0.812, 0.478), c = vec3(0.933, 0.580, 0.251);
        vec3 d = vec3(0.741, 0.290, 0.165), e = vec3(0.357, 0.102, 0.243);
        float x = clamp(t, 0.0, 1.0) * 4.0;
        return x < 1.0 ? mix(a, b, x) : x < 2.0 ? mix(b, c, x - 1.0) : x < 3.0 ? mix(c, d, x - 2.0) : mix(d, e, x - 3.0);
      }
      void main() {
        float t = (vField - lowest) / max(highest - lowest, 1e-12);
        vec3 colour = mode == 1 ? fieldColour(t) : mode == 2 ? (vChart < 0.0 ? vec3(0.6) : palette[int(mod(vChart + 0.5, float(PALETTE)))]) : mode == 3 ? deviationColour(t) : clay;
        float line = 0.0;
        if (isolines > 0.0) {
          float s = t * isolines;
          float width = fwidth(s);
          float distance_ = abs(fract(s - 0.5) - 0.5) / max(width, 1e-6);
          line = 0.62 * (1.0 - smoothstep(0.5, 1.5, distance_)) * (1.0 - smoothstep(0.25, 0.6, width));
        }
        if (selected >= 0.0 && abs(vChart - selected) < 0.5) colour = mix(colour, accent, 0.42);
        else if (hovered >= 0.0 && abs(vChart - hovered) < 0.5) colour = mix(colour, vec3(1.0), 0.28);
        gl_FragColor = shaded(colour, line);
      }`,
    ...behindLines,
  });
}

export function quadMaterial(): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    uniforms: { opacity: { value: 1 }, ...seeThrough },
    vertexShader: /* glsl */ `
      attribute vec3 colour;
      varying vec3 vColour;
      ${place}
      void main() {
        vColour = colour;
        placeVertex();
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 vColour;
      ${shade}
      void main() {
        gl_FragColor = shaded(vColour, 0.0);
      }`,
    ...behindLines,
  });
}

/** Shapes of markers: regular polygons with that number of corners, a disc, and special signs. */
export enum Shape {
  disc = 0,
  triangleUp = -1,
  triangleDown = -2,
  diamond = -3,
}

/** By which part of the eye's distance markers are nearer than what they mark. */
const markerDepth = { value: 0.008 };

export function setMarkerDepth(part: number): void {
  markerDepth.value = part;
}

export function markerMaterial(): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    uniforms: { nearer: markerDepth, size: { value: 14 }, ratio: { value: 1 }, border: { value: new THREE.Vector3(0.07, 0.08, 0.1) } },
    vertexShader: /* glsl */ `
      uniform float size, ratio, nearer;
      attribute vec3 colour;
      attribute float shape;
      attribute float scale;
      varying vec3 vColour;
      varying float vShape;
      void main() {
        vColour = colour;
        vShape = shape;
        vec4 p = modelViewMatrix * vec4(position, 1.0);
        p.xyz *= 1.0 - nearer; // before the surface that it lies on
        gl_Position = projectionMatrix * p;
        gl_PointSize = size * scale * ratio;
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 border;
      varying vec3 vColour;
      varying float vShape;
      float polygon(vec2 p, float corners, float turn) {
        float part = 6.2831853 / corners;
        float angle = atan(p.x, p.y) + turn;
        return cos(floor(0.5 + angle / part) * part - angle) * length(p);
      }
      void main() {
        vec2 p = 2.0 * vec2(gl_PointCoord.x, 1.0 - gl_PointCoord.y) - 1.0;
        float d = length(p);
        float inside = 0.9;
        if (vShape > 2.5) { d = polygon(p, vShape, 3.14159265 / vShape * (mod(vShape, 2.0) < 0.5 ? 1.0 : 1.0)); inside = 0.86 * cos(3.14159265 / vShape) + 0.06; }
        else if (vShape < -2.5) { d = abs(p.x) + abs(p.y); }
        else if (vShape < -1.5) { d = polygon(p - vec2(0.0, 0.2), 3.0, 0.0); inside = 0.5; }
        else if (vShape < -0.5) { d = polygon(p + vec2(0.0, 0.2), 3.0, 3.14159265); inside = 0.5; }
        float soft = fwidth(d);
        float alpha = 1.0 - smoothstep(inside - soft, inside, d);
        if (alpha < 0.02) discard;
        float rim = smoothstep(inside - 0.24 - soft, inside - 0.24 + soft, d);
        gl_FragColor = vec4(mix(vColour, border, 0.85 * rim), alpha);
      }`,
    transparent: true,
    depthWrite: false,
  });
}
