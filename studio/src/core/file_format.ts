// Format of the files that the page reads and writes by itself (docs/versions.md).

import { texts } from "../texts";

export const FILE_FORMAT = 1;

/** Returns a message if a file says that it has another format; null if it has none or this one. */
export const formatError = (format: unknown): string | null =>
  format === undefined || format === FILE_FORMAT ? null : texts.unknownFormat(String(format), FILE_FORMAT);
