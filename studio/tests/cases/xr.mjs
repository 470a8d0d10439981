// Cell in an emulated headset: both eyes, in metres; walking, turning, the clock; and the page afterwards as
// before.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { openPage } from "../browser.mjs";
import { emulateHeadset } from "../emulated_headset.mjs";
import { countPixels, difference, pictureOfView, run, setState, untilSettled, state, withPage } from "../steps.mjs";

const worn = (places, test, argument = {}) => withPage(places.studio, test, { before: { script: emulateHeadset, argument } });
const enterButton = (page) => page.locator("#view").getByRole("button", { name: "Enter VR" });
const leaveButton = (page) => page.locator("#view").getByRole("button", { name: "Leave VR" });

async function enter(page) {
  await enterButton(page).click();
  await leaveButton(page).waitFor();
  await page.waitForFunction(() => document.querySelector("#view .tools > button:last-of-type:not(:disabled)"));
  await show(page, 2);
}

const show = (page, pictures = 1, passed_ms = 10) => page.evaluate(([n, ms]) => window.headset.show(n, ms), [pictures, passed_ms]);
const hold = (page, sticks) => page.evaluate((all) => window.headset.hold(all), sticks);
const press = (page, what) => page.evaluate((name) => window.headset.press(name), what);
const eyes = async (page) => Buffer.from(await page.evaluate(() => window.headset.picture()), "base64");
const isWorn = (page) => page.evaluate(() => window.headset.isOn());

/** Arcs are. */
const GREEN = [1, 100, 40];

/** A post, 0.3 m wide and 1 m high, foremost and lowest of all bodies; the only one that is brown. */
const POST_M = { wide: 0.3, high: 1 };
const AWAY_M = 1.5;
const EYES_M = 0.064;
const post = `[cell]
name = "post"
machine = "samples/machines/router3.toml"

[[object]]
name = "post"
shape = { box_mm = [300.0, 200.0, 1000.0] }
frame = { x_mm = 300.0, y_mm = -1000.0, z_mm = -1000.0 }
`;
const EYE_PX = 1280;
/** An eye sees 90 degrees. */
const FOCUS_PX = EYE_PX / 2;

const runPost = async (page) => {
  const { status } = await run(page, { program: "wait.nc", cell: "post.toml" }, { "post.toml": post, "wait.nc": "G4 P5\nM2\n" });
  assert.equal(status, "completed");
};

/**
 * Returns the position of the post for each eye, px from the middle of its picture to the right and upwards.
 */
const seen = (page) =>
  page.evaluate(() => {
    const { width, height, data } = window.headset.pixels();
    return [0, 1].map((eye) => {
      const box = { left: Infinity, right: -Infinity, top: -Infinity, bottom: Infinity };
      for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width / 2; ++x) {
          const [r, , b] = data.subarray(4 * (y * width + x + (eye * width) / 2));
          if (r - b < 20) continue;
          const [right, up] = [x + 0.5 - width / 4, height / 2 - y - 0.5];
          Object.assign(box, { left: Math.min(box.left, right), right: Math.max(box.right, right) });
          Object.assign(box, { top: Math.max(box.top, up), bottom: Math.min(box.bottom, up) });
        }
      }
      return { ...box, middle: (box.left + box.right) / 2, wide: box.right - box.left + 1 };
    });
  });

const near = (value, expectedValue, most, what) => assert.ok(Math.abs(value - expectedValue) <= most, `${what}: ${value}, not ${expectedValue}`);

/** How far the post is, by how far below eyes 1 m above the floor it ends, and how far to the right of the head, by its left edge; m. */
async function setStandardView(page) {
  const [left, right] = await seen(page);
  const away_m = (-FOCUS_PX * 1) / ((left.bottom + right.bottom) / 2);
  const edge_px = (left.left + right.left) / 2;
  return { away_m, right_m: (edge_px * away_m) / FOCUS_PX + POST_M.wide / 2 };
}

