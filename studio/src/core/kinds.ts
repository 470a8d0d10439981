// What a file is, by its name and what stands in it.

import type { FileContent } from "./documents";

export type FileKind = "program" | "machine" | "cell" | "robots" | "machine_data" | "other";

const HEAD = 20_000; // bytes that are looked at

const headOf = (content: FileContent): string =>
  typeof content === "string" ? content.slice(0, HEAD) : new TextDecoder().decode(content.subarray(0, HEAD));

function kindOfToml(text: string): FileKind {
  if (/^\s*\[\[robot\]\]/m.test(text)) return "robots";
  if (/^\s*\[\[axis\]\]/m.test(text)) return "machine";
  if (/^\s*(\[cell\]|\[\[object\]\]|\[\[frame\]\])/m.test(text)) return "cell";
  return "other";
}

const endingOf = (name: string): string => name.toLowerCase().split(".").pop() ?? "";

/** A program in Lua, of which nothing is known before it runs. */
export const isScript = (name: string): boolean => endingOf(name) === "lua";

/** Without its folders. */
export const baseName = (name: string): string => name.slice(name.lastIndexOf("/") + 1);

export function kindOfFile(name: string, content: FileContent): FileKind {
  const ending = endingOf(name);
  if (ending === "toml") return kindOfToml(headOf(content));
  if (["stl", "obj", "step", "stp", "iges", "igs", "dxf", "svg", "json", "md"].includes(ending)) return "other";
  if (ending === "ini") return "machine";
  if (isScript(name)) return "program";
  const head = headOf(content);
  if (/^\s*(#.*\n|;.*\n|\s)*NCFILE\b/.test(head)) return "machine_data";
  if ((typeof content !== "string" && head.includes("\0")) || ["var", "tbl"].includes(ending)) return "other";
  return "program";
}

/** The language of a program by its name, where nothing else says it. */
export const dialectOfName = (name: string): string => (endingOf(name) === "ngc" ? "rs274ngc" : "");
