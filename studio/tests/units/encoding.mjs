// Texts of files come back as they were.

import assert from "node:assert/strict";

export const modules = ["core/encoding", "core/documents"];

const open = (documents, name, bytes) => documents.put(name, documents.read(name, bytes));
const bytesOf = (text, encoding = "latin1") => new Uint8Array(Buffer.from(text, encoding));

export default {
  "letters of older controls are read, and saved as they were": (page) => {
    const bytes = bytesOf("(Fr\xe4ser \xd8 10 mm)\r\nG0 X1\r\n");
    const documents = new page.Documents(new Map());
    open(documents, "part.nc", bytes);
    assert.equal(documents.text("part.nc"), "(Fräser Ø 10 mm)\r\nG0 X1\r\n");
    assert.deepEqual(documents.save("part.nc"), bytes);
    assert.equal(documents.unsaved, false);
    documents.put("part.nc", "(Fräser Ø 10 mm)\nG0 X2\n"); // as an editor has lines
    assert.equal(documents.unsaved, true);
    assert.deepEqual(documents.save("part.nc"), bytesOf("(Fr\xe4ser \xd8 10 mm)\r\nG0 X2\r\n"));
    assert.equal(documents.unsaved, false);
  },

  "what is new is unsaved until it is saved, and who listens is told of both": ({ Documents }) => {
    const documents = new Documents(new Map([["sample.nc", "G0\r\n"], ["mesh.stl", bytesOf("\0")]]));
    const told = [];
    documents.on((name) => told.push(name));
    documents.put("sample.nc", "G0\n");
    documents.put("empty.nc", "");
    assert.equal(documents.unsaved, false);
    documents.put("new.txt", "NCFILE\nENDFILE\n");
    documents.put("mesh.stl", "solid");
    assert.deepEqual(documents.userFileNames().map((name) => documents.isUnsaved(name)), [false, false, true, true]);
    assert.deepEqual(documents.save("new.txt"), bytesOf("NCFILE\nENDFILE\n"));
    assert.equal(documents.isUnsaved("new.txt"), false);
    documents.put("new.txt", "NCFILE\n");
    assert.equal(documents.isUnsaved("new.txt"), true);
    assert.deepEqual(told, ["sample.nc", "empty.nc", "new.txt", "mesh.stl", "new.txt", "new.txt"]);
  },

  "UTF-8 and UTF-16 with their marks come back": (page) => {
    for (const [text, encoding] of [["\ufeffG0 X1 (ä)\n", "utf8"], ["\ufeffG0 X1 (ä)\n", "utf16le"]]) {
      const bytes = bytesOf(text, encoding);
      const { text: read, textFormat } = page.readText(bytes);
      assert.equal(read, "G0 X1 (ä)\n");
      assert.deepEqual(page.writeText(read, textFormat), bytes);
    }
  },

  "a letter that the encoding lacks makes the file UTF-8": (page) => {
    const { textFormat } = page.readText(bytesOf("(\xe4)\n"));
    assert.deepEqual(page.writeText("(Ω)\n", textFormat), bytesOf("(Ω)\n", "utf8"));
  },

  "what is no text stays bytes, but a program with a NUL is shown": (page) => {
    const documents = new page.Documents(new Map());
    open(documents, "mesh.stl", bytesOf("solid\0\xff"));
    assert.ok(documents.get("mesh.stl") instanceof Uint8Array);
    open(documents, "nul.nc", bytesOf("G0 X1\0\n"));
    assert.equal(documents.text("nul.nc"), "G0 X1\0\n");
  },
};
