// Numbers, names and kinds of files as people read them.

import assert from "node:assert/strict";

export const modules = ["core/units", "core/display_names", "core/file_kinds", "core/colours", "run/kinds", "run/limits", "time/time_window", "time/mark_text", "texts"];

const mark = { t_s: 1, file: "a.nc", line: 14, kind: "event", text: "jet_on", detail: "", pair: null, clearance_mm: 0 };

export default {
  "lengths have the digits that a control shows": ({ lengthText, lengthNumber, lengthShort, toMm, length }) => {
    assert.equal(lengthText(12.34, "mm"), "12.340 mm");
    assert.equal(lengthText(25.4, "inch"), "1.0000 in");
    assert.equal(lengthNumber(-0.5, "mm"), "-0.500");
    assert.equal(lengthShort(1234.5, "mm"), "1,235 mm");
    assert.equal(lengthShort(12.345, "inch"), "0.486 in");
    assert.equal(toMm(length(7, "inch"), "inch"), 7);
  },

  "axes turn in degrees whatever the unit": ({ axisText }) => {
    assert.equal(axisText(90, true, "inch"), "90.000°");
    assert.equal(axisText(50.8, false, "inch"), "2.0000 in");
  },

  "feeds are per minute, in degrees where the tool takes no way": ({ feedText, programmedFeedText }) => {
    assert.equal(feedText(50, "mm"), "3000 mm/min");
    assert.equal(feedText(0.5, "mm"), "30.0 mm/min");
    assert.equal(feedText(0, "mm"), "0 mm/min");
    assert.equal(feedText(25.4, "inch"), "60.0 in/min");
    assert.equal(programmedFeedText(600, 12, "mm"), "600 mm/min");
    assert.equal(programmedFeedText(600, 0, "inch"), "600 °/min");
  },

  "times are rounded before they are taken apart": ({ timeText, clockText }) => {
    assert.equal(timeText(2.345), "2.345 s");
    assert.equal(timeText(59.9996), "1:00.000");
    assert.equal(timeText(119.9996), "2:00.000");
    assert.equal(timeText(3723.4, 1), "1:02:03.4");
    assert.equal(timeText(3599.99, 1), "1:00:00.0");
    assert.equal(timeText(65, 0), "1:05");
    assert.equal(clockText(83.456), "0:01:23.456");
    assert.equal(clockText(3599.9999), "1:00:00.000");
  },

  "shares have digits that tell small ones apart": ({ percentText, countText }) => {
    assert.deepEqual([percentText(1, 2), percentText(0.0123, 100), percentText(0, 5), percentText(1, 0)], ["50.0", "0.012", "0.0", "0.0"]);
    assert.equal(countText(1234567), "1,234,567");
  },

  "limits are named with their axis, and each has words and a colour": ({ limitText, limitKinds, limitColours, texts }) => {
    assert.equal(limitText({ kind: "joint_speed", letter: "B" }), "speed of B");
    assert.equal(limitText({ kind: "joint_speed", letter: "" }), "speed of an axis");
    assert.equal(limitText({ kind: "acceleration", letter: "Y" }), "acceleration of Y");
    for (const kind of [...limitKinds, "dwell"]) {
      assert.ok(limitText({ kind, letter: "" }) && limitColours[kind] && texts.panels.limitHints[kind], kind);
    }
  },

  "limits of a report are those of segments": ({ limitOfReport }) => {
    assert.deepEqual(limitOfReport("rotary B speed"), { kind: "joint_speed", letter: "B" });
    assert.deepEqual(limitOfReport("joint X acceleration"), { kind: "acceleration", letter: "X" });
    assert.deepEqual(limitOfReport("joint acceleration"), { kind: "acceleration", letter: "" });
    assert.deepEqual(limitOfReport("contour speed"), { kind: "path_speed", letter: "" });
    assert.deepEqual(limitOfReport("look-ahead"), { kind: "look_ahead", letter: "" });
    assert.deepEqual(limitOfReport("rapid override"), { kind: "rapid_override", letter: "" });
    assert.deepEqual(limitOfReport("block time"), { kind: "block_time", letter: "" });
    assert.deepEqual(limitOfReport("braked short"), { kind: "short_brakes", letter: "" });
    assert.deepEqual(limitOfReport("dwell"), { kind: "dwell", letter: "" });
    assert.deepEqual(limitOfReport("toString"), { kind: "unknown", letter: "" });
  },

  "marks are told with their line and kind": ({ markText, fullMarkText }) => {
    assert.equal(markText(mark, "mm"), "jet on");
    assert.equal(fullMarkText(mark, "mm"), "line 14: jet on");
    const close = { ...mark, kind: "near", pair: ["nozzle", "clamp"], clearance_mm: 2.5 };
    assert.equal(fullMarkText({ ...close, line: null }, "mm"), "Near miss: nozzle – clamp: 2.500 mm");
    assert.equal(fullMarkText({ ...mark, kind: "alarm", text: "stopped" }, "mm"), "line 14: Alarm: stopped");
  },

  "files are what their names and beginnings say": ({ kindOfFile, isScript, dialectOfName, baseName }) => {
    const kinds = {
      "a.nc": ["G1 X1", "program"],
      "a.lua": ["program(1)", "program"],
      "machine.toml": ['name = "x"\n[[axis]]\nletter = "X"', "machine"],
      "cell.toml": ['[cell]\nname = "x"', "cell"],
      "robots.toml": ["[[robot]]\nname = 'x'", "robots"],
      "robots-of-own.toml": ["[[axis]]\n[[robot]]", "robots"],
      "notes.toml": ["a = 1", "other"],
      "LINUXCNC.INI": ["[EMC]", "machine"],
      "data.txt": ["; of the control\nNCFILE 1", "machine_data"],
      "part.STL": ["solid", "other"],
      "tool.tbl": ["T1 P1", "other"],
      "part.path.json": ["{}", "path"],
      "plate.JSON": ['{"paths": [{"name": "a", "targets": []}]}', "path"],
      "settings.json": ['{"a": 1}', "other"],
      "plate.svg": ["<svg/>", "drawing"],
      "PLATE.DXF": ["0\nSECTION", "drawing"],
    };
    for (const [name, [text, kind]] of Object.entries(kinds)) {
      assert.equal(kindOfFile(name, text), kind, name);
      assert.equal(kindOfFile(name, new TextEncoder().encode(text)), kind, `${name}, as bytes`);
    }
    // The engine reports the error of a text with NULs; bytes that are not text cannot be run.
    assert.equal(kindOfFile("strange.nc", "\0\u0001"), "program");
    assert.equal(kindOfFile("strange", new Uint8Array([0, 1])), "other");
    assert.deepEqual([isScript("A.LUA"), isScript("lua.nc")], [true, false]);
    assert.deepEqual([dialectOfName("a.NGC"), dialectOfName("a.nc")], ["rs274ngc", ""]);
    assert.deepEqual([baseName("samples/cell/a.nc"), baseName("a.nc")], ["a.nc", "a.nc"]);
  },

  "colours of a scale are within it, and grow lighter": ({ scaleColour }) => {
    const sums = [-1, 0, 0.25, 0.5, 0.75, 1, 2].map((share) => scaleColour(share).reduce((a, b) => a + b));
    assert.equal(sums[0], sums[1]);
    assert.equal(sums[5], sums[6]);
    for (let i = 2; i < 6; ++i) assert.ok(sums[i] > sums[i - 1]);
  },

  "ticks of time are round and about as many as asked for": ({ ticks }) => {
    assert.deepEqual(ticks(0, 10, 5), { at_s: [0, 2, 4, 6, 8, 10], digits: 0 });
    assert.deepEqual(ticks(0, 3600, 8).at_s.slice(0, 3), [0, 600, 1200]);
    assert.equal(ticks(1.23, 1.24, 10).digits, 3);
    assert.deepEqual(ticks(5, 5, 10).at_s, []);
  },

  "a window of time stays within the run": ({ TimeWindow }) => {
    const window = new TimeWindow();
    window.begin(100);
    window.zoom(50, 0.1);
    assert.deepEqual([window.start_s, window.end_s], [45, 55]);
    window.pan(1000);
    assert.deepEqual([window.start_s, window.end_s], [90, 100]);
    window.show(10);
    assert.ok(window.start_s <= 10 && window.end_s >= 10 && Math.abs(window.span_s - 10) < 1e-9);
    window.zoom(10, 1e9);
    assert.equal(window.isComplete, true);
  },
};
