// Which contours of a part are cut, of all that could be: the engine is told by numbers of their edges.

/** As the engine lists it. */
export interface ListedContour {
  /** As messages name it: "the plane face #40 at (1, 2, 3)". */
  face: string;
  isHole: boolean;
  /** Numbers in the file; empty where it has none. */
  edges: string[];
  length_mm: number;
  depth_mm: number;
  lean_deg: number;
  /** Places along it, three numbers each; the last is the first. */
  line_mm: Float64Array;
}

/** Whether each can be told from the others: an IGES file may have no numbers of edges. */
export const canBePicked = (contours: readonly ListedContour[]): boolean => contours.every(({ edges }) => edges.some((edge) => edge !== ""));

/** Which are cut by these picks; undefined: all are. */
export function pickedBy(contours: readonly ListedContour[], picks: readonly string[] | undefined): boolean[] {
  return contours.map(({ edges }) => picks === undefined || edges.some((edge) => picks.includes(edge)));
}

/** An edge that no contour has that is not cut; of one that shares all of its edges, the first. */
function edgeOf(contour: ListedContour, others: ReadonlySet<string>): string {
  const known = contour.edges.filter((edge) => edge !== "");
  return known.find((edge) => !others.has(edge)) ?? known[0];
}

/** One edge for each that is cut; undefined where all are. */
export function picksOf(contours: readonly ListedContour[], isCut: readonly boolean[]): string[] | undefined {
  if (isCut.every(Boolean)) return undefined;
  const others = new Set(contours.flatMap(({ edges }, i) => (isCut[i] ? [] : edges)));
  return contours.flatMap((contour, i) => (isCut[i] ? [edgeOf(contour, others)] : []));
}

/** Picks that were made of an earlier list: those that are not known any more go. Where none is left, all are cut. */
export function stillKnown(contours: readonly ListedContour[], picks: readonly string[] | undefined): string[] | undefined {
  if (picks === undefined || picks.length === 0) return picks && [];
  const isCut = pickedBy(contours, picks);
  return isCut.some(Boolean) ? picksOf(contours, isCut) : undefined;
}

/** Which are cut when one is taken out or in. Bodies that stand in an assembly twice have the same edges: their contours go together. */
export function withTicked(contours: readonly ListedContour[], isCut: readonly boolean[], contour: number, on: boolean): boolean[] {
  const edges = contours[contour].edges.join();
  return isCut.map((each, i) => (contours[i].edges.join() === edges ? on : each));
}
