// SPDX-License-Identifier: GPL-3.0-or-later
// The canvas: camera, render on demand, and the rays of the pointer.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { setMarkerDepth } from "./materials";
import { ballOf } from "./surface";

export interface Theme {
  top: string;
  bottom: string;
}

/** From where along the axes one can look; the front is where the camera is when a mesh is opened. */
export type Direction = "front" | "side" | "top";

const usualLens = 32, parallelLens = 1.5; // degrees; with the narrow one parallel lines look parallel
/** What is left of a turn after 1/60 s. */
const inertia = 0.82;

export class Viewport {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera(usualLens, 1, 0.01, 100);
  readonly renderer: THREE.WebGLRenderer;
  readonly controls: OrbitControls;
  /** Called after the size changed; lines of constant width need it. */
  readonly onResize: ((width: number, height: number) => void)[] = [];
  /** Called before each picture. */
  readonly onRender: (() => void)[] = [];
  private wanted = true;
  /** Whether pictures follow each other; while nothing moves none is made and nothing runs. */
  private turns = false;
  private radius = 1;
  private lastFrame = 0;
  private readonly projected = new THREE.Vector3();
  private points: Float32Array = new Float32Array();
  private flight: { from: THREE.Vector3; to: THREE.Vector3; eyeFrom: THREE.Vector3; eyeTo: THREE.Vector3; start: number } | null = null;

  private readonly size = new THREE.Vector2();

