// What the engine tells the page: frames of a JSON header and columns of numbers (docs/studio.md).

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

const aligned = (size: number) => (size + 7) & ~7;

/** One frame. Its columns are views of `bytes`, whose offset is a multiple of 8. */
export function readMessage(bytes: Uint8Array): Message {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const headerSize = view.getUint32(4, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(8, 8 + headerSize)));
  const columns = new Map<string, Column>();
  let at = aligned(8 + headerSize);
  for (const [name, kind, count] of (header.columns ?? []) as [string, keyof typeof kinds, number][]) {
    const type = kinds[kind];
    columns.set(name, new type(bytes.buffer as ArrayBuffer, bytes.byteOffset + at, count));
    at += aligned(count * type.BYTES_PER_ELEMENT);
  }
  return { is: header.is, header, columns };
}

/** Frames that stand one behind the other; the bytes of each. */
export function* framesOf(bytes: Uint8Array): Generator<Uint8Array> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = 0; at < bytes.length; ) {
    const size = view.getUint32(at, true);
    yield bytes.subarray(at, at + size);
    at += size;
  }
}
