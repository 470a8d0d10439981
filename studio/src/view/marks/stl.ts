// Surfaces from STL files: nine coordinates for a triangle.

const HEADER_BYTES = 84;
const TRIANGLE = 50;

export function stlTriangles(bytes: Uint8Array): Float32Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = bytes.length >= HEADER_BYTES ? view.getUint32(80, true) : 0;
  // A text file may begin like a binary one; the size distinguishes them.
  if (bytes.length !== HEADER_BYTES + TRIANGLE * count) return textTriangles(new TextDecoder().decode(bytes));
  const triangles = new Float32Array(9 * count);
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 9; ++k) triangles[9 * i + k] = view.getFloat32(HEADER_BYTES + TRIANGLE * i + 12 + 4 * k, true);
  }
  return triangles;
}

/** Reads triangles; those that lack a corner or a number are left out. */
function textTriangles(text: string): Float32Array {
  const numbers = [...text.matchAll(/vertex\s+(\S+)\s+(\S+)\s+(\S+)/g)].flatMap(([, x, y, z]) => [+x, +y, +z]);
  const triangles: number[] = [];
  for (let at = 0; at + 9 <= numbers.length; at += 9) {
    const triangle = numbers.slice(at, at + 9);
    if (triangle.every(Number.isFinite)) triangles.push(...triangle);
  }
  return new Float32Array(triangles);
}
