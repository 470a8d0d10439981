// Materials of bodies by role, one set for the complete view, so that a change of theme reaches all.

import { DoubleSide, FrontSide, LineBasicMaterial, MeshBasicMaterial, MeshLambertMaterial, type Material } from "three";
import type { Palette } from "../theme";

export type Role = "machine" | "structure" | "fixture" | "workpiece" | "jet" | "tool" | "hit" | "near";

const litMaterial = (opacity = 1) =>
  new MeshLambertMaterial({
    side: opacity < 1 ? FrontSide : DoubleSide,
    transparent: opacity < 1,
    opacity,
    depthWrite: opacity === 1,
    // Lines in the work plane, as a path on flat material, are drawn in front of the surface.
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 2,
  });

export class BodyMaterials {
  readonly solid: Record<Role, MeshLambertMaterial | MeshBasicMaterial> = {
    machine: litMaterial(),
    structure: litMaterial(0.45),
    fixture: litMaterial(),
    workpiece: litMaterial(0.35),
    jet: new MeshBasicMaterial({ transparent: true, opacity: 0.75, depthWrite: false }),
    tool: litMaterial(),
    hit: litMaterial(),
    near: litMaterial(),
  };
  readonly edges = new LineBasicMaterial({ transparent: true, opacity: 0.55 });

  recolour(colours: Palette): void {
    for (const [role, material] of Object.entries(this.solid)) material.color.copy(colours[role as Role]);
    this.edges.color.copy(colours.edges);
  }

  get all(): Material[] {
    return [...Object.values(this.solid), this.edges];
  }
}
