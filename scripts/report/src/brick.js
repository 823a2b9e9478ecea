// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// How an element is painted: its colour, two lamps, and dark edges one pixel wide. Faces are flat, so light is found at their corners; edges are
// drawn with the faces, which takes half the time of lines on top of them.
import { ShaderMaterial } from "three";

const kVertex = `
attribute vec2 across;  // of a face: 0 in its middle, one of the two 1 or -1 on its edges
varying vec2 vAcross;
varying vec3 vColour;
void main() {
  // Only upright boxes have sizes, and their normals are axes: no inverse is needed.
  vec3 n = normalize(mat3(instanceMatrix) * normal);
  float light = 0.42 + 0.55 * max(0.0, dot(n, vec3(-0.218, -0.436, 0.873))) + 0.22 * max(0.0, dot(n, vec3(0.812, 0.487, 0.325)));
  vColour = light * instanceColor;
  vAcross = across;
  gl_Position = projectionMatrix * viewMatrix * instanceMatrix * vec4(position, 1.0);
}`;

const kFragment = `
varying vec2 vAcross;
varying vec3 vColour;
void main() {
  vec2 pixel = max(fwidth(vAcross), 1e-6);
  vec2 distance = (1.0 - abs(vAcross)) / pixel;             // to the edges, in pixels
  float edge = 1.0 - smoothstep(0.5, 1.5, min(distance.x, distance.y));
  edge *= 1.0 - smoothstep(0.6, 2.0, max(pixel.x, pixel.y));  // far away a face is no more than its edges: they fade
  gl_FragColor = vec4(mix(vColour, vec3(0.02), 0.9 * edge), 1.0);
  #include <colorspace_fragment>
}`;

export const brickMaterial = () => new ShaderMaterial({ vertexShader: kVertex, fragmentShader: kFragment });
