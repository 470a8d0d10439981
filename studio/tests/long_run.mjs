// Measures a run of millions of blocks in the page that gsim studio serves: first picture, end, memory, scrubbing, turning.
// Usage: node long_run.mjs BUILD [BLOCKS [PICTURE.png]]. The program is that of `gsim-bench-generate lines BLOCKS`; BUILD has that target, too.

import { execFileSync } from "node:child_process";
import { readdirSync, statSync } from "node:fs";
import { cpus, loadavg, totalmem } from "node:os";
import { join, resolve } from "node:path";
import { ours } from "./memory.mjs";
import { withServed } from "./served.mjs";

const build = resolve(process.argv[2]);
const blocks = Number(process.argv[3] ?? 10_000_000);
const picture = process.argv[4];
const INSTANTS = 40;

const mb = (bytes) => `${(bytes / 1e6).toFixed(0)} MB`;
const seconds = (ms) => `${(ms / 1000).toFixed(1)} s`;
const spread = (times) => {
  const sorted = [...times].sort((a, b) => a - b);
  return `${sorted[sorted.length >> 1].toFixed(0)} ms in the median, ${sorted.at(-1).toFixed(0)} at most of ${sorted.length}`;
};

/**
 * Runs the program, and returns the times (ms) of the first picture, of its end, and of the complete path.
 */
const run = (page) =>
  page.evaluate(async () => {
    const { session, store, view } = window.studio;
    const times = { first: null, longest: 0, whole: null };
    const began = performance.now();
    const frame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    session.change({ program: "sub/long.nc", machine: "samples/machines/af5.toml" });
    const running = session.run().then(() => (times.end = performance.now() - began));
    for (let last = performance.now(); times.whole === null; ) {
      await frame();
      const now = performance.now();
      times.longest = Math.max(times.longest, now - last);
      last = now;
      if (times.first === null && store.get("partialRun") && view.complete()) times.first = now - began;
      if (times.end && view.complete()) times.whole = now - began;
    }
    await running;
    const { report, error, robots } = store.get("run");
    const [{ segments }] = robots;
    return { ...times, status: report?.status, error, blocks: report?.blocks, segments: segments.count, cycle_s: report?.cycle_time_s };
  });

/** Shows instants one by one; returns the time of each until its joints are loaded and drawn. */
const scrub = (page, shares) =>
  page.evaluate(async (all) => {
    const { store } = window.studio;
    const { robots, end_s } = store.get("run");
    const times = [];
    for (const share of all) {
      const began = performance.now();
      store.set("time_s", share * end_s);
      while (!robots[0].joints_at(share * end_s)) await new Promise((done) => setTimeout(done));
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      times.push(performance.now() - began);
    }
    return times;
  }, shares);

const turn = (page) =>
  page.evaluate(async () => {
    const times = [];
    for (let i = 0; i < 15; ++i) {
      const began = performance.now();
      window.studio.view.orbit(6, 1);
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      times.push(performance.now() - began);
    }
    return times;
  });

const complete = (page) => page.waitForFunction(() => window.studio.view.complete(), null, { timeout: 120_000, polling: 50 });

/** The files without a name that the server keeps runs in, in bytes. */
function kept(pid) {
  const files = readdirSync(`/proc/${pid}/fd`).map((fd) => statSync(`/proc/${pid}/fd/${fd}`, { throwIfNoEntry: false }));
  return files.reduce((sum, file) => sum + (file?.isFile() && file.nlink === 0 ? file.size : 0), 0);
}

const text = execFileSync(join(build, "bin/gsim-bench-generate"), ["lines", String(blocks)], { encoding: "latin1", maxBuffer: 1e9 });
const files = { "part.nc": "G21 G90\nG1 X10 F600\nM2\n", "sub/long.nc": text };

await withServed({ build }, files, async (page, served) => {
  console.log(`${cpus().length} x ${cpus()[0].model}, ${mb(totalmem())}, load ${loadavg()[0]}; ${blocks} blocks, ${mb(text.length)}`);
  let engine = 0;
  const watching = setInterval(() => (engine = Math.max(engine, ours("studio-answer")[0]?.peak ?? 0)), 500);
  const ran = await run(page);
  clearInterval(watching);
  console.log(`run: ${JSON.stringify(ran)}`);
  console.log(`first picture ${seconds(ran.first)}, end ${seconds(ran.end)}, whole picture ${seconds(ran.whole)}, longest without a frame ${seconds(ran.longest)}`);
  const [tab] = ours("--type=renderer");
  const [card] = ours("--type=gpu-process");
  console.log(`page ${mb(tab.own)} (peak with what is shared ${mb(tab.peak)}), process of the graphics card ${mb(card.own + card.shared)}`);
  console.log(`engine at most ${mb(engine)}; server ${mb(ours("gsim-serve").concat(ours("gsim-studio"))[0]?.own ?? 0)}, kept ${mb(kept(served.program.pid))}`);
  // Golden section: no two of them near each other.
  const shares = Array.from({ length: INSTANTS }, (_, i) => 0.1 + 0.9 * ((0.5 + i * 0.618034) % 1));
  console.log(`scrubbing, fetched: ${spread(await scrub(page, shares))}`);
  console.log(`scrubbing, kept: ${spread((await scrub(page, shares.slice(-12).concat(shares.slice(-12)))).slice(12))}`);
  if (picture) {
    await complete(page);
    await page.waitForTimeout(500);
    await page.screenshot({ path: picture });
  }
  console.log(`turning: ${spread(await turn(page))}`);
  const rested = performance.now();
  await complete(page);
  console.log(`whole picture behind it: ${seconds(performance.now() - rested)}`);
  console.log(`page behind all that ${mb(ours("--type=renderer")[0].own)}`);
  const again = await run(page);
  console.log(`run again: end ${seconds(again.end)}, page ${mb(ours("--type=renderer")[0].own)}`);
});
