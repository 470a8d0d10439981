// Names of files in files, which count from the folder of the file that they stand in.

/** With the stroke at its end; empty: the outermost. */
export const folderOf = (name: string): string => name.slice(0, name.lastIndexOf("/") + 1);

/** "a/b/../c.toml" is "a/c.toml"; what leads out of all folders stays so. */
function plain(name: string): string {
  const parts: string[] = [];
  for (const part of name.split("/")) {
    const above = parts.at(-1);
    if (part === ".." && above !== undefined && above !== "..") parts.pop();
    else if (part !== "." && (part !== "" || parts.length === 0)) parts.push(part);
  }
  return parts.join("/");
}

/** The document that `reference` means in `file`. */
export const resolved = (file: string, reference: string): string =>
  plain(reference.startsWith("/") ? reference : folderOf(file) + reference);

/** How `file` refers to a document. */
export function referenceTo(file: string, document: string): string {
  const from = folderOf(file).split("/").slice(0, -1);
  const to = document.split("/");
  let same = 0;
  while (same < from.length && same < to.length - 1 && from[same] === to[same]) ++same;
  return [...from.slice(same).map(() => ".."), ...to.slice(same)].join("/");
}

/** A file of TOML; of a controller's model, that it is none of those built in. */
export const isFile = (name: string): boolean => /\.toml$/i.test(name);
