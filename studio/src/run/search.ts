// Where in an order something ends to hold.

/** The last index below `count` for which it holds, where it holds for all before that too; -1: for none. */
export function lastIndex(count: number, holds: (index: number) => boolean): number {
  let [low, high] = [-1, count - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (holds(middle)) low = middle;
    else high = middle - 1;
  }
  return low;
}
