// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// The house in three dimensions. Nothing is drawn unless something changed.
import { Color, GridHelper, InstancedMesh, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { brickMaterial } from "./brick.js";
import { distinctShapes } from "./shapes.js";

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
  constructor(canvas, run) {
    this.run = run;
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: !drawsInSoftware(), alpha: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 0.05, 500);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.#layGround();
    this.material = brickMaterial();
    this.meshes = distinctShapes(run).map((shape) => this.#add(shape));
    this.#measure();
    this.look("corner");
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement);
    this.#resize();
  }

  #layGround() {
    const grid = new GridHelper(40, 40, 0x888888, 0x888888);
    grid.rotation.x = Math.PI / 2;
    grid.material.transparent = true;
    grid.material.opacity = 0.35;
    this.scene.add(grid);
  }

  #add({ geometry, elements, sizes }) {
    const mesh = new InstancedMesh(geometry, this.material, elements.length);
    mesh.frustumCulled = false; // instances leave the bounds of the first frame
    mesh.setColorAt(0, new Color());
    this.scene.add(mesh);
    return Object.assign(mesh, { elements, sizes });
  }

  #measure() {
    const c = this.run.frames.centroids, low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    for (let i = 0; i < c.length; i += 3) {
      low.min(new Vector3(c[i], c[i + 1], c[i + 2]));
      high.max(new Vector3(c[i], c[i + 1], c[i + 2]));
    }
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.size = Math.max(0.1, high.distanceTo(low));
  }

  look(name) {
    this.controls.target.copy(this.centre);
    this.camera.position.copy(new Vector3(...kViews[name]).normalize().multiplyScalar(2.3 * this.size).add(this.centre));
    this.controls.update();
    this.draw();
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Puts every element where it is at frame `at` (need not be whole); `colour(e)` gives [r, g, b]. */
  show(at, colour) {
    for (const mesh of this.meshes) {
      mesh.elements.forEach((e, i) => {
        this.#place(mesh.instanceMatrix.array, 16 * i, e, at, mesh.sizes, 3 * i);
        mesh.instanceColor.array.set(colour(e), 3 * i);
      });
      mesh.instanceMatrix.needsUpdate = mesh.instanceColor.needsUpdate = true;
    }
    this.draw();
  }

  /** Column-major 4×4 of rotation, size and position. */
  #place(m, to, e, at, sizes, s) {
    const frames = this.run.frames;
    let w = frames.quaternion(at, e, 0), x = frames.quaternion(at, e, 1), y = frames.quaternion(at, e, 2), z = frames.quaternion(at, e, 3);
    const length = Math.hypot(w, x, y, z) || 1;
    (w /= length), (x /= length), (y /= length), (z /= length);
    const a = sizes[s], b = sizes[s + 1], c = sizes[s + 2];
    m[to] = a * (1 - 2 * (y * y + z * z)), m[to + 1] = 2 * a * (x * y + w * z), m[to + 2] = 2 * a * (x * z - w * y);
    m[to + 4] = 2 * b * (x * y - w * z), m[to + 5] = b * (1 - 2 * (x * x + z * z)), m[to + 6] = 2 * b * (y * z + w * x);
    m[to + 8] = 2 * c * (x * z + w * y), m[to + 9] = 2 * c * (y * z - w * x), m[to + 10] = c * (1 - 2 * (x * x + y * y));
    for (let k = 0; k < 3; ++k) m[to + 12 + k] = frames.position(at, e, k);
    m[to + 15] = 1;
  }

  /** The element under a point of the window, or -1. */
  pick(x, y) {
    const r = this.canvas.getBoundingClientRect(), ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * (x - r.left)) / r.width - 1, 1 - (2 * (y - r.top)) / r.height), this.camera);
    for (const mesh of this.meshes) mesh.computeBoundingSphere();
    const hit = ray.intersectObjects(this.meshes)[0];
    return hit ? hit.object.elements[hit.instanceId] : -1;
  }

  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.renderer.render(this.scene, this.camera);
    });
  }
}
