// Messages of the engine to the page: frames of a JSON header and columns of numbers (docs/studio.md).

import { texts } from "../texts";

export type Column = Float64Array | Float32Array | Uint32Array | Uint8Array;

export interface Message {
  is: string;
  header: Record<string, unknown>;
  columns: Map<string, Column>;
}

const kinds = {
  f64: Float64Array,
  f32: Float32Array,
  u32: Uint32Array,
  u8: Uint8Array,
} as const;

const alignUp = (size: number) => (size + 7) & ~7;

/** Format of messages (studio/engine/message.h). An engine of another version may have another one. */
export const MESSAGE_FORMAT = 1;

/** Error for bytes that are no message, or that end too soon. */
export class InvalidMessage extends Error {}

const HEADER_BYTES = 8; // bytes before the header

/** Reads one frame. Its columns are views of `bytes`, at an offset that is a multiple of 8. */
export function readMessage(bytes: Uint8Array): Message {
  if (bytes.length < HEADER_BYTES) throw new InvalidMessage("a message ends within its header");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const headerSize = view.getUint32(4, true);
  if (HEADER_BYTES + headerSize > bytes.length) throw new InvalidMessage("a message ends within its header");
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(HEADER_BYTES, HEADER_BYTES + headerSize)));
  if (header.format !== MESSAGE_FORMAT) throw new InvalidMessage(texts.unknownMessageFormat(String(header.format), MESSAGE_FORMAT));
  const columns = new Map<string, Column>();
  let at = alignUp(HEADER_BYTES + headerSize);
  for (const [name, kind, count] of (header.columns ?? []) as [string, keyof typeof kinds, number][]) {
    const type = kinds[kind];
    if (!type) throw new InvalidMessage(`column ${name} has an unknown type: ${kind}`);
    if (at + count * type.BYTES_PER_ELEMENT > bytes.length) throw new InvalidMessage(`a message ends within column ${name}`);
    columns.set(name, new type(bytes.buffer as ArrayBuffer, bytes.byteOffset + at, count));
    at += alignUp(count * type.BYTES_PER_ELEMENT);
  }
  return { is: header.is, header, columns };
}

/** Returns the bytes of consecutive frames. */
export function* splitFrames(bytes: Uint8Array): Generator<Uint8Array> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = 0; at < bytes.length; ) {
    const size = at + HEADER_BYTES <= bytes.length ? view.getUint32(at, true) : 0;
    if (size < HEADER_BYTES || at + size > bytes.length) throw new InvalidMessage(`the message at byte ${at} is truncated`);
    yield bytes.subarray(at, at + size);
    at += size;
  }
}
