// File of variants: setups by name, each with its differences from an empty setup.

import { MAX_OVERRIDE_PERCENT, emptySetup, overrideKeys, type Setup } from "../../../core/setup";
import { FILE_FORMAT, formatError } from "../../../core/file_format";
import { texts } from "../../../texts";

const words = texts.variants.file;


/** Block of a run: that of a line, at the given pass over it, from 1. */
export interface StartBlock {
  file: string;
  line: number;
  pass: number;
}

export interface Variant {
  name: string;
  setup: Setup;
  /** Start of its times; null: the start of the program. */
  from: StartBlock | null;
}

/** Contents of a file, or a message why it cannot be read. */
export type ReadVariants = { variants: Variant[]; error: "" } | { variants: null; error: string };

class VariantsFileError extends Error {}

type Table = Record<string, unknown>;

const isJsonObject = (value: unknown): value is Table => typeof value === "object" && value !== null && !Array.isArray(value);
const isCount = (value: unknown): value is number => Number.isInteger(value) && (value as number) >= 1;

function only(table: Table, known: readonly string[], where: string): void {
  const other = Object.keys(table).find((key) => !known.includes(key));
  if (other !== undefined) throw new VariantsFileError(words.unknownKey(where, other));
}

function readStartBlock(value: unknown, where: string): StartBlock {
  if (!isJsonObject(value)) throw new VariantsFileError(words.wrongFrom(where));
  only(value, ["file", "line", "pass"], `${where}, from`);
  const { file, line, pass = 1 } = value;
  if (typeof file !== "string" || !isCount(line) || !isCount(pass)) throw new VariantsFileError(words.wrongFrom(where));
  return { file, line, pass };
}

function readSetup(values: Table, where: string): Setup {
  const setup = emptySetup();
  const put = setup as unknown as Table;
  for (const [key, value] of Object.entries(values)) {
    if (typeof value !== typeof put[key]) throw new VariantsFileError(words.wrongValue(where, key));
    put[key] = value;
  }
  for (const key of overrideKeys) {
    if (!(setup[key] >= 0 && setup[key] <= MAX_OVERRIDE_PERCENT)) throw new VariantsFileError(words.wrongOverride(where, key, MAX_OVERRIDE_PERCENT));
  }
  return setup;
}

function readVariant(value: unknown, number: number): Variant {
  const where = words.where(number);
  if (!isJsonObject(value)) throw new VariantsFileError(words.noTable(where));
  const { name, from, ...setup } = value;
  only(setup, Object.keys(emptySetup()), where);
  if (typeof name !== "string" || name === "") throw new VariantsFileError(words.noName(where));
  return { name, setup: readSetup(setup, where), from: from === undefined ? null : readStartBlock(from, where) };
}

function read(text: string): Variant[] {
  const value: unknown = JSON.parse(text);
  if (!isJsonObject(value) || !Array.isArray(value.variants)) throw new VariantsFileError(words.noList);
  only(value, ["format", "variants"], words.outermost);
  const otherFormat = formatError(value.format);
  if (otherFormat) throw new VariantsFileError(otherFormat);
  const variants = value.variants.map((each, i) => readVariant(each, i + 1));
  const double = variants.find(({ name }, i) => variants.findIndex((other) => other.name === name) !== i);
  if (double) throw new VariantsFileError(words.twice(double.name));
  return variants;
}

export function readVariants(text: string): ReadVariants {
  try {
    return { variants: read(text), error: "" };
  } catch (error) {
    return { variants: null, error: error instanceof Error ? error.message : String(error) };
  }
}

/** Writes the differences from an empty setup. */
export function writeVariants(variants: readonly Variant[]): string {
  const first = emptySetup() as unknown as Table;
  const tables = variants.map(({ name, setup, from }) => ({
    name,
    ...Object.fromEntries(Object.entries(setup).filter(([key, value]) => value !== first[key])),
    ...(from && { from }),
  }));
  return `${JSON.stringify({ format: FILE_FORMAT, variants: tables }, null, 2)}\n`;
}

/** Returns "a name", or "a name 2" if that is taken. */
export function freeName(name: string, taken: readonly string[]): string {
  let free = name;
  for (let i = 2; taken.includes(free); ++i) free = `${name} ${i}`;
  return free;
}
