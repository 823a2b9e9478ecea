// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The house in three dimensions. Nothing is drawn unless something changed.
import { Box3, Color, Mesh, PerspectiveCamera, Quaternion, Raycaster, SRGBColorSpace, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { brickMaterial, kBefore, kStride, shadowMaterial, stateTexture } from "./brick.js";
import { kRed } from "./colours.js";
import { CrackLines } from "./cracks.js";
import { JointLines } from "./joints.js";
import { FaceOrder } from "./order.js";
import { allShapes } from "./shapes.js";
import { Surroundings } from "./surroundings.js";
import { fit, kViews } from "./views.js";

const kWorth = 0.1, kVain = 20; // part of the faces that others hide, below which so many pictures are drawn without looking for these
const kRest = 150; // ms, after which a house that nobody turns is at rest

const kLight = { background: [0.965, 0.96, 0.945], ground: [0.895, 0.875, 0.84], shadow: [0.8, 0.775, 0.735] };
const kDark = { background: [0.105, 0.11, 0.12], ground: [0.2, 0.195, 0.185], shadow: [0.13, 0.125, 0.12] };

/** Whether the processor draws; smoothing by four samples a pixel would then halve the rate of frames. */
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl?.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER) ?? "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class House {
  /** @param still  it is for pictures, not for replay: smooth wherever it is drawn */
  constructor(canvas, run, still) {
    this.run = run;
    this.canvas = canvas;
    this.software = drawsInSoftware();
    // Without a transparent background: the browser would blend the picture with the page below, and the processor would have to do that.
    const context = canvas.getContext("webgl2", { alpha: false, stencil: false, antialias: still || !this.software });
    this.renderer = new WebGLRenderer({ canvas, context });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 1, 2);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    canvas.style.touchAction = "pan-y"; // a finger that goes up or down moves the page; across, or two fingers, the house
    this.controls.addEventListener("change", () => this.turned());
    this.controls.addEventListener("start", () => ((this.held = true), this.turnsByHand()));
    this.controls.addEventListener("end", () => (this.held = false));
    this.moving = this.turns = false; // while it plays or is turned, what takes long is left out
    this.vain = 0; // pictures for which hidden faces are not looked for
    this.hidden = new Uint8Array(run.frames.n + 1);
    this.partly = false;
    this.way = new Vector3(); // of the ground, from where the camera stands
    this.#measure();
    this.around = new Surroundings(this.scene, this.low, this.high, run.facts);
    this.#build();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  /** Somebody begins to turn it, or goes on; soon after the last of this it is drawn with all there is. */
  turnsByHand() {
    if (!this.software || this.fixed) return;
    this.turns = true;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => ((this.turns = false), this.draw()), kRest);
  }

  /** The camera has moved. */
  turned() {
    if (this.held) this.turnsByHand();
    this.draw();
    this.onTurn?.(this);
  }

  #build() {
    const { run } = this, { geometry, faces, extent } = allShapes(run);
    this.order = new FaceOrder(geometry, faces);
    this.extent = extent;
    this.texture = stateTexture(run.frames.n);
    this.state = this.texture.image.data;
    this.material = brickMaterial(this.texture, kRed);
    const mesh = new Mesh(geometry, this.material);
    mesh.frustumCulled = false; // the geometry does not know where its elements are
    this.lines = new CrackLines(run, this.texture, kRed, faces);
    this.scene.add(mesh, this.lines.mesh);
    if (run.model) {
      this.joints = new JointLines(run);
      Object.assign(this.material, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 }); // lines lie on faces
      this.scene.add(this.joints.mesh);
    }
    if (run.facts.base === null) return;
    this.shadow = new Mesh(geometry, shadowMaterial(this.texture, run.facts.base, kLight.shadow));
    this.shadow.frustumCulled = false;
    this.shadow.renderOrder = -1;
    this.scene.add(this.shadow);
  }

  #measure() {
    const v = this.run.vertices, low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate(), p = new Vector3();
    for (let i = 0; i < v.length; i += 3) low.min(p.set(v[i], v[i + 1], v[i + 2])), high.max(p);
    Object.assign(this, { low, high, centre: low.clone().add(high).multiplyScalar(0.5), size: high.distanceTo(low) });
    this.camera.near = 0.01 * this.size;
    this.camera.far = 60 * this.size;
  }

  /** Colours of day or of night. */
  dress(dark) {
    const { background, ground, shadow } = dark ? kDark : kLight;
    this.renderer.setClearColor(new Color().setRGB(...background, SRGBColorSpace));
    this.dressed = true;
    this.around.dress(background, ground);
    if (this.shadow) this.shadow.material.uniforms.colour.value = shadow;
    this.draw();
  }

  /** What a picture has to hold: the house as it was, and where its elements are now, but for the few that went far. */
  #extent() {
    const { low, high, size, state } = this, points = [];
    for (let i = 0; i < 8; ++i) points.push(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    const middle = this.centre, person = this.around.person;
    if (person?.visible) for (const height of [0, 1.8]) for (const side of [-0.3, 0.3]) points.push(person.position.x + side, person.position.y, person.position.z + height);
    for (let e = 0; this.broken && e < this.run.frames.n; ++e) {
      const at = kStride * e, far = Math.hypot(state[at] - middle.x, state[at + 1] - middle.y);
      if (!this.hidden[e] && far < 1.3 * size && far > 0.4 * size) points.push(state[at], state[at + 1], state[at + 2]);
    }
    return points;
  }

  /** From one of the views. */
  look(name) {
    this.view = name;
    this.hideRoof(name === "plan");
    if (this.around.person) this.around.person.visible = !/top|plan/.test(name); // from above nobody would know it
    this.around.distances && (this.around.distances.visible = name === "plan");
    this.controls.target.copy(fit(this.camera, kViews[name], this.#extent(), this.fixed ? 0.76 : 0.88)).sub(this.way);
    this.camera.position.sub(this.way);
    this.controls.update();
    this.turned();
  }

  /** The camera and what it looks at, as the house sees them: six numbers. */
  get placed() { return [...this.camera.position.clone().add(this.way), ...this.controls.target.clone().add(this.way)]; }
  place(numbers) {
    this.camera.position.fromArray(numbers).sub(this.way);
    this.controls.target.fromArray(numbers, 3).sub(this.way);
    this.controls.update();
    this.turned();
  }

  /** Goes where an element has gone since the last call; `followed` null: from here on. */
  follow(element) {
    const at = kStride * element, here = new Vector3(this.state[at], this.state[at + 1], this.state[at + 2]), step = here.clone().sub(this.followed ?? here);
    this.camera.position.add(step);
    this.controls.target.add(step);
    this.followed = here;
  }

  /** All that stands on the ground moves with it, and the picture does not. @param way  of the ground, m; zeros: the picture moves with it */
  shake(way) {
    const step = new Vector3(...way).sub(this.way);
    this.way.add(step);
    this.camera.position.sub(step);
    this.controls.target.sub(step);
  }

  /** Turns about the target by angles, and goes nearer by a factor. */
  orbit(across, up, nearer = 1) {
    const back = this.camera.position.clone().sub(this.controls.target), length = back.length() / nearer;
    const azimuth = Math.atan2(back.y, back.x) + across, flat = Math.hypot(back.x, back.y);
    const height = Math.min(1.55, Math.max(-0.3, Math.atan2(back.z, flat) + up));
    back.set(Math.cos(azimuth) * Math.cos(height), Math.sin(azimuth) * Math.cos(height), Math.sin(height)).multiplyScalar(length);
    this.camera.position.copy(this.controls.target).add(back);
    this.turnsByHand();
    this.controls.update();
    this.turned();
  }

  resize() {
    if (this.fixed) return; // pictures have a size of their own
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.fitTo(width, height, Math.min(window.devicePixelRatio, 2));
    if (this.onResize) this.onResize();
    else this.draw();
  }

  fitTo(width, height, ratio) {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.lines.material.uniforms.pixels.value = [width * ratio, height * ratio];
    this.lines.material.uniforms.scale.value = Math.max(ratio, (height * ratio) / 640);
  }

  /** Hides elements of the roof. */
  hideRoof(on) {
    this.roofOff = on;
    this.#hide();
  }
  /** Hides what lies before a plane: null, or {axis, at: its place between the ends of the house, 0 to 1}. */
  cut(plane) {
    this.plane = plane;
    this.#hide();
  }
  #hide() {
    const { parts, facts, frames } = this.run, roof = facts.parts.map((name) => /roof|vault|voussoir/.test(name));
    const { plane, low, high } = this, axis = plane?.axis ?? 0, at = low.getComponent(axis) + (plane?.at ?? 0) * (high.getComponent(axis) - low.getComponent(axis));
    for (let e = 0; e < frames.n; ++e) this.hidden[e] = (this.roofOff && roof[parts[e]]) || (plane && frames.centroids[3 * e + axis] < at) ? 1 : 0;
    this.partly = Boolean(this.roofOff || plane);
  }

  /** Puts every element where it is at frame `at` (need not be whole), in the colours of `colouring` (colours.js). Faces that have come open by
   *  the time `now` are red, if the colouring says so. */
  show(at, colouring, now, magnified) {
    this.at = at;
    this.now = magnified > 1 ? Infinity : now; // magnified, narrow joints are wide
    this.run.frames.place(at, this.state, kStride, magnified);
    if (colouring !== this.colouring || !colouring.steady) colouring.paint(at, this.state);
    this.colouring = colouring;
    this.broken = this.run.frames.broken(at);
    this.texture.needsUpdate = true;
    this.material.uniforms.now.value = colouring.opened ? now : kBefore;
    this.material.uniforms.edges.value = colouring.edges;
    this.lines.mesh.visible = Boolean(colouring.lines);
    this.draw();
  }

  /** Shows a mode of the structure as it was built. @param largest  see modes.js */
  showMode(modes, mode, largest, colouring) {
    modes.place(mode, largest, this.state, kStride);
    colouring.paint(0, this.state);
    this.colouring = null;
    this.loose ??= new Uint8Array(this.run.frames.n).fill(1); // all faces are drawn: bricks that lean part a little
    Object.assign(this, { at: 0, now: Infinity, broken: this.loose });
    this.texture.needsUpdate = true;
    this.material.uniforms.now.value = kBefore;
    this.material.uniforms.edges.value = colouring.edges;
    this.lines.mesh.visible = false;
    this.draw();
  }

  /** Where an element has taken a point of the reference configuration. */
  carried(element, point) {
    const at = kStride * element, c = this.run.frames.centroids, p = new Vector3(...[0, 1, 2].map((k) => point[k] - c[3 * element + k]));
    p.applyQuaternion(new Quaternion().fromArray(this.state, at + 4));
    return [0, 1, 2].map((k) => this.state[at + k] + p.getComponent(k));
  }

  /** Lights up an element; -1: none. */
  lightUp(element) {
    this.material.uniforms.picked.value = element;
    this.draw();
  }

  /** The element under a point of the window, or -1; of one that is no box, the box about it counts. */
  pick(x, y) {
    const r = this.canvas.getBoundingClientRect(), caster = new Raycaster(), hit = new Vector3(), box = new Box3(), turn = new Quaternion();
    caster.setFromCamera(new Vector2((2 * (x - r.left)) / r.width - 1, 1 - (2 * (y - r.top)) / r.height), this.camera);
    let nearest = Infinity, picked = -1;
    for (let e = 0, at = 0; e < this.run.frames.n; ++e, at += kStride) {
      if (this.hidden[e]) continue;
      turn.fromArray(this.state, at + 4).invert();
      const ray = caster.ray.clone(); // as the element sees it
      ray.origin.sub(new Vector3().fromArray(this.state, at)).applyQuaternion(turn);
      ray.direction.applyQuaternion(turn);
      box.min.fromArray(this.extent, 6 * e);
      box.max.fromArray(this.extent, 6 * e + 3);
      if (ray.intersectBox(box, hit) && hit.distanceTo(ray.origin) < nearest) {
        nearest = hit.distanceTo(ray.origin);
        picked = e;
      }
    }
    return picked;
  }

  /** Chooses the faces that are drawn. @param moving  without those that others hide; returns which part these are */
  chooseFaces(moving) {
    const { width, height } = this.canvas, picture = moving ? { camera: this.camera, width, height } : null;
    const left_out = this.order.update(this.state, this.broken, this.camera.position, this.now, this.hidden, this.partly, picture);
    if (this.lines.mesh.visible) this.lines.update(this.at, this.hidden, this.order.seen);
    return left_out;
  }

  render() {
    const plain = this.software && (this.moving || this.turns);
    const looks = plain && --this.vain < 0, left_out = this.chooseFaces(looks);
    if (looks && left_out < kWorth) this.vain = kVain;
    if (this.shadow) this.shadow.visible = !plain;
    if (this.joints) this.joints.mesh.visible = Boolean(this.colouring?.laws) && !(plain && this.joints.many);
    this.renderer.render(this.scene, this.camera);
  }

  /** At once, not at the browser's next frame: a picture of the page taken by others then has the house in it, too. */
  draw() {
    if (!this.broken || !this.dressed) return;
    this.render();
    this.onDraw?.(this);
  }
}
