// Content of a file: a text, or bytes that are not text.

export type FileContent = string | Uint8Array;