async function assertAsBefore(page, before, most = 0) {
  await enterButton(page).waitFor();
  assert.equal(await isWorn(page), false);
  assert.equal(await page.locator("#view .worn").count(), 0);
  const after = await pictureOfView(page);
  const share = await difference(page, before, after);
  assert.ok(share <= most, `${100 * share} % of the page's picture differ`);
  if (most === 0) assert.ok(before.equals(after), "the page's picture is another one");
}

/** At the machine while it works, with the head bowed. */
async function takePicture(page, file) {
  await setState(page, "time_s", 8);
  await hold(page, { left: [-0.5, -1], right: [0, 0] });
  await show(page, 9, 100);
  await hold(page, {});
  await page.evaluate(() => Object.assign(window.headset.head, { down: 0.6 }));
  await show(page);
  writeFileSync(file, await eyes(page));
  await setState(page, "time_s", 0);
}

/** Entering is refused for a reason, and leaves the page as it was. */
async function assertRefused(page, why) {
  const before = await pictureOfView(page);
  await enterButton(page).click();
  await page.locator("#bar .notice").filter({ hasText: `The headset does not show the cell: ${why}` }).waitFor();
  await setState(page, "notice", ""); // its line takes space
  await assertAsBefore(page, before);
  assert.equal(await enterButton(page).isEnabled(), true);
}

