// Names of files in files, relative to the folder of the file that contains them.

/** Returns the folder with its final slash; empty: the outermost. */
export const folderOf = (name: string): string => name.slice(0, name.lastIndexOf("/") + 1);

/** Normalises "a/b/../c.toml" to "a/c.toml"; a path that leads out of all folders stays unchanged. */
function plain(name: string): string {
  const parts: string[] = [];
  for (const part of name.split("/")) {
    const above = parts.at(-1);
    if (part === ".." && above !== undefined && above !== "..") parts.pop();
    else if (part !== "." && (part !== "" || parts.length === 0)) parts.push(part);
  }
  return parts.join("/");
}

/** Returns the document that `reference` means in `file`. */
export const resolved = (file: string, reference: string): string =>
  plain(reference.startsWith("/") ? reference : folderOf(file) + reference);

/** Returns the reference to a document from `file`. */
export function referenceTo(file: string, document: string): string {
  const from = folderOf(file).split("/").slice(0, -1);
  const to = document.split("/");
  let same = 0;
  while (same < from.length && same < to.length - 1 && from[same] === to[same]) ++same;
  return [...from.slice(same).map(() => ".."), ...to.slice(same)].join("/");
}

/** True for a TOML file; a controller's model is then not a built-in one. */
export const isTomlFile = (name: string): boolean => /\.toml$/i.test(name);
