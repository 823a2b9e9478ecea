// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// How elements are painted: all in one draw, each where a texture says, with two lamps and dark edges one pixel wide. Not instances: where the
// processor draws (SwiftShader) the time of instances grew with their number and not with the size of the picture. Colours stay as the screen
// shows them (sRGB) from end to end: turning them from linear light at every pixel took a fifth of the time of a frame there.
import { DataTexture, DoubleSide, FloatType, RGBAFormat, ShaderMaterial } from "three";

const kRow = 512; // elements in a row of the texture
const kTexels = 3; // an element: position, quaternion (x, y, z, w), colour

/** Floats an element takes in `image.data` of the texture. */
export const kStride = 4 * kTexels;
/** Where in them its colour begins. */
export const kColour = 8;

/** Before all times. */
export const kBefore = -3e38;

const kVertex = `
uniform highp sampler2D state;
uniform float now;          // s; before all times: no face is red
uniform vec3 red;
uniform float picked;       // the element that lights up; -1: none
uniform vec3 light_up;
attribute float element;
attribute float opened;     // s, since when a joint on the face has been open
attribute vec2 across;  // of a face: 0 in its middle, one of the two 1 or -1 on its edges
varying vec2 vAcross;
flat varying vec3 vColour;
const float kSwell = 1.003;  // closes the seams between bricks, where the rounding of corners lets single pixels shine through
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
void main() {
  int e = int(element + 0.5);
  ivec2 at = ivec2(${kTexels} * (e % ${kRow}), e / ${kRow});
  vec4 q = texelFetch(state, at + ivec2(1, 0), 0);
  vec3 n = turned(q, normal);
  float light = 0.42 + 0.55 * max(0.0, dot(n, vec3(-0.218, -0.436, 0.873))) + 0.22 * max(0.0, dot(n, vec3(0.812, 0.487, 0.325)));
  vColour = opened <= now ? red : texelFetch(state, at + ivec2(2, 0), 0).rgb;
  if (element == picked) vColour = mix(vColour, light_up, 0.75);
  vColour *= 0.3653 + light * (0.8216 - 0.1859 * light);  // light to the power 1 / 2.2 within 0.004: pow itself took a fifth of the time of a frame
  vAcross = across;
  gl_Position = projectionMatrix * viewMatrix * vec4(texelFetch(state, at, 0).xyz + turned(q, kSwell * position), 1.0);
}`;

const kFragment = `
uniform float edges;  // how dark they are
varying vec2 vAcross;
flat varying vec3 vColour;
void main() {
  vec2 pixel = max(fwidth(vAcross), 1e-6);
  vec2 distance = (1.0 - abs(vAcross)) / pixel;  // to the edges, in pixels
  float edge = clamp(1.25 - 1.25 * min(distance.x, distance.y), 0.0, 1.0);
  edge *= clamp(1.4 - 0.7 * max(pixel.x, pixel.y), 0.0, 1.0);  // far away a face is no more than its edges: they fade
  gl_FragColor = vec4((1.0 - edges * edge) * vColour, 1.0);
}`;

/** Room for position, quaternion and colour of n elements and of the base, which is number n and stands still. */
export function stateTexture(n) {
  const rows = Math.ceil((n + 1) / kRow), data = new Float32Array(kStride * kRow * rows);
  data[kStride * n + 7] = 1;
  return new DataTexture(data, kTexels * kRow, rows, RGBAFormat, FloatType);
}

/** For the programs of vertices that draw what is fixed to elements: where the state of an element is, and where it takes a point. */
export const kPlaced = `
uniform highp sampler2D state;
ivec2 stateOf(float element) {
  int e = int(element + 0.5);
  return ivec2(${kTexels} * (e % ${kRow}), e / ${kRow});
}
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
vec3 placed(float element, vec3 v) {
  ivec2 at = stateOf(element);
  return texelFetch(state, at, 0).xyz + turned(texelFetch(state, at + ivec2(1, 0), 0), v);
}`;

/** @param red  of faces on which a joint has come open, while `uniforms.now` says so */
export function brickMaterial(state, red) {
  const uniforms = { state: { value: state }, now: { value: kBefore }, red: { value: red }, picked: { value: -1 }, light_up: { value: [0.16, 0.5, 0.95] }, edges: { value: 0.2 } };
  return new ShaderMaterial({ uniforms, vertexShader: kVertex, fragmentShader: kFragment });
}

const kShadow = `
attribute float element;
uniform float ground;
${kPlaced}
void main() {
  vec3 p = placed(element, position);
  p.xy += (p.z - ground) * vec2(0.25, 0.5);  // away from the lamp
  gl_Position = projectionMatrix * viewMatrix * vec4(p.xy, ground + 0.004, 1.0);
}`;
/** All elements, flat on the ground. */
export const shadowMaterial = (state, ground, colour) => new ShaderMaterial({
  uniforms: { state: { value: state }, ground: { value: ground }, colour: { value: colour } },
  vertexShader: kShadow, fragmentShader: "uniform vec3 colour; void main() { gl_FragColor = vec4(colour, 1.0); }", side: DoubleSide });