export default {
  "where there is no headset there is no button, and nothing is said": (places) =>
    withPage(places.studio, async (page) => {
      await untilSettled(page);
      assert.equal(await page.getByRole("button", { name: /VR/ }).count(), 0);
      assert.equal(await state(page, "notice"), "");
    }),

  "a page of a finished run has no button for a headset": async (places) => {
    const view = join(dirname(places.studio), "view.html");
    const { page, errors, close } = await openPage(view, { before: { script: emulateHeadset, argument: {} } });
    await page.waitForFunction(() => window.studio);
    assert.equal(await page.evaluate(() => navigator.xr.asked), 0);
    assert.equal(await page.getByRole("button", { name: /VR/ }).count(), 0);
    assert.deepEqual(errors, []);
    await close();
  },

  "both eyes see the cell in metres, from in front of it, on its floor": (places) =>
    worn(
      places,
      async (page) => {
        await runPost(page);
        assert.equal(await page.evaluate(() => navigator.xr.asked), 1);
        // Any pose of the head at the moment when the headset is put on.
        await page.evaluate(() => Object.assign(window.headset.head, { x_m: 0.7, y_m: 1, z_m: -0.4, turn: 2, down: 0.3 }));
        await enter(page);
        await page.evaluate(() => Object.assign(window.headset.head, { down: 0 }));
        await show(page);
        const undrawn = await page.evaluate(() => {
          const { data } = window.headset.pixels();
          let count = 0;
          for (let i = 0; i < data.length; i += 4) if (data[i] === 255 && data[i + 1] === 0 && data[i + 2] === 255) ++count;
          return count;
        });
        assert.equal(undrawn, 0);
        const [left, right] = await seen(page);
        for (const eye of [left, right]) {
          near(eye.wide, (FOCUS_PX * POST_M.wide) / AWAY_M, 2, "width in px");
          near(eye.bottom, (-FOCUS_PX * 1) / AWAY_M, 2, "its lower end, which stands on the floor, 1 m below the eye");
          near(eye.top, (FOCUS_PX * (POST_M.high - 1)) / AWAY_M, 2, "its upper end");
        }
        near(left.middle - right.middle, (FOCUS_PX * EYES_M) / AWAY_M, 1, "parallax in px");
      },
      { width_px: EYE_PX, height_px: EYE_PX },
    ),

  "sticks walk by speed times time and turn in steps, and a squeeze leads back": (places) =>
    worn(
      places,
      async (page) => {
        await runPost(page);
        await page.evaluate(() => Object.assign(window.headset.head, { y_m: 1 }));
        await enter(page);
        const begun = await eyes(page);
        const from = await setStandardView(page);
        near(from.away_m, AWAY_M, 0.03, "away");

        // 1.5 m/s: 0.3 m on in 0.2 s; a stick that is pushed half, half of it.
        await page.evaluate(() => Object.assign(window.headset.head, { down: 0.6 })); // a bowed head walks no slower
        await hold(page, { left: [0, -1], right: [0, 0] });
        await show(page, 20, 10);
        await page.evaluate(() => Object.assign(window.headset.head, { down: 0 }));
        await hold(page, { left: [0, 0.1], right: [0, 0] }); // sticks do not return to 0
        await show(page, 20, 10);
        near((await setStandardView(page)).away_m, from.away_m - 0.3, 0.02, "walked on");
        await hold(page, { left: [0, 0.5], right: [0, 0] });
        await show(page, 40, 10);
        near((await setStandardView(page)).away_m, from.away_m, 0.03, "walked back");
        await hold(page, { left: [1, 0], right: [0, 0] });
        await show(page, 10, 20);
        near((await setStandardView(page)).right_m, from.right_m - 0.3, 0.02, "walked to the right");
        // A headset that showed nothing for a while has not walked meanwhile.
        await show(page, 1, 5000);
        near((await setStandardView(page)).right_m, from.right_m - 0.45, 0.02, "walked for the longest step");

        await press(page, "squeeze");
        await hold(page, { left: [0, 0], right: [0, 0] });
        await show(page);
        assert.equal(await difference(page, begun, await eyes(page)), 0);

        // A push is one step, however long it is held; a body straight ahead moves to the left.
        const required_px = (angle_deg) => -FOCUS_PX * Math.tan((angle_deg * Math.PI) / 180);
        const middle_px = async () => (await seen(page)).reduce((sum, { left, right }) => sum + (left + right) / 4, 0);
        const begun_px = await middle_px();
        await hold(page, { left: [0, 0], right: [1, 0] });
        await show(page, 30);
        near(await middle_px(), begun_px + required_px(30), 0.05 * FOCUS_PX, "turned to the right");
        await hold(page, { left: [0, 0], right: [0, 0] });
        await show(page);
        await hold(page, { left: [0, 0], right: [-1, 0] });
        await show(page);
        assert.ok((await difference(page, begun, await eyes(page))) < 0.001, "turned back");
        // It walks in the direction of the head, also after a rotation in the real space.
        await page.evaluate(() => Object.assign(window.headset.head, { turn: Math.PI / 2 }));
        await hold(page, { left: [0, -1], right: [0, 0] });
        await show(page, 10, 10);
        await page.evaluate(() => Object.assign(window.headset.head, { turn: 0 }));
        await hold(page, { left: [0, 0], right: [0, 0] });
        await show(page);
        near((await setStandardView(page)).right_m, from.right_m + 0.15, 0.02, "walked to the left");
        // One hand does both.
        await press(page, "squeeze");
        await hold(page, { none: [0, -1] });
        await show(page, 21, 10);
        near((await setStandardView(page)).away_m, from.away_m - 0.315, 0.02, "walked with one hand");
      },
      { width_px: EYE_PX, height_px: EYE_PX },
    ),

  "the trigger plays and pauses the page's clock, and the machine moves in both eyes": (places) =>
    worn(places, async (page) => {
      await setState(page, "time_s", 30);
      await setState(page, "rate", 2);
      await enter(page);
      const begun = await eyes(page);
      await press(page, "select");
      await show(page, 50, 20);
      near(await state(page, "time_s"), 32, 1e-6, "the clock");
      await press(page, "select");
      await show(page, 50, 20);
      near(await state(page, "time_s"), 32, 1e-6, "the clock, at rest");
      assert.equal(await state(page, "playing"), false);
      assert.ok((await difference(page, begun, await eyes(page))) > 0.0005);
      // If it continues to play, the window's pictures take over the clock.
      await press(page, "select");
      await show(page);
      await leaveButton(page).click();
      await page.waitForFunction(() => window.studio.store.get("time_s") > 32.3);
    }),

  "beside a page that goes on by itself the headset alone draws, and tells the time": (places) =>
    worn(
      places,
      async (page) => {
        await setState(page, "time_s", 30);
        await untilSettled(page);
        await enter(page);
        const drawn = await page.evaluate(() => window.headset.draws());
        await setState(page, "showRapids", false);
        await setState(page, "time_s", 31);
        await press(page, "select");
        await page.setViewportSize({ width: 1200, height: 760 });
        await page.waitForTimeout(500);
        assert.equal(await page.evaluate(() => window.headset.draws()), drawn);
        assert.equal(await state(page, "time_s"), 31);
        await show(page, 50, 20);
        near(await state(page, "time_s"), 32, 1e-6, "the clock");
      },
      { onDesk: true },
    ),

  "leaving gives the page its picture back, be it the person, the device or an unwilling device that ends it": async (places) => {
    await worn(places, async (page) => {
      await setState(page, "time_s", 60);
      await page.evaluate(() => window.studio.view.orbit(40, 25));
      const before = await pictureOfView(page);
      await enter(page);
      await show(page, 3);
      await page.locator("#view .worn").filter({ hasText: "The headset shows the cell." }).waitFor();
      await leaveButton(page).click();
      await assertAsBefore(page, before);
      const asked = await page.evaluate(() => window.headset.requests());
      await page.waitForTimeout(500);
      assert.equal(await page.evaluate(() => window.headset.requests()), asked, "the page rests where nothing changes");

      await enter(page);
      await hold(page, { left: [1, -1], right: [1, 0] });
      await show(page, 30);
      await page.evaluate(() => window.headset.takeOff());
      await assertAsBefore(page, before);

      // Changes of the page meanwhile are visible afterwards: another size, a click on the path, other
      // colours.
      await enter(page);
      await page.setViewportSize({ width: 1100, height: 700 });
      await page.waitForTimeout(300);
      await show(page, 2);
      await setState(page, "colour", "time");
      await show(page);
      const recoloured = await eyes(page);
      await page.locator("#view .surface").hover();
      await page.waitForTimeout(200);
      await show(page);
      assert.equal(await difference(page, recoloured, await eyes(page)), 0, "looking what is under the pointer disturbs no eye");
      await page.evaluate(() => window.headset.takeOff());
      const after = await pictureOfView(page);
      await page.setViewportSize({ width: 1000, height: 600 });
      await page.setViewportSize({ width: 1100, height: 700 });
      await assertAsBefore(page, after);
    });
    await worn(
      places,
      (page) => assertRefused(page, "no local-floor"),
      { lacksFloor: true },
    );
  },

  "a session that is refused is told in words": (places) =>
    worn(
      places,
      (page) => assertRefused(page, "it is asleep"),
      { refuses: "it is asleep" },
    ),

  "a program that runs meanwhile is in the headset, and in the page as without one": async (places) => {
    const CELL = { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" };
    let expectedValue;
    await withPage(places.studio, async (page) => {
      await run(page, CELL);
      expectedValue = await pictureOfView(page);
    });
    await worn(places, async (page) => {
      await enter(page);
      const before = await eyes(page);
      await run(page, CELL);
      await show(page, 2);
      assert.ok((await difference(page, before, await eyes(page))) > 0.02);
      if (process.env.GSIM_RENEW_PICTURES) await takePicture(page, join(places.samples, "../docs/images/studio-xr.png"));
      await leaveButton(page).click();
      await assertAsBefore(page, expectedValue, 0.0005);
    });
  },

  "devices that take layers show the same, the way too": async (places) => {
    const pictures = [];
    for (const layers of [false, true]) {
      await worn(
        places,
        async (page) => {
          await setState(page, "time_s", 60);
          await enter(page);
          await show(page, 2);
          pictures.push(await eyes(page));
          if (layers) {
            // Smoothed edges have other pixels; a missing path would differ more.
            const share = await difference(page, pictures[0], pictures[1]);
            assert.ok(share < 0.03, `${100 * share} %`);
            const [one, other] = [await countPixels(page, pictures[0], GREEN), await countPixels(page, pictures[1], GREEN)];
            assert.ok(one > 300 && other > 0.7 * one, `${one}, ${other} pixels of the way`);
          }
        },
        { layers },
      );
    }
  },
};
