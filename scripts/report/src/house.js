// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The house in three dimensions. Nothing is drawn unless something changed.
import { Box3, GridHelper, Mesh, PerspectiveCamera, Quaternion, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { brickMaterial, kBefore, kStride, stateTexture } from "./brick.js";
import { kRed } from "./colours.js";
import { FaceOrder } from "./order.js";
import { allShapes } from "./shapes.js";

const kViews = { corner: [1, -1.4, 0.8], front: [0, -1, 0.12], rear: [0, 1, 0.12], side: [1, 0, 0.12], top: [0, -0.001, 1] };

/** Whether the processor draws; smoothing by four samples a pixel would then halve the rate of frames. */
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl?.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER) ?? "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class House {
  /** @param still  it is for pictures, not for replay: smooth wherever it is drawn, and drawn on white */
  constructor(canvas, run, still) {
    this.run = run;
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: still || !drawsInSoftware(), alpha: !still });
    if (still) this.renderer.setClearColor(0xffffff);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 1, 2);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.#build();
    this.#measure();
    if (run.facts.base !== null) this.#layGround(run.facts.base);
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement);
    this.#resize();
  }

  /** A grid of metres on the base. */
  #layGround(height) {
    const metres = Math.max(40, 2 * Math.ceil(2 * this.size));
    const grid = new GridHelper(metres, metres, 0x888888, 0x888888);
    grid.rotation.x = Math.PI / 2;
    grid.position.z = height;
    grid.material.transparent = true;
    grid.material.opacity = 0.35;
    this.scene.add(grid);
  }

  #build() {
    const { geometry, faces, extent } = allShapes(this.run);
    this.order = new FaceOrder(geometry, faces);
    this.extent = extent;
    this.texture = stateTexture(this.run.frames.n);
    this.state = this.texture.image.data;
    this.material = brickMaterial(this.texture, kRed);
    const mesh = new Mesh(geometry, this.material);
    mesh.frustumCulled = false; // the geometry does not know where its elements are
    this.scene.add(mesh);
  }

  #measure() {
    const v = this.run.vertices, low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    for (let i = 0; i < v.length; i += 3) {
      low.min(new Vector3(v[i], v[i + 1], v[i + 2]));
      high.max(new Vector3(v[i], v[i + 1], v[i + 2]));
    }
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.size = high.distanceTo(low);
    this.camera.near = 0.005 * this.size;
    this.camera.far = 100 * this.size;
  }

  /** From one of the views; `distance` in diagonals of the house. */
  look(name, distance = 2.3) {
    this.controls.target.copy(this.centre);
    this.camera.position.copy(new Vector3(...kViews[name]).normalize().multiplyScalar(distance * this.size).add(this.centre));
    this.controls.update();
    this.draw();
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.#fit(width, height, Math.min(window.devicePixelRatio, 2));
    this.draw();
  }

  #fit(width, height, ratio) {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** Puts every element where it is at frame `at` (need not be whole); `paint` writes their colours (see colours.js). Faces that have come
   *  open by the time `now` are red. */
  show(at, paint, now = kBefore) {
    this.run.frames.place(at, this.state, kStride);
    paint(at, this.state);
    this.broken = this.run.frames.broken(at);
    this.texture.needsUpdate = true;
    this.material.uniforms.now.value = now;
    this.draw();
  }

  /** The element under a point of the window, or -1; of one that is no box, the box about it counts. */
  pick(x, y) {
    const r = this.canvas.getBoundingClientRect(), caster = new Raycaster(), hit = new Vector3(), box = new Box3(), turn = new Quaternion();
    caster.setFromCamera(new Vector2((2 * (x - r.left)) / r.width - 1, 1 - (2 * (y - r.top)) / r.height), this.camera);
    let nearest = Infinity, picked = -1;
    for (let e = 0, at = 0; e < this.run.frames.n; ++e, at += kStride) {
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

  /** A picture from one of the views as a PNG in base64, of so many pixels: nearer than for replay, except from above, where debris counts. */
  picture(view, width, height) {
    this.#fit(width, height, 1);
    this.look(view, view === "top" ? 2.3 : 1.75);
    this.#render(); // toDataURL must follow at once: the browser does not keep what it has shown
    const url = this.canvas.toDataURL("image/png");
    this.#resize();
    return url.slice(url.indexOf(",") + 1);
  }

  #render() {
    this.order.update(this.state, this.broken, this.camera.position);
    this.renderer.render(this.scene, this.camera);
  }

  /** At once, not at the browser's next frame: a picture of the page taken by others then has the house in it, too. */
  draw() {
    if (this.broken) this.#render();
  }
}
