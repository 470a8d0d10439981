// Surfaces as STL files have them: nine coordinates for a triangle.

const HEAD = 84;
const TRIANGLE = 50;

export function stlTriangles(bytes: Uint8Array): Float32Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = bytes.length >= HEAD ? view.getUint32(80, true) : 0;
  // A text file may begin like a binary one; the size tells.
  if (bytes.length !== HEAD + TRIANGLE * count) return textTriangles(new TextDecoder().decode(bytes));
  const triangles = new Float32Array(9 * count);
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 9; ++k) triangles[9 * i + k] = view.getFloat32(HEAD + TRIANGLE * i + 12 + 4 * k, true);
  }
  return triangles;
}

function textTriangles(text: string): Float32Array {
  const corners = text.matchAll(/vertex\s+(\S+)\s+(\S+)\s+(\S+)/g);
  return new Float32Array([...corners].flatMap((corner) => [+corner[1], +corner[2], +corner[3]]));
}
