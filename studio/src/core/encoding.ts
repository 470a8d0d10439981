// Texts of files: their bytes are decoded, and written back unchanged.

/** Encoding of a file's text, needed to write it back. */
export interface TextFormat {
  encoding: "utf-8" | "windows-1252" | "utf-16le";
  /** True if a byte order mark is in front. */
  hasByteOrderMark: boolean;
  /** Lines end in CR LF. */
  crlf: boolean;
}

const BYTE_ORDER_MARK = "\ufeff";

/**
 * Reads a text. Programs of older controllers use national letters: text that is not UTF-8 is read as
 * windows-1252.
 */
export function readText(bytes: Uint8Array): { text: string; textFormat: TextFormat } {
  const [first, second] = bytes;
  const encoding = first === 0xff && second === 0xfe ? "utf-16le" : isUtf8(bytes) ? "utf-8" : "windows-1252";
  const whole = new TextDecoder(encoding, { ignoreBOM: true }).decode(bytes);
  const hasByteOrderMark = whole.startsWith(BYTE_ORDER_MARK);
  const text = hasByteOrderMark ? whole.slice(1) : whole;
  return { text, textFormat: { encoding, hasByteOrderMark, crlf: text.includes("\r\n") } };
}

function isUtf8(bytes: Uint8Array): boolean {
  try {
    new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    return true;
  } catch {
    return false;
  }
}

/**
 * Returns the bytes of a text in the file's encoding; a letter that the encoding lacks makes the file UTF-8.
 */
export function writeText(text: string, textFormat: TextFormat): Uint8Array<ArrayBuffer> {
  const lines = textFormat.crlf ? text.replace(/\r?\n/g, "\r\n") : text;
  const whole = textFormat.hasByteOrderMark ? BYTE_ORDER_MARK + lines : lines;
  if (textFormat.encoding === "utf-16le") return new Uint8Array(Uint16Array.from(whole, (c) => c.charCodeAt(0)).buffer);
  const narrow = textFormat.encoding === "windows-1252" ? encodeSingleByte(whole) : null;
  return narrow ?? new TextEncoder().encode(whole);
}

function encodeSingleByte(text: string): Uint8Array<ArrayBuffer> | null {
  const codes = new Map<string, number>();
  const all = new TextDecoder("windows-1252").decode(Uint8Array.from({ length: 256 }, (_, code) => code));
  for (let code = 0; code < 256; ++code) codes.set(all[code], code);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) {
    const code = codes.get(text[i]);
    if (code === undefined) return null;
    bytes[i] = code;
  }
  return bytes;
}
