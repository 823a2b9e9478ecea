// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// What stands about the house: the ground with a grid of metres, a person of 1.70 m, distances from the walls, the space under the roof.
import { BufferGeometry, Float32BufferAttribute, Group, LatheGeometry, LineSegments, Mesh, RingGeometry, ShaderMaterial, Vector2 } from "three";

const plain = (colour, more = {}) => new ShaderMaterial({
  uniforms: { colour: { value: colour }, far: { value: colour }, strength: { value: 1 } },
  vertexShader: "varying vec2 vAt; void main() { vAt = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
  fragmentShader: "uniform vec3 colour; uniform float strength; void main() { gl_FragColor = vec4(colour, strength); }", ...more });

/** The ground: rings that fade into what is behind it. */
function ground(radius) {
  const material = new ShaderMaterial({
    uniforms: { colour: { value: [1, 1, 1] }, far: { value: [1, 1, 1] } },
    vertexShader: "uniform vec3 colour, far; varying vec3 vColour; void main() { vColour = mix(colour, far, smoothstep(0.25, 1.0, length(2.0 * uv - 1.0))); gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: "varying vec3 vColour; void main() { gl_FragColor = vec4(vColour, 1.0); }" });
  return new Mesh(new RingGeometry(0.001, radius, 32, 5), material);
}

function segments(points, colour, strength, more) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  const lines = new LineSegments(geometry, plain(colour, { transparent: strength < 1, depthWrite: false, ...more }));
  lines.material.uniforms.strength.value = strength;
  lines.frustumCulled = false;
  return lines;
}

function grid(half, z) {
  const points = [];
  for (let i = -half; i <= half; ++i) points.push(-half, i, z, half, i, z, i, -half, z, i, half, z);
  return points;
}

/** Half the outline of a standing person, turned about its axis and flattened: metres. */
const kPerson = [[0, 0], [0.11, 0], [0.12, 0.45], [0.15, 0.8], [0.16, 0.95], [0.17, 1.1], [0.2, 1.3], [0.19, 1.4], [0.07, 1.45], [0.06, 1.49], [0.1, 1.54], [0.11, 1.6], [0.09, 1.67], [0.04, 1.7], [0, 1.7]];
function person(colour) {
  const material = new ShaderMaterial({
    uniforms: { colour: { value: colour } },
    vertexShader: "varying float vLight; void main() { vLight = 0.72 + 0.28 * dot(normalize(normalMatrix * normal), vec3(0.35, 0.5, 0.79)); gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: "uniform vec3 colour; varying float vLight; void main() { gl_FragColor = vec4(colour * vLight, 1.0); }" });
  const mesh = new Mesh(new LatheGeometry(kPerson.map(([r, z]) => new Vector2(r, z)), 10), material);
  mesh.rotation.x = Math.PI / 2;
  mesh.scale.set(1, 1, 0.65);
  return mesh;
}

/** Edges of a box as pairs of points. */
function boxEdges([x, y, z], [X, Y, Z]) {
  const c = [[x, y, z], [X, y, z], [X, Y, z], [x, Y, z], [x, y, Z], [X, y, Z], [X, Y, Z], [x, Y, Z]];
  return [0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4, 0, 4, 1, 5, 2, 6, 3, 7].flatMap((i) => c[i]);
}

/** Rectangles 1 to 6 m from the walls. */
function distanceLines(low, high, z) {
  const points = [];
  for (let d = 1; d <= 6; ++d) {
    const c = [[low.x - d, low.y - d], [high.x + d, low.y - d], [high.x + d, high.y + d], [low.x - d, high.y + d]];
    for (let i = 0; i < 4; ++i) points.push(...c[i], z, ...c[(i + 1) % 4], z);
  }
  return points;
}

export class Surroundings {
  /** @param low,high  corners of the house  @param facts  of the run: base, rooms */
  constructor(scene, low, high, facts) {
    this.group = new Group();
    scene.add(this.group);
    this.low = low, this.high = high;
    const size = high.distanceTo(low);
    const z = facts.base;
    this.hasBase = z !== null;
    if (this.hasBase) {
      const middle = low.clone().add(high).multiplyScalar(0.5), half = Math.max(12, Math.ceil(2 * size)), x = Math.round(middle.x), y = Math.round(middle.y);
      this.ground = ground(4 * half);
      this.ground.position.set(x, y, z - 0.002);
      this.ground.renderOrder = 1; // after the house, which hides much of it
      this.grid = segments(grid(half, z), [0.4, 0.4, 0.4], 0.28);
      this.grid.position.set(x, y, 0.001);
      this.distances = segments(distanceLines(low, high, z + 0.006), [0.1, 0.35, 0.7], 0.9);
      this.distances.visible = false;
      this.group.add(this.ground, this.grid, this.distances);
      if (size > 2 && size < 60) {
        this.person = person([0.36, 0.4, 0.46]);
        this.person.position.set(low.x - 1.0, low.y - 0.9, z); // off a corner, where walls seldom fall
        this.group.add(this.person);
      }
    }
    if (facts.rooms.length > 0) {
      this.rooms = segments(facts.rooms.flatMap((r) => boxEdges(r.low, r.high)), [0.05, 0.5, 0.45], 0.95, { depthTest: false });
      this.rooms.visible = false;
      this.rooms.renderOrder = 4;
      this.group.add(this.rooms);
    }
  }

  /** @param background, ground  colours */
  dress(background, ground) {
    if (!this.hasBase) return;
    this.ground.material.uniforms.colour.value = ground;
    this.ground.material.uniforms.far.value = background;
  }
}