  constructor(readonly host: HTMLElement) {
    THREE.ColorManagement.enabled = false;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    host.append(this.renderer.domElement);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.zoomToCursor = true;
    this.controls.enableDamping = true;
    this.controls.zoomSpeed = 1.4;
    this.controls.addEventListener("change", () => this.invalidate());
    this.controls.keyPanSpeed = 24;
    this.controls.keyRotateSpeed = 16;
    this.controls.listenToKeyEvents(this.canvas);
    host.addEventListener("wheel", (event) => this.slide(event), { capture: true, passive: false });
    this.renderer.domElement.tabIndex = 0;
    this.renderer.domElement.setAttribute("aria-label", "The surface in space");
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  /** Comes nearer by a factor above 1, else goes away. */
  zoom(factor: number): void {
    this.controls.dollyIn(1 / factor);
    this.invalidate();
  }

  /** Asks for a new picture. */
  invalidate(): void {
    this.wanted = true;
    if (this.turns) return;
    this.turns = true;
    requestAnimationFrame(this.turn);
  }

  /** Sees all of these points (x, y, z each); from the front and a little from above, or from where it is. */
  fit(points: Float32Array, keepDirection = false): void {
    this.points = points;
    const { centre, radius } = ballOf(points);
    this.radius = radius;
    const up = this.camera.up.clone(), side = new THREE.Vector3(up.y, up.z, up.x), front = up.clone().cross(side).negate();
    const direction = keepDirection
      ? this.camera.position.clone().sub(this.controls.target).normalize()
      : new THREE.Vector3().addScaledVector(side, 0.5).addScaledVector(up, 0.32).addScaledVector(front, 1).normalize();
    const distance = this.distanceFor(points, centre, direction);
    this.fly(centre, direction.multiplyScalar(distance), keepDirection);
    this.limit();
  }

  /** Sees all of these points from where it is. */
  frameOf(points: Float32Array): void {
    this.resize();
    const { centre } = ballOf(points), direction = this.camera.position.clone().sub(this.controls.target).normalize();
    this.fly(centre, direction.clone().multiplyScalar(this.distanceFor(points, centre, direction)), true);
  }

  /** Looks at everything along an axis. */
  look(from: Direction): void {
    const { centre } = ballOf(this.points), up = this.camera.up.clone(), side = new THREE.Vector3(up.y, up.z, up.x), front = up.clone().cross(side).negate();
    // From right above there is no upright: a little of the front keeps it.
    const direction = from === "front" ? front : from === "side" ? side : up.addScaledVector(front, 1e-3).normalize();
    this.fly(centre, direction.multiplyScalar(this.distanceFor(this.points, centre, direction)), true);
  }

  /** A lens so narrow, and an eye so far away, that parallel lines look parallel; what is seen stays as large. */
  setOrthographic(on: boolean): void {
    const before = this.camera.fov, lens = on ? parallelLens : usualLens;
    if (before === lens) return;
    const eye = this.camera.position.clone().sub(this.controls.target).multiplyScalar(halfTangent(before) / halfTangent(lens));
    this.flight = null;
    this.camera.fov = lens;
    this.limit();
    setMarkerDepth(0.008 * (halfTangent(lens) / halfTangent(usualLens)));
    this.camera.position.copy(this.controls.target).add(eye);
    this.controls.update();
    this.invalidate();
  }

  /** How near and how far the eye can be. */
  private limit(): void {
    const times = halfTangent(usualLens) / halfTangent(this.camera.fov);
    this.controls.minDistance = (this.radius * times) / 100;
    this.controls.maxDistance = this.radius * 15 * times;
  }

  /** What is drawn lies between these distances from the eye. */
  private clip(): void {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const near = Math.max(this.radius / 200, distance - 4 * this.radius), far = distance + 40 * this.radius;
    if (Math.abs(near - this.camera.near) < 1e-3 * near && Math.abs(far - this.camera.far) < 1e-3 * far) return;
    this.camera.near = near;
    this.camera.far = far;
    this.camera.updateProjectionMatrix();
  }

  /** How far the eye must be, in that direction from the centre, to have all points in the picture with a margin. */
  private distanceFor(points: Float32Array, centre: THREE.Vector3, direction: THREE.Vector3): number {
    const right = this.camera.up.clone().cross(direction).normalize(), above = direction.clone().cross(right);
    const high = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2)) * 0.88, wide = high * this.camera.aspect;
    const p = new THREE.Vector3();
    let distance = (0.1 * this.radius * halfTangent(usualLens)) / halfTangent(this.camera.fov);
    for (let i = 0; i < points.length; i += 3) {
      p.fromArray(points, i).sub(centre);
      distance = Math.max(distance, p.dot(direction) + Math.max(Math.abs(p.dot(right)) / wide, Math.abs(p.dot(above)) / high));
    }
    return distance;
  }

  setUp(up: THREE.Vector3): void {
    this.camera.up.copy(up);
    // The controls read the camera's up only when they are made; a turn of the quaternion is what they keep.
    const controls = this.controls as unknown as { _quat: THREE.Quaternion; _quatInverse: THREE.Quaternion };
    controls._quat.setFromUnitVectors(up, new THREE.Vector3(0, 1, 0));
    controls._quatInverse.copy(controls._quat).invert();
    this.fit(this.points);
  }

  /** Turns around that point from now on, and comes a little closer; where `outside` is given, to where the point is seen. */
  focus(point: THREE.Vector3, distance?: number, outside?: THREE.Vector3): void {
    const eye = this.camera.position.clone().sub(this.controls.target);
    if (outside && eye.dot(outside) < 0.6 * eye.length()) eye.setLength(0.4).add(outside).setLength(this.camera.position.distanceTo(this.controls.target));
    const times = halfTangent(usualLens) / halfTangent(this.camera.fov);
    eye.setLength(distance !== undefined ? distance * times : Math.max(eye.length() * 0.6, this.radius * 0.35 * times));
    this.fly(point, eye, true);
  }

  private fly(target: THREE.Vector3, offset: THREE.Vector3, smooth: boolean): void {
    const eye = target.clone().add(offset);
    if (!smooth || matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.controls.target.copy(target);
      this.camera.position.copy(eye);
      this.controls.update();
      this.invalidate();
      return;
    }
    this.flight = {
      from: this.controls.target.clone(), to: target.clone(), eyeFrom: this.camera.position.clone(), eyeTo: eye, start: performance.now(),
    };
    this.invalidate();
  }

  ray(event: { clientX: number; clientY: number }): THREE.Raycaster {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height,
    );
    const caster = new THREE.Raycaster();
    caster.setFromCamera(at, this.camera);
    return caster;
  }

  /** Where a point is on the screen, in pixels of the page. */
  project(point: THREE.Vector3, box = this.canvas.getBoundingClientRect()): { x: number; y: number; visible: boolean } {
    const p = this.projected.copy(point).project(this.camera);
    return { x: box.left + ((p.x + 1) / 2) * box.width, y: box.top + ((1 - p.y) / 2) * box.height, visible: p.z < 1 };
  }

  /** The picture as a PNG file. */
  screenshot(): Promise<Blob> {
    this.render();
    return new Promise((resolve, reject) => {
      this.canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("The browser makes no picture."))), "image/png");
    });
  }

  /** A small picture as the text of a `data:` address. */
  thumbnail(width = 208, height = 130): string {
    this.render();
    const canvas = document.createElement("canvas"), { width: w, height: h } = this.canvas;
    [canvas.width, canvas.height] = [width, height];
    const scale = Math.min(w / width, h / height); // the middle of the picture
    canvas.getContext("2d")?.drawImage(this.canvas, (w - scale * width) / 2, (h - scale * height) / 2, scale * width, scale * height, 0, 0, width, height);
    return canvas.toDataURL("image/webp", 0.8);
  }

  /** Two fingers that move sideways on a touchpad, or any way with Shift, move what is seen; other turns of a wheel zoom. */
  private slide(event: WheelEvent): void {
    if (event.ctrlKey || (!event.shiftKey && Math.abs(event.deltaX) < 2 * Math.abs(event.deltaY)) || !this.controls.enabled) return;
    event.preventDefault();
    event.stopPropagation();
    this.controls.pan(-event.deltaX, -event.deltaY);
    this.invalidate();
  }

  private resize(): void {
    const width = Math.max(this.host.clientWidth, 1), height = Math.max(this.host.clientHeight, 1);
    if (width === this.size.x && height === this.size.y) return;
    this.size.set(width, height);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    for (const listener of this.onResize) listener(width, height);
    this.invalidate();
  }

  private readonly turn = (time: number): void => {
    this.turns = this.frame(time);
    if (this.turns) requestAnimationFrame(this.turn);
  };

  /** Makes a picture if it is wanted; whether another one may follow. */
  private frame(time: number): boolean {
    if (this.flight) this.advance(time);
    // A turn dies away in the same time, however many pictures that is.
    const passed = Math.min(Math.max(time - this.lastFrame, 1), 100);
    this.lastFrame = time;
    this.controls.dampingFactor = 1 - inertia ** (passed / (1000 / 60));
    const moves = this.controls.update();
    if (this.wanted) {
      this.wanted = false;
      this.render();
    }
    return moves || this.flight !== null || this.wanted;
  }

  private render(): void {
    this.clip();
    for (const listener of this.onRender) listener();
    this.renderer.render(this.scene, this.camera);
  }

  private advance(time: number): void {
    const flight = this.flight!;
    const t = Math.min(Math.max((time - flight.start) / 320, 0), 1);
    const s = 1 - (1 - t) ** 3;
    this.controls.target.lerpVectors(flight.from, flight.to, s);
    this.camera.position.lerpVectors(flight.eyeFrom, flight.eyeTo, s);
    if (t >= 1) this.flight = null;
    this.invalidate();
  }
}

function halfTangent(degrees: number): number {
  return Math.tan(THREE.MathUtils.degToRad(degrees / 2));
}
