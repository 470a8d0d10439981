// Shapes of bodies in files: one of five kinds, each with its sizes.

import type { Toml, TomlTable } from "../file/toml";

export const shapeKinds = ["box", "cylinder", "capsule", "sphere", "mesh"] as const;
export type ShapeKind = (typeof shapeKinds)[number];

/** Key of each kind, and the meaning of its numbers. */
const sizes: Record<Exclude<ShapeKind, "mesh">, { key: string; parts: string[] }> = {
  box: { key: "box_mm", parts: ["x", "y", "z"] },
  cylinder: { key: "cylinder_mm", parts: ["diameter", "height"] },
  capsule: { key: "capsule_mm", parts: ["diameter", "height"] },
  sphere: { key: "sphere_mm", parts: ["diameter"] },
};

export const shapeSizes = (kind: ShapeKind): { key: string; parts: string[] } => (kind === "mesh" ? { key: "mesh", parts: [] } : sizes[kind]);

/** Returns null if the kind is not known. */
export const shapeKind = (shape: TomlTable): ShapeKind | null => shapeKinds.find((kind) => shapeSizes(kind).key in shape) ?? null;

export function shapeDimensions(shape: TomlTable): number[] {
  const kind = shapeKind(shape);
  const value = kind ? shape[shapeSizes(kind).key] : [];
  return (Array.isArray(value) ? value : [value]).filter((each): each is number => typeof each === "number");
}

/** Returns the position of a number below its shape: those of a list by their index. */
export const dimensionPath = (kind: ShapeKind, part: number): (string | number)[] =>
  kind === "sphere" ? [shapeSizes(kind).key] : [shapeSizes(kind).key, part];

const DEFAULT_SIZE_MM = 100;

/** Another kind, about as large. */
export function convertShape(kind: ShapeKind, shape: TomlTable, mesh: string): TomlTable {
  if (kind === "mesh") return { mesh };
  const [width = DEFAULT_SIZE_MM, second = width, third = second] = shapeDimensions(shape);
  const values: Record<Exclude<ShapeKind, "mesh">, Toml> = {
    box: [width, shapeKind(shape) === "box" ? second : width, third],
    cylinder: [width, third],
    capsule: [width, third],
    sphere: width,
  };
  return { [sizes[kind].key]: values[kind] };
}

export const isMesh = (name: string): boolean => /\.(stl|obj)$/i.test(name);
