// Holds the page's closed forms against the engine's: the axes at each sample of gsim-run --trajectory, within 1e-6 mm and
// degrees, the lines at each event's time, and the time under each limit. Of the golden programs, and of the samples on all sample machines.
// Usage: node exact.mjs BUILD. Closes with "N passed, N failed".

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { loadPage, readRun } from "./frames.mjs";

const TOLERANCE = 1e-6;
const root = fileURLToPath(new URL("../..", import.meta.url));
const gsimRun = join(resolve(process.argv[2] ?? join(root, "build")), "bin/gsim-run");
const scratch = mkdtempSync(join(tmpdir(), "gsim-exact-"));

const dialectOf = (program) => (program.endsWith(".ngc") ? "rs274ngc" : "ab9");
const programsIn = (folder) => readdirSync(folder).filter((name) => /\.(nc|ngc)$/.test(name));

function* goldenRuns() {
  const folder = join(root, "tests/golden");
  for (const name of programsIn(folder)) {
    const conditions = ["--machine-data", "conditions/data.txt", "--setup", `conditions/${dialectOf(name)}.lua`];
    yield { folder, args: [name, "--dialect", dialectOf(name), ...conditions, "--max-blocks", "2000", "--max-steps", "200000"] };
  }
}

function* sampleRuns() {
  const folder = join(root, "samples");
  for (const name of programsIn(folder)) {
    for (const machine of readdirSync(join(folder, "machines"))) {
      yield { folder, args: [name, "--dialect", dialectOf(name), "--machine", `machines/${machine}`] };
    }
  }
  yield { folder, args: ["mill/dome.nc", "--machine", "machines/mill-head-table.toml"], mustRun: true };
  yield { folder, args: ["mill/turntable.nc", "--machine", "machines/mill-table-table.toml"], mustRun: true };
  for (const name of ["left.nc", "clamp.nc"]) yield { folder: join(folder, "cell"), args: [name, "--cell", "table.toml"], mustRun: true };
}

/**
 * Motion that the other sources lack: tools along great circles, uncoordinated rapids, S-curves, TCP control,
 * rounded corners.
 */
const formSources = {
  "great-circle": {
    machine: "af5",
    controller: 'orientation = "great-circle"',
    program: "G21 G90\nG0 X100 Y100 Z100 B10 C20\nG1 X300 Y250 B60 C40 F3000\nG2 X400 Y250 I50 B-30 C-25\nG1 B20 C10\nG1 X10 C0\nM2\n",
  },
  apart: {
    machine: "router3",
    controller: "interpolated_rapids = false",
    program: "G21 G90\nG0 X100 Y20 Z-30\nG0 X5 Y200\nG1 X50 F3000\nG0 X50.5 Z-1\nM2\n",
  },
  "s-curve": {
    machine: "router3",
    controller: 'model = "ab9"\nlimit_jerk = true',
    axis: "max_jerk_mm_s3 = 4000.0",
    program: "G21 G90\nG0 X100 Y20\nG1 X150 Y60 F4000\nG1 X200 Y20\nG2 X240 Y20 I20\nG1 Z-20\nM2\n",
  },
  blend: {
    machine: "router3",
    controller: 'model = "blend"',
    program: "G21 G90\nG64\nG1 X100 F6000\nG1 Y100\nG1 X0\nG3 X50 Y50 I50\nG1 Z-20\nM2\n",
  },
  timed: {
    machine: "router3",
    controller: 'model = "ab9"',
    program: "G21 G90 G93\nG1 X100 F10\nG1 Y50 F20\nG94\nG4 P1\nG1 X0 F3000\nM2\n",
  },
  "block-time": {
    machine: "router3",
    controller: 'model = "ab9"\nblock_time_s = 0.2',
    program: "G21 G90 G64\nG1 X1 F6000\nG1 X2\nG1 X3\nG1 X4\nG1 X5\nM2\n",
  },
  tip: {
    machine: "mill-head-table",
    controller: 'model = "ab9"',
    program: "G21 G90\nG43.4\nG1 X50 Y20 Z30 F2000\nG1 X100 B30 C45\nG1 X0 Y0 B-20 C0\nG49\nM2\n",
  },
};

function* formRuns() {
  for (const [name, form] of Object.entries(formSources)) {
    let machine = readFileSync(join(root, `samples/machines/${form.machine}.toml`), "utf8");
    if (form.axis) machine = machine.replaceAll('kind = "linear"', `kind = "linear"\n${form.axis}`);
    writeFileSync(join(scratch, `${name}.toml`), `${machine}\n[controller]\n${form.controller}\n`);
    writeFileSync(join(scratch, `${name}.nc`), form.program);
    yield { folder: scratch, args: [`${name}.nc`, "--machine", `${name}.toml`], mustRun: true };
  }
}

/**
 * Returns the output of gsim-run; a run that ends beyond limits has its own status, but also writes files.
 */
function written({ folder, args }, options) {
  try {
    execFileSync(gsimRun, [...args, "--quiet", ...options], { cwd: folder, stdio: ["ignore", "ignore", "pipe"] });
  } catch (error) {
    if (error.status !== 1) throw new Error(String(error.stderr));
  }
}

const forms = { arcs: 1 << 3, "great circles of the tool": 1 << 4, "two motions at once": 1 << 5, "axes apart": 1 << 6 };
const seenLimits = new Set();
const seen = Object.fromEntries(Object.keys(forms).map((name) => [name, 0]));

