// Kind of a file, by its name and content.

import { dialectOfExtension } from "./dialects";
import type { FileContent } from "./file_content";

export type FileKind = "program" | "machine" | "cell" | "robots" | "machine_data" | "path" | "drawing" | "variants" | "other";

const HEAD_LENGTH = 20_000; // bytes that are looked at

const headOf = (content: FileContent): string =>
  typeof content === "string" ? content.slice(0, HEAD_LENGTH) : new TextDecoder().decode(content.subarray(0, HEAD_LENGTH));

function tomlKind(text: string): FileKind {
  if (/^\s*\[\[robot\]\]/m.test(text)) return "robots";
  if (/^\s*\[\[axis\]\]/m.test(text)) return "machine";
  if (/^\s*(\[cell\]|\[\[object\]\]|\[\[frame\]\])/m.test(text)) return "cell";
  return "other";
}

const fileExtension = (name: string): string => name.toLowerCase().split(".").pop() ?? "";

/** True if the name is that of a program, regardless of its content. */
export const hasProgramName = (name: string): boolean => /\.(nc|ngc|tap|cnc|gcode|g|mpf|eia|txt|lua)$/i.test(name);

/** True for a program in Lua, which cannot be analysed before it runs. */
export const isScript = (name: string): boolean => fileExtension(name) === "lua";

/** Without its folders. */
export const baseName = (name: string): string => name.slice(name.lastIndexOf("/") + 1);

/** Returns the kind; for a file that is not in the page (undefined) only the name decides. */
export function kindOfFile(name: string, content: FileContent | undefined): FileKind {
  if (content === undefined) return hasProgramName(name) ? "program" : "other";
  const extension = fileExtension(name);
  if (extension === "toml") return tomlKind(headOf(content));
  if (["dxf", "svg"].includes(extension)) return "drawing";
  if (/\.variants\.json$/i.test(name)) return "variants";
  if (extension === "json" && (/\.path\.json$/i.test(name) || /"targets"\s*:/.test(headOf(content)))) return "path";
  if (["stl", "obj", "step", "stp", "iges", "igs", "json", "md"].includes(extension)) return "other";
  if (extension === "ini") return "machine";
  if (isScript(name)) return "program";
  const head = headOf(content);
  if (/^\s*(#.*\n|;.*\n|\s)*NCFILE\b/.test(head)) return "machine_data";
  if ((typeof content !== "string" && head.includes("\0")) || ["var", "tbl"].includes(extension)) return "other";
  return "program";
}

/** True for a program. Other texts are shown as they are, and checked by the code that reads them. */
export const isProgram = (name: string, content: FileContent): boolean => kindOfFile(name, content) === "program";

/** Returns the language of a program by its name, if it is not set elsewhere. */
export const dialectOfName = (name: string): string => dialectOfExtension(`.${fileExtension(name)}`);

/** Files by name (Documents). */
interface NamedFiles {
  names(): string[];
  kindOf(name: string): FileKind;
}

/** Returns documents of a kind, the user's first. */
export const namesOfKind = (kind: FileKind, documents: NamedFiles): string[] =>
  documents.names().filter((name) => documents.kindOf(name) === kind);

/** Returns a name as in lists: without the folders that contain all samples. */
export const shortName = (name: string): string => name.replace(/^samples\/((machines|cell)\/)?/, "");
