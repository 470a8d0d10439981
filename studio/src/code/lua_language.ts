// Lua with the functions of the library in the colours of their codes.

import { StreamLanguage, type StringStream } from "@codemirror/language";
import { lua } from "@codemirror/legacy-modes/mode/lua";
import type { Dialect } from "./dialect";
import { tokenTable } from "./tokens";

function functionToken(dialect: Dialect, name: string): string | null {
  if (name === "move") return "motion";
  if (/^[FST]$/.test(name)) return "setting";
  const code = dialect.functions.get(name);
  if (!code) return null;
  if (code.code.startsWith("M")) return "mcode";
  return code.group === "motion" || code.group === "canned cycles" ? "motion" : "gcode";
}

export function luaLanguage(dialect: Dialect): StreamLanguage<unknown> {
  return StreamLanguage.define<unknown>({
    ...lua,
    tokenTable,
    token(stream: StringStream, state: unknown) {
      const kind = lua.token(stream, state);
      return functionToken(dialect, stream.current()) ?? kind;
    },
  });
}

export const luaKeywords =
  "and break do else elseif end false for function goto if in local nil not or repeat return then true until while".split(" ");