function countForms(robot) {
  for (const chunk of robot.segments.chunks) {
    for (const flags of chunk.flags) {
      for (const [name, bit] of Object.entries(forms)) if (flags & bit) ++seen[name];
    }
  }
}

/** Allows for times that are rounded to 1e-9 s, in which an axis without limits moves far. */
function axesDifference(robot, t_s, values) {
  const differences = [t_s, t_s - 5e-10, t_s + 5e-10].map((time) => {
    return Math.max(...robot.axes_at(time).map((value, i) => Math.abs(value - values[i])));
  });
  return Math.min(...differences);
}

/**
 * Returns the relative difference. Without an acceleration limit the speed jumps, and a rounded time is on
 * either side of the jump.
 */
function speedDifference(segments, t_s, speed_mm_s) {
  const differences = [t_s, t_s - 2e-9, t_s + 2e-9].map((time) => Math.abs(segments.speed_at(time) - speed_mm_s));
  return Math.min(...differences) / Math.max(speed_mm_s, 1);
}

/** Returns the largest difference of an axis from the trajectory, and error messages. */
function compare(page, run, csv) {
  const [head, ...lines] = csv.trim().split("\n");
  const letters = head.split(",").slice(2, -1);
  const robot = run.robots[0];
  let [worst, speedOff] = [0, 0];
  for (const line of lines) {
    const values = line.split(",").map(Number);
    worst = Math.max(worst, axesDifference(robot, values[0], values.slice(2, -1)));
    speedOff = Math.max(speedOff, speedDifference(robot.segments, values[0], values[values.length - 1]));
  }
  countForms(robot);
  const errors = [];
  if (!(worst <= TOLERANCE)) errors.push(`an axis is off by ${worst}`);
  if (!(speedOff <= TOLERANCE)) errors.push(`the speed is off by ${speedOff}`);
  if (letters.length !== robot.scene.axes.length) errors.push(`${letters.length} axes in the trajectory`);
  for (const event of run.report.events ?? []) {
    if (event.line === null) continue;
    const places = run.locationsAt(0, event.t_s);
    if (!places.some((place) => place.line === event.line && place.file === event.file)) {
      errors.push(`at ${event.t_s} s the line of '${event.kind}' should be ${event.line}, not ${JSON.stringify(places)}`);
    }
  }
  errors.push(...limitFaults(page, run));
  return { worst, samples: lines.length, errors };
}

/** The time under each kind of limit as the page names it from the segments, against the report's words for it. */
function limitFaults(page, { robots: [robot], report }) {
  const kinds = new Map();
  const add = ({ kind }, of, time_s) => {
    const times = kinds.get(kind) ?? { segments: 0, report: 0 };
    times[of] += time_s;
    kinds.set(kind, times);
  };
  for (const { count, flags, duration_s } of robot.segments.chunks) {
    for (let i = 0; i < count; ++i) add(page.limitOfFlags(flags[i], robot.letters), "segments", duration_s[i]);
  }
  for (const { limited_by, time_s } of report.time_by_limit) add(page.limitOfReport(limited_by), "report", time_s);
  for (const kind of kinds.keys()) seenLimits.add(kind);
  return [...kinds]
    .filter(([, times]) => Math.abs(times.segments - times.report) > 1e-6 * Math.max(1, times.report))
    .map(([kind, times]) => `${kind}: ${times.segments} s in the segments, ${times.report} s in the report`);
}

let [passed, failed, refused, samples, worst] = [0, 0, 0, 0, 0];
const page = await loadPage();
try {
  for (const run of [...goldenRuns(), ...sampleRuns(), ...formRuns()]) {
    const [html, csv] = [join(scratch, "run.html"), join(scratch, "run.csv")];
    for (const file of [html, csv]) rmSync(file, { force: true });
    try {
      written(run, ["--explain", "--view", html, "--trajectory", csv, "--step", "0.037", "--max-time", "200"]);
      if (!existsSync(html) && run.mustRun) throw new Error("it did not run");
      if (!existsSync(html)) {
        ++refused; // refused before the run: nothing to compare
        continue;
      }
      const found = compare(page, readRun(page, readFileSync(html, "utf8")), readFileSync(csv, "utf8"));
      samples += found.samples;
      worst = Math.max(worst, found.worst);
      if (found.errors.length > 0) throw new Error(found.errors.slice(0, 5).join("\n  "));
      ++passed;
    } catch (error) {
      ++failed;
      console.log(`FAILED gsim-run ${run.args.join(" ")}\n  ${error.message}`);
    }
  }
} finally {
  rmSync(scratch, { recursive: true });
}
for (const kind of page.limitKinds.filter((each) => !seenLimits.has(each))) console.log(`no run is limited by ${kind}`);
for (const kind of ["time", "block_time"].filter((each) => !seenLimits.has(each))) {
  ++failed;
  console.log(`FAILED no run is limited by ${kind}`);
}
for (const [name, count] of Object.entries(seen)) {
  if (count > 0) continue;
  ++failed;
  console.log(`FAILED no run has ${name}`);
}
console.log(`${refused} programs are refused on their machine; ${JSON.stringify(seen)}`);
console.log(`${samples} samples, the axes within ${worst} mm or deg of the trajectory`);
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
