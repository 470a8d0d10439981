// Properties of the languages of part programs, for the page, which works without an engine, too. A dialect
// inherits each property that it does not set from its base.

export interface DialectProperties {
  /** Name for people. */
  title: string;
  /** Other names of controllers with such programs (docs/language.md), in lower case, without blanks, . - and /. */
  controllers: string[];
  /** Extension of programs that the page writes. */
  extension: string;
  /** True if a program with that extension is in this language, if nothing else is set. */
  ownsExtension: boolean;
  /** True if ';' always begins a comment; else a block may follow it. */
  semicolonComments: boolean;
  /** Codes that users define, without rows in the engine's tables; null: none. */
  userCodes: RegExp | null;
}

/** The dialect of programs for which nothing is set. */
export const defaultDialect = "ab9";

const root: DialectProperties = {
  title: "",
  controllers: [],
  extension: ".nc",
  ownsExtension: false,
  semicolonComments: false,
  userCodes: null,
};

/** Differences of each dialect from its base, or from `root`. */
const differences: Record<string, Partial<DialectProperties> & { base?: string }> = {
  ab9: { title: "Allen-Bradley 9/Series" },
  rs274ngc: {
    title: "RS274/NGC (LinuxCNC)",
    controllers: "linuxcnc emc2 machinekit eding fluidnc g2core grbl grblhal mach3 mach4 pathpilot tinyg tormach".split(" "),
    extension: ".ngc",
    ownsExtension: true,
    semicolonComments: true,
    userCodes: /^M1\d\d$/,
  },
  klipper: { title: "Klipper" },
};

/** Returns the properties of a dialect; those of an unknown one are the general ones. */
export function dialectProperties(name: string): DialectProperties {
  const { base, ...changes } = differences[name] ?? {};
  return { ...(base ? dialectProperties(base) : root), ...changes };
}

export const dialectNames: readonly string[] = Object.keys(differences);

/** Titles by name, in the order of a menu. */
export const dialectTitles: Record<string, string> = Object.fromEntries(
  dialectNames.map((name) => [name, dialectProperties(name).title]),
);

/** Returns the language of a controller, by its name or by that of the language. */
export function dialectOfController(control: string): string {
  const plain = control.toLowerCase().replace(/[\s.\-/]/g, "");
  const isNamed = (name: string) => name === plain || (differences[name].controllers ?? []).includes(plain);
  return dialectNames.find(isNamed) ?? defaultDialect;
}

/** Returns the language of programs with this extension (".ngc"); "": no language has it for its programs alone. */
export function dialectOfExtension(extension: string): string {
  const owns = (name: string) => dialectProperties(name).ownsExtension && dialectProperties(name).extension === extension;
  return dialectNames.find(owns) ?? "";
}
