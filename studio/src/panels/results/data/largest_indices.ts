// Selects the first few of many in an order, without sorting all of them.

/**
 * Returns up to `maxCount` numbers below `count` that `passes` accepts, with the largest `key`, in descending
 * order; of equal keys the lower number is first.
 */
export function largestIndices(
  count: number,
  maxCount: number,
  key: (index: number) => number,
  passes: (index: number) => boolean,
): { indices: Uint32Array; passed: number } {
  const heap = new Uint32Array(maxCount);
  const keys = new Float64Array(maxCount);
  let size = 0;
  let passed = 0;
  // The root is the first to be replaced.
  const before = (keyA: number, a: number, keyB: number, b: number) => keyA < keyB || (keyA === keyB && a > b);
  const sink = (at: number, index: number, value: number) => {
    for (;;) {
      let child = 2 * at + 1;
      if (child >= size) break;
      if (child + 1 < size && before(keys[child + 1], heap[child + 1], keys[child], heap[child])) ++child;
      if (!before(keys[child], heap[child], value, index)) break;
      heap[at] = heap[child];
      keys[at] = keys[child];
      at = child;
    }
    heap[at] = index;
    keys[at] = value;
  };
  const rise = (index: number, value: number) => {
    let at = size++;
    while (at > 0) {
      const parent = (at - 1) >> 1;
      if (!before(value, index, keys[parent], heap[parent])) break;
      heap[at] = heap[parent];
      keys[at] = keys[parent];
      at = parent;
    }
    heap[at] = index;
    keys[at] = value;
  };
  for (let index = 0; index < count; ++index) {
    if (!passes(index)) continue;
    ++passed;
    const value = key(index);
    if (size < maxCount) rise(index, value);
    else if (size > 0 && before(keys[0], heap[0], value, index)) sink(0, index, value);
  }
  const indices = heap.slice(0, size).sort((a, b) => key(b) - key(a) || a - b);
  return { indices, passed };
}
