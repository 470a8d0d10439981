// What a file holds: a text, or bytes that are none.

export type FileContent = string | Uint8Array;
