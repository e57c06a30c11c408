// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the file that are not worked on, dimmed.
import * as THREE from "three";
import { floats, indices, type Frame } from "../net/frame";
import { surfaceMaterial } from "./materials";
import { searchMesh, vertexNormals } from "./surface";

export class Others {
  readonly group = new THREE.Group();
  readonly mesh = new THREE.Mesh(new THREE.BufferGeometry(), ghost());
  /** Only their depth, before they are drawn: so what is behind their front does not shine through in patches. */
  private readonly front = new THREE.Mesh(this.mesh.geometry, ghost());
  private partOfVertex: Uint32Array = new Uint32Array();
  private triangles: Uint32Array = new Uint32Array();
  private search: THREE.Mesh | null = null;

  constructor() {
    this.front.material.colorWrite = false;
    this.front.material.depthWrite = true;
    this.front.renderOrder = 12; // after all that is worked on, which they hide nothing of
    this.mesh.renderOrder = 13;
    this.mesh.frustumCulled = this.front.frustumCulled = false;
    this.group.add(this.front, this.mesh);
    this.group.visible = false;
  }

  /** The number of the part takes the place of a chart: so the one under the pointer lights up. */
  set(frame: Frame): void {
    const position = floats(frame, "position");
    this.triangles = indices(frame, "triangle");
    this.partOfVertex = indices(frame, "part");
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(vertexNormals(position, this.triangles), 3));
    geometry.setAttribute("chart", new THREE.BufferAttribute(new Float32Array(this.partOfVertex), 1));
    geometry.setAttribute("field", new THREE.BufferAttribute(new Float32Array(this.partOfVertex.length), 1));
    geometry.setIndex(new THREE.BufferAttribute(this.triangles, 1));
    this.replace(geometry, true);
  }

  clear(): void {
    this.replace(new THREE.BufferGeometry(), false);
  }

  /** The number of the part that the ray meets first, from 1; 0 if it meets none. */
  pick(ray: THREE.Raycaster): number {
    if (!this.group.visible) return 0;
    this.search ??= searchMesh(this.mesh.geometry.getAttribute("position").array as Float32Array, this.triangles);
    ray.firstHitOnly = true;
    const [hit] = ray.intersectObject(this.search, false);
    return hit?.faceIndex == null ? 0 : this.partOfVertex[this.triangles[3 * hit.faceIndex]!]!;
  }

  hover(part: number): void {
    const { hovered, opacity } = this.mesh.material.uniforms;
    hovered!.value = part || -1;
    opacity!.value = part ? 0.36 : 0.2;
  }

  private replace(geometry: THREE.BufferGeometry, visible: boolean): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = this.front.geometry = geometry;
    this.group.visible = visible;
    this.search = null;
    this.hover(0);
  }
}

function ghost(): THREE.ShaderMaterial {
  const material = surfaceMaterial();
  material.defines.LIT_GHOST = 1;
  material.uniforms.opacity!.value = 0.2;
  material.transparent = true;
  material.depthWrite = false;
  return material;
}
