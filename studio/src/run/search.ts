// Binary search for the end of a condition.

/** Returns the last index below `count` that holds, provided all before it hold too; -1: none. */
export function lastIndex(count: number, holds: (index: number) => boolean): number {
  let [low, high] = [-1, count - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (holds(middle)) low = middle;
    else high = middle - 1;
  }
  return low;
}
