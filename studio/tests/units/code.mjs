// Data that the editor derives from G-code text: words, modal state, comments, dialects, own Lua code.

import assert from "node:assert/strict";

export const modules = [
  ...["code/words", "code/modal", "code/comments", "code/dialect", "code/editor_file", "code/findings", "code/edited_translations", "code/text_change"],
  ...["core/documents", "@codemirror/state"],
];

const code = (name, group, more = {}) => ({ code: name, lua: name.replace(".", "_"), meaning: name, group, words: "", axes: false, supported: true, ...more });
const language = {
  name: "ab9",
  title: "Allen-Bradley 9/Series",
  initial: "G0 G90",
  letters: { "X Y Z": "axes", F: "feed" },
  codes: [code("G0", "motion"), code("G1", "motion"), code("G90", "distance"), code("G91", "distance"), code("G4", null), code("G92.1", "offset"), code("M98", "subprograms"), code("M8", "coolant")],
};

const named = (words) => words.map(({ letter, number }) => letter + number);

/** Returns a program after toggling its lines from `from` to `to` (counted from 1, none selected: one). */
function toggled({ EditorState, EditorSelection, toggleLineComment }, isNgc, text, from = 1, to = from) {
  let state = EditorState.create({ doc: text });
  const { doc } = state;
  state = state.update({ selection: EditorSelection.range(doc.line(from).from, doc.line(to).to) }).state;
  toggleLineComment(isNgc)({ state, dispatch: (transaction) => (state = transaction.state) });
  return state.doc.toString();
}

const sessionOf = (setup, texts = {}) => ({ setup: { dialect: "", machine: "", ...setup }, documents: { text: (name) => texts[name] ?? "" } });

