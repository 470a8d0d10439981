// Files of machines and cells in the colours of code.

import { StreamLanguage } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { tokenTable } from "./tokens";

const kinds: Record<string, string> = { property: "axis", atom: "gcode", bracket: "block" };

export const tomlLanguage = StreamLanguage.define<unknown>({
  ...toml,
  tokenTable,
  token(stream, state) {
    const kind = toml.token(stream, state as never);
    // Values that are true or false are atoms, too; tables stand in brackets.
    return kind === "atom" && !stream.current().startsWith("[") ? kind : ((kind && kinds[kind]) ?? kind);
  },
});
