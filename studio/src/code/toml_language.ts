// Colours of files of machines and cells.

import { StreamLanguage } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { tokenTable } from "./tokens";

const kinds: Record<string, string> = { property: "axis", atom: "gcode", bracket: "block" };

export const tomlLanguage = StreamLanguage.define<unknown>({
  ...toml,
  tokenTable,
  token(stream, state) {
    const kind = toml.token(stream, state as never);
    // True and false are atoms, too; tables are in brackets.
    return kind === "atom" && !stream.current().startsWith("[") ? kind : ((kind && kinds[kind]) ?? kind);
  },
});
