// Adapts file names in files when a file gets another name, and finds free names.

import { baseName } from "../../../core/file_kinds";
import { folderOf, isTomlFile, referenceTo, resolved } from "../../../core/references";
import { tablesAt, textAt, type TomlPath, type TomlChange, type TomlTable } from "./toml";

/**
 * Returns the positions that name other files: machines name their controller and meshes, cells and robots
 * also their machines.
 */
function findReferences(value: TomlTable): TomlPath[] {
  const meshes = ["object", "shape"].flatMap((kind) => tablesAt(value, [kind]).map((_, i): TomlPath => [kind, i, "shape", "mesh"]));
  const robots = tablesAt(value, ["robot"]).flatMap((_, i) =>
    ["machine", "machine_data", "cell"].map((key): TomlPath => ["robot", i, key]),
  );
  const single: TomlPath[] = [
    ["cell", "machine"],
    ["cell", "machine_data"],
  ];
  const controller: TomlPath[] = isTomlFile(textAt(value, ["controller", "model"])) ? [["controller", "model"]] : [];
  return [...controller, ...single, ...meshes, ...robots].filter((at) => textAt(value, at) !== "");
}

/** Returns the changes that a file needs to mean the same under another name. */
export function moved(value: TomlTable, from: string, to: string): TomlChange[] {
  if (folderOf(from) === folderOf(to)) return [];
  return findReferences(value).map((at) => ({ op: "set", at, value: referenceTo(to, resolved(from, textAt(value, at))) }));
}

/**
 * Returns the name for a copy: "samples/machines/router3.toml" is copied to "my-router3.toml", or
 * "my-router3-2.toml" if that is taken.
 */
export function copyName(name: string, isTaken: (name: string) => boolean): string {
  const base = baseName(name);
  return freeName(base.startsWith("my-") ? base : `my-${base}`, isTaken);
}

export function freeName(name: string, isTaken: (name: string) => boolean): string {
  const stem = name.replace(/\.toml$/, "");
  let free = name;
  for (let i = 2; isTaken(free); ++i) free = `${stem}-${i}.toml`;
  return free;
}
