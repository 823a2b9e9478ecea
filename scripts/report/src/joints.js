// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Edges of joints on the surface of a model that has not moved, each in the colour of its law.
import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from "three";
import { lawColour } from "./colours.js";

const kMany = 4000; // edges, which take as long as the stones: while somebody turns these are left out where the processor draws

export class JointLines {
  constructor(run) {
    const geometry = new BufferGeometry(), colours = [];
    for (const law of run.lawOf) colours.push(...lawColour(law), ...lawColour(law));
    geometry.setAttribute("position", new Float32BufferAttribute(run.lawEnds, 3));
    geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
    this.mesh = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, toneMapped: false }));
    this.mesh.renderOrder = 3;
    this.many = run.lawOf.length > kMany;
    this.mesh.visible = false;
  }
}
