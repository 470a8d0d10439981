// Forces, power, following and contour errors: charts compared with the trajectory of gsim-run, and the
// positions of their maxima.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { run, setState, untilSettled, state, withPage } from "../steps.mjs";

const MACHINE = "samples/machines/gantry-dynamics.toml";
const setup = { program: "samples/rosette.ngc", machine: MACHINE, dialect: "rs274ngc" };
const docs = (places) => join(places.samples, "../docs/images");

/** Returns a trajectory as rows by the names of its columns; an empty value is missing. */
function trajectory(places, args, step_s) {
  const folder = mkdtempSync(join(tmpdir(), "gsim-drives-"));
  try {
    const csv = join(folder, "t.csv");
    const options = ["--quiet", "--trajectory", csv, "--step", String(step_s), "--forces", "--following"];
    execFileSync(places.gsimRun, [...args, ...options], { cwd: join(places.samples, ".."), stdio: ["ignore", "ignore", "pipe"] });
    const [head, ...lines] = readFileSync(csv, "utf8").trim().split("\n").map((line) => line.split(","));
    return lines.map((values) => Object.fromEntries(head.map((name, i) => [name, values[i] === "" ? NaN : Number(values[i])])));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/**
 * Returns the values of a series at these times, by its channels: "effort0"; `isTold`: the engine has sent
 * that very time.
 */
const seriesAt = (page, kind, times_s) =>
  page.evaluate(
    ([name, all]) => {
      const series = window.studio.store.get("run").robots[0].series.get(name);
      const names = series.channels.map(({ of, axis }) => `${of}${axis ?? ""}`);
      return all.map((t_s) => {
        const values = new Float32Array(series.width);
        series.put(t_s, values);
        const isTold = Math.abs(series.time_s(series.indexAt(t_s + 1e-9)) - t_s) < 2e-9;
        return { isTold, ...Object.fromEntries(names.map((each, i) => [each, values[i]])) };
      });
    },
    [kind, times_s],
  );

const columns = {
  efforts: { effort0: "x_n", effort1: "y_n", effort2: "z_n", power: "power_w" },
  following: { error0: "x_error_mm", error1: "y_error_mm", error2: "z_error_mm", contour: "contour_mm" },
};

/**
 * Max errors of straight lines between instants, as shares of a curve's maximum: the distance of a TCP from
 * its path has corners.
 */
const OFF = { power: 0.003, effort: 0.003, error: 0.002, contour: 0.01 };

/**
 * Compares at instants that the engine has sent, and between them away from jumps, because a rounded time may
 * be on either side of a jump.
 */
function compare(name, rows, column, ours) {
  const expectedValue = rows.map((row) => row[column]);
  const most = Math.max(...expectedValue.filter(Number.isFinite).map(Math.abs));
  let [worst, compared] = [0, 0];
  for (let i = 1; i + 1 < rows.length; ++i) {
    const off = Math.abs(ours[i][name] - expectedValue[i]);
    const around = [expectedValue[i - 1], expectedValue[i], expectedValue[i + 1]];
    if (!(Math.max(...around) - Math.min(...around) < 0.02 * most)) continue;
    if (ours[i].isTold) assert.ok(off <= 1e-6 * most, `${name} is off by ${off} of ${most} at ${rows[i].t_s} s, which is told`);
    worst = Math.max(worst, off);
    ++compared;
  }
  assert.ok(compared > 0.5 * rows.length, `${name}: ${compared} of ${rows.length} compared`);
  assert.ok(worst <= OFF[name.replace(/\d/, "")] * most, `${name} is off by ${worst} of ${most}`);
}

const box = (page, name) => page.locator("#time .chooser").getByRole("checkbox", { name, exact: true });

export default {
  "forces and following errors are those of the trajectory": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, setup);
      const rows = trajectory(places, [setup.program, "--machine", MACHINE, "--dialect", "rs274ngc"], 0.001);
      const times_s = rows.map(({ t_s }) => t_s);
      for (const [kind, of] of Object.entries(columns)) {
        const ours = await seriesAt(page, kind, times_s);
        for (const [name, column] of Object.entries(of)) compare(name, rows, column, ours);
      }
    }),

  "charts of forces and errors are there where the machine tells of masses and servo loops": (places) =>
    withPage(
      places.studio,
      async (page) => {
        assert.ok(await box(page, "Speed and feed").isVisible());
        assert.equal(await box(page, "Forces, torques").isVisible(), false);
        await page.locator("#gallery-button").click();
        await page.getByRole("button", { name: /Forces and following errors/ }).click();
        await page.waitForFunction(() => window.studio.store.get("run")?.robots[0]?.series.size === 2);
        await box(page, "Speed and feed").uncheck();
        await box(page, "Forces, torques").check();
        await box(page, "Following errors").check();
        await box(page, "% of limit").uncheck();
        const chart = (name) => page.getByRole("img", { name, exact: true });
        const { axes } = await page.evaluate(() => window.studio.store.get("run").report.efforts);
        await setState(page, "time_s", axes[0].t_s);
        const [said] = (await chart("Forces, torques").locator(".trace").first().innerText()).match(/-?[\d.]+/);
        assert.ok(Math.abs(Number(said) - axes[0].peak) < 0.01 * Math.abs(axes[0].peak), `${said}, not ${axes[0].peak}`);
        await box(page, "% of limit").check();
        assert.match(await chart("Forces, torques").locator(".trace").first().innerText(), /%/);
        await box(page, "% of limit").uncheck();
        await page.locator("#time .grip").focus();
        for (let i = 0; i < 8; ++i) await page.keyboard.press("ArrowUp");
        await page.locator("#time .grip").blur();
        await page.locator("#side h3", { hasText: "Forces and torques" }).evaluate((heading) => {
          heading.style.scrollMarginTop = "40px"; // clear of the tabs
          heading.scrollIntoView();
        });
        await untilSettled(page);
        if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path: join(docs(places), "studio-forces.png") });
        await setState(page, "theme", "dark");
        await box(page, "Power").check();
        await box(page, "Contour error").check();
        await untilSettled(page);
        if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path: join(places.build, "studio-forces-dark.png") });
        assert.match(await chart("Power").innerText(), /W/);
        assert.match(await chart("Contour error").innerText(), /mm/);
      },
      { width: 1280, height: 800 },
    ),

  "a click on an axis goes to its worst place, and motors that are exceeded are told by line": (places) =>
    withPage(places.studio, async (page) => {
      const weak = readFileSync(join(places.samples, "machines/gantry-dynamics.toml"), "utf8").replace("peak_n = 700.0", "peak_n = 60.0");
      await run(page, { ...setup, machine: "weak.toml" }, { "weak.toml": weak });
      const report = await page.evaluate(() => window.studio.store.get("run").report);
      assert.ok(report.efforts.excess_count > 0);
      await page.getByRole("tab", { name: "Summary" }).click();
      const side = page.locator("#results-panel-summary");
      const went = async (to) => {
        assert.equal(await state(page, "time_s"), to.t_s);
        assert.equal((await state(page, "selection")).line, to.line);
      };
      const section = (title) => side.locator("section").filter({ has: page.getByRole("heading", { name: title, exact: true }) });
      const [, y] = report.efforts.axes;
      await section("Forces and torques").locator("tbody tr").nth(1).click();
      await went(y);
      assert.match(await section("Forces and torques").locator("tbody tr.beyond").first().innerText(), /^Y/);
      await section("Following errors").locator("tbody tr").first().click();
      await went(report.following.axes[0]);
      await section("Following errors").locator(".mark").first().click();
      await went(report.following.contour);
      const [excess] = report.efforts.excesses.filter(({ kind }) => kind === "peak");
      const exceeded = side.locator("section").filter({ has: page.getByRole("heading", { name: /More than the motor can deliver/ }) });
      assert.match(await exceeded.locator(".mark").first().innerText(), /axis Y needs/);
      await exceeded.locator(".mark").first().click();
      await went(excess);
      const said = await side.locator(".mark").allInnerTexts();
      assert.equal(said.filter((text) => text.includes(excess.message) && text.includes(`line ${excess.line}`)).length, 1);
    }),

  "a page of --view has charts of forces, and an engine is not needed for them": async (places) => {
    const folder = mkdtempSync(join(tmpdir(), "gsim-drives-"));
    try {
      const file = join(folder, "view.html");
      const args = [setup.program, "--machine", MACHINE, "--dialect", "rs274ngc", "--quiet", "--view", file];
      execFileSync(places.gsimRun, args, { cwd: join(places.samples, ".."), stdio: ["ignore", "ignore", "pipe"] });
      await withPage(file, async (page) => {
        await box(page, "Power").check();
        const { peak_power_t_s, peak_power_w } = await page.evaluate(() => window.studio.store.get("run").report.efforts);
        await setState(page, "time_s", peak_power_t_s);
        const text = await page.getByRole("img", { name: "Power", exact: true }).innerText();
        assert.ok(Math.abs(Number(text.match(/(-?[\d.]+) W/)[1]) - peak_power_w) < 0.01 * peak_power_w, text);
      });
    } finally {
      rmSync(folder, { recursive: true });
    }
  },
};