export default {
  "words are letters with their numbers, wherever blanks stand": ({ parseWords }) => {
    assert.deepEqual(named(parseWords("n10g1 x-1.5Y+.5 z 3. f1000", false)), ["N10", "G1", "X-1.5", "Y+.5", "Z3.", "F1000"]);
    const [g, x] = parseWords("G01 X5", false);
    assert.deepEqual([g.from, g.to, x.from, x.to], [0, 3, 4, 6]);
  },

  "comments, names and expressions are no words": ({ parseWords }) => {
    assert.deepEqual(named(parseWords("G1 (X1 Y2) X3 ; Y4", true)), ["G1", "X3"]);
    assert.deepEqual(named(parseWords("G1 X[#<depth> * 2] Y#5 (open X7", true)).slice(0, 3), ["G1", "X", "Y"]);
    assert.deepEqual(named(parseWords("WHILE [#1 LT 5] DO1", false)).filter((word) => word !== "#"), []);
  },

  "in the 9/Series a block may stand behind a semicolon": ({ parseWords, withoutComments }) => {
    assert.deepEqual(named(parseWords("G1 X1; G4 P1", false)), ["G1", "X1", "G4", "P1"]);
    assert.deepEqual(named(parseWords("G1 X1; G4 P1", true)), ["G1", "X1"]);
    assert.deepEqual(named(parseWords("G1 X1; go on", false)), ["G1", "X1"]);
    assert.equal(withoutComments("G1 (a) X1", false), "G1     X1");
  },

  "corners and angles of the 9/Series are words of their own": ({ parseWords }) => {
    assert.deepEqual(named(parseWords("G1 X1 ,C2 AR=5", false)), ["G1", "X1", ",C2", "AR=5"]);
  },

  "codes have one name however they are written": ({ codeName }) => {
    assert.deepEqual([codeName("g", "01"), codeName("G", "92.1"), codeName("G", "59.10")], ["G1", "G92.1", "G59.1"]);
  },

  "what is in force at a line is the last of each group": async ({ ModalIndex, Dialect, Text }) => {
    const index = new ModalIndex(new Dialect("ab9", language));
    const doc = Text.of(["G1 X1 F100", "G4 P1 (G91)", "G91 M8", "G0 S5"]);
    const at = async (line) => {
      const { codes, words } = await index.at(doc, line, () => false);
      return [[...codes.values()].sort().join(" "), [...words].join(" ")];
    };
    assert.deepEqual(await at(0), ["G0 G90", ""]);
    assert.deepEqual(await at(2), ["G1 G90", "F,100"]);
    assert.deepEqual(await at(4), ["G0 G91 M8", "F,100 S,5"]);
  },

  "far down a long program, and after a change there": async ({ ModalIndex, Dialect, Text }) => {
    const lines = Array.from({ length: 25_000 }, (_, i) => `X${i}`);
    lines[4] = "G1 F5";
    lines[12_000] = "G91";
    const index = new ModalIndex(new Dialect("ab9", language));
    const motion = async (line) => [...(await index.at(Text.of(lines), line, () => false)).codes.values()].sort().join(" ");
    assert.equal(await motion(24_999), "G1 G91");
    assert.equal(await motion(12_000), "G1 G90");
    lines[12_000] = "G0";
    index.changed(12_001);
    assert.equal(await motion(24_999), "G0 G90");
    assert.equal(await new ModalIndex(new Dialect("ab9", language)).at(Text.of(lines), 24_999, () => true), null);
  },

  "subprograms and loops are known to make the text say less": async ({ ModalIndex, Dialect, Text }) => {
    const jumps = async (...lines) => (await new ModalIndex(new Dialect("ab9", language)).at(Text.of(lines), 1, () => false)).jumps;
    assert.equal(await jumps("O100", "G1 X1"), false);
    assert.equal(await jumps("G1 X1", "M98 P100"), true);
    assert.equal(await jumps("G1 X1 (M98)"), false);
    assert.equal(await jumps("WHILE [#1 LT 3] DO1"), true);
  },

  "lines become remarks and blocks again": (page) => {
    assert.equal(toggled(page, true, "  G1 X1\n\nG0", 1, 3), ";   G1 X1\n\n; G0");
    assert.equal(toggled(page, true, ";   G1 X1\n\n; G0", 1, 3), "  G1 X1\n\nG0");
    const program = "G1 X1 (go)\n(all)";
    assert.equal(toggled(page, false, program), "(G1 X1 {go})\n(all)");
    assert.equal(toggled(page, false, "(G1 X1 {go})"), "G1 X1 (go)");
    // A part that is already a comment stays one; one that only begins and ends like a comment is none.
    assert.equal(toggled(page, false, program, 1, 2), "(G1 X1 {go})\n(all)");
    assert.equal(toggled(page, false, "(A) G1 (B)"), "({A} G1 {B})");
  },

  "a program's dialect is the setup's, the machine's, or its name's": ({ dialectName, needsDialectSetting }) => {
    assert.equal(dialectName(sessionOf({}), "a.nc"), "ab9");
    assert.equal(dialectName(sessionOf({}), "a.NGC"), "rs274ngc");
    assert.equal(dialectName(sessionOf({ dialect: "ab9" }), "a.ngc"), "ab9");
    const machine = sessionOf({ machine: "m.toml" }, { "m.toml": "[controller]\n  dialect = 'Linux CNC'" });
    assert.equal(dialectName(machine, "a.nc"), "rs274ngc");
    assert.deepEqual([needsDialectSetting(sessionOf({}), "a.ngc"), needsDialectSetting(machine, "a.ngc"), needsDialectSetting(sessionOf({}), "a.nc")], [true, false, false]);
  },

  "what no table has is unknown, but for a user's own M codes": ({ Dialect }) => {
    const [ab9, ngc] = [new Dialect("ab9", language), new Dialect("rs274ngc", { ...language, name: "rs274ngc" })];
    assert.deepEqual([ab9.isUnknown("G1"), ab9.isUnknown("G999"), ab9.isUnknown("M101"), ngc.isUnknown("M101")], [false, true, true, false]);
    assert.equal(new Dialect("ab9", null).isUnknown("G999"), false, "without tables nothing is known");
    assert.equal(new Dialect("rs274ngc", null).title, "RS274/NGC (LinuxCNC)");
  },

  "lines of a run are found again in a text that has been edited": ({ EditorFile, EditorState }) => {
    const editorFile = new EditorFile("a.nc", EditorState.create({ doc: "one\ntwo\nthree\n" }));
    const edit = (from, to, insert) => {
      const { state, changes } = editorFile.state.update({ changes: { from, to, insert } });
      editorFile.state = state;
      editorFile.changed(changes.desc);
    };
    edit(4, 4, "new\n");
    assert.deepEqual([1, 2, 3].map((line) => editorFile.fromRunLine(line)), [1, 3, 4]);
    assert.deepEqual([1, 2, 3, 4].map((line) => editorFile.toRunLine(line)), [1, 0, 2, 3]);
    assert.deepEqual([editorFile.isModified, editorFile.isChangedSinceRun, editorFile.isEditedSinceRun(1), editorFile.isEditedSinceRun(3)], [true, true, false, false]);
    editorFile.beginRun();
    edit(0, 0, "more\n");
    editorFile.endRun(true);
    assert.deepEqual([1, 2].map((line) => editorFile.fromRunLine(line)), [2, 3]);
    // One that had been made before is shown while its texts are what they were.
    editorFile.endRun(false);
    assert.deepEqual([1, 2].map((line) => editorFile.fromRunLine(line)), [1, 2]);
    assert.equal(editorFile.isChangedSinceRun, false);
  },

  "findings of a file are told once, of a run those of all its robots": ({ fileFindings, runFindings, toDiagnostic, Text }) => {
    const at = (line, text, more = {}) => ({ file: "a.nc", line, text, ...more });
    const all = [[at(2, "no such code"), "error"], [at(2, "code"), "warning"], [at(null, "x"), "error"], [{ ...at(3, "x"), file: "b.nc" }, "error"]];
    assert.deepEqual(fileFindings("a.nc", all).map(({ line, severity }) => [line, severity]), [[2, "error"]]);
    const told = [at(1, "slow", { severity: "note" }), { ...at(1, "x", { severity: "error" }), file: "b.nc" }];
    const run = { diagnostics: told, report: { robots: [{ diagnostics: [at(4, "they meet", { severity: "warning" })] }] } };
    assert.deepEqual(runFindings(run, "a.nc").map(({ line, severity }) => [line, severity]), [[1, "note"], [4, "warning"]]);
    const mark = toDiagnostic(Text.of(["G1", "G0 G999 X1"]), { ...all[0][0], severity: "error", code: "", hint: "", column: 4, end_column: 8 }, 2);
    assert.deepEqual([mark.from, mark.to], [6, 10]);
  },

  "a text is edited until it is as it was kept last": ({ EditorFile, EditorState }) => {
    const editorFile = new EditorFile("a.nc", EditorState.create({ doc: "one" }));
    const put = (text) => (editorFile.state = editorFile.state.update({ changes: { from: 0, to: editorFile.doc.length, insert: text } }).state);
    assert.equal(editorFile.isModified, false);
    put("two");
    assert.equal(editorFile.isModified, true);
    editorFile.saved();
    assert.equal(editorFile.isModified, false);
    put("one");
    assert.equal(editorFile.isModified, true);
  },

  "of another text the least is changed, whatever ends its lines": ({ textChange, Text }) => {
    const changed = (before, after) => textChange(Text.of(before.split("\n")), after);
    assert.equal(changed("a\nb", "a\r\nb"), null);
    assert.deepEqual(changed("G1 X10\nG1 Y2", "G1 X15\nG1 Y2"), { from: 5, to: 6, insert: "5" });
    assert.deepEqual(changed("aa", "aaa"), { from: 2, to: 2, insert: "a" });
    assert.deepEqual(changed("aaa", "aa"), { from: 2, to: 3, insert: "" });
    assert.deepEqual(changed("", "x"), { from: 0, to: 0, insert: "x" });
    assert.deepEqual(changed("x", ""), { from: 0, to: 1, insert: "" });
  },

  "Lua of one's own gets a name that is free": ({ EditedTranslations, Documents }) => {
    const documents = new Documents(new Map([["a.lua", "of somebody"]]));
    const own = new EditedTranslations(documents);
    const mark = "-- from a.nc; line n there is line n+1 here; hash 12ab";
    assert.deepEqual(own.make("a.nc", mark), { name: "a-2.lua", script: "-- from a.nc" });
    documents.put("a-2.lua", "-- from a.nc");
    assert.equal(own.make("a.nc", mark).name, "a-2.lua", "the same text again");
    assert.equal(own.make("a.nc", `${mark}\nG1{}`).name, "a-3.lua");
    assert.deepEqual([own.sourceProgram("a-3.lua"), own.sourceProgram("a.lua")], ["a.nc", undefined]);
  },
};
