// Contours of a part that are cut, of all possible ones: the engine gets the numbers of their edges.

/** As the engine lists it. */
export interface ListedContour {
  /** Name as in messages: "the plane face #40 at (1, 2, 3)". */
  face: string;
  isHole: boolean;
  /** Numbers in the file; empty if it has none. */
  edges: string[];
  length_mm: number;
  depth_mm: number;
  tilt_deg: number;
  /** Positions along it, three numbers each; the last is the first. */
  polyline_mm: Float64Array;
}

/** True if each can be distinguished from the others: an IGES file may have no numbers of edges. */
export const areSelectable = (contours: readonly ListedContour[]): boolean => contours.every(({ edges }) => edges.some((edge) => edge !== ""));

/** Returns which contours these picks cut; undefined: all. */
export function selectedContours(contours: readonly ListedContour[], picks: readonly string[] | undefined): boolean[] {
  return contours.map(({ edges }) => picks === undefined || edges.some((edge) => picks.includes(edge)));
}

/** Returns an edge that no uncut contour has; the first one if it shares all of its edges. */
function identifyingEdge(contour: ListedContour, others: ReadonlySet<string>): string {
  const known = contour.edges.filter((edge) => edge !== "");
  return known.find((edge) => !others.has(edge)) ?? known[0];
}

/** Returns one edge for each contour that is cut; undefined if all are. */
export function selectedEdges(contours: readonly ListedContour[], isCut: readonly boolean[]): string[] | undefined {
  if (isCut.every(Boolean)) return undefined;
  const others = new Set(contours.flatMap(({ edges }, i) => (isCut[i] ? [] : edges)));
  return contours.flatMap((contour, i) => (isCut[i] ? [identifyingEdge(contour, others)] : []));
}

/** Keeps the picks of an earlier list that are still known. Without any of them, all contours are cut. */
export function keepKnownEdges(contours: readonly ListedContour[], picks: readonly string[] | undefined): string[] | undefined {
  if (picks === undefined || picks.length === 0) return picks && [];
  const isCut = selectedContours(contours, picks);
  return isCut.some(Boolean) ? selectedEdges(contours, isCut) : undefined;
}

/**
 * Returns which contours are cut after one is removed or added. Bodies that occur twice in an assembly have
 * the same edges: their contours change together.
 */
export function toggleContour(contours: readonly ListedContour[], isCut: readonly boolean[], contour: number, on: boolean): boolean[] {
  const edges = contours[contour].edges.join();
  return isCut.map((each, i) => (contours[i].edges.join() === edges ? on : each));
}
