// tests/browser/page.mjs: what a person would do with the page, in headless Chromium.
//
// usage: node page.mjs SCENARIO URL FOLDER, with PAGE_DIR naming where playwright-core is installed.
// One JSON line on stdout per thing seen; exit 0 if all was as it should be, 1 with the reason if not.
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { checkContrast, checkLayout, checkLetters, checkWidest } from "./eyes.mjs";
import { explanation, walkEverywhere } from "./hands.mjs";
import { goThroughTime } from "./replays.mjs";

const { chromium } = createRequire(join(process.env.PAGE_DIR, "package.json"))("playwright-core");
const [scenario, url, folder] = process.argv.slice(2);
const BOUND = { timeout: 15_000 };

const say = (what) => process.stdout.write(`${JSON.stringify(what)}\n`);
const expect = (isTrue, what) => {
  if (!isTrue) throw new Error(what);
};

const positionOf = (page, robot) =>
  page.$eval(`.robot[data-robot="${robot}"]`, (mark) => ({ x: Number(mark.dataset.x), y: Number(mark.dataset.y) }));

const waitForMark = (page, text) =>
  page.waitForFunction((wanted) => document.getElementById("mark").textContent === wanted, text, BOUND);

/** Where the parts of the page lie; these may not move, whatever is in them. */
const placesOf = (page) =>
  page.evaluate(() => {
    const parts = [".brand", "#score", ".game-words", "#box", "#air", "#security", "#recorder", ".lead", ".mark", ".field", ".tabs", "#ball .figures", "#timeline", "#scrub", "#robots", "th:nth-child(4)", "th:last-child"];
    return parts.map((part) => {
      const { x, y, width, height } = document.querySelector(part).getBoundingClientRect();
      return `${part} at ${[x, y, width, height].map(Math.round).join(" ")}`;
    });
  });

async function expectNoJump(page, before, when) {
  const after = await placesOf(page);
  const moved = before.filter((place, i) => place !== after[i]).map((place) => `${place}, then ${after.find((other) => other.startsWith(place.split(" at ")[0] + " at "))}`);
  expect(moved.length === 0, `${when}: ${moved.join("; ")}`);
}

const scenarios = {
  async shows(page) {
    await waitForMark(page, "LIVE");
    for (const robot of [1, 2, 3, 4, 5]) await page.waitForSelector(`.robot.fresh[data-robot="${robot}"]`, BOUND);
    await page.waitForSelector(".ball-mark.fresh .body", BOUND);
    expect((await page.$$(".obstacle")).length === 5, "expected five obstacles");
    const before = await positionOf(page, 2);
    await page.waitForFunction(
      (old) => {
        const mark = document.querySelector('.robot[data-robot="2"]');
        return Math.hypot(Number(mark.dataset.x) - old.x, Number(mark.dataset.y) - old.y) > 0.1;
      },
      before,
      BOUND,
    );
    say({ moved_from: before, to: await positionOf(page, 2) });
    await page.waitForSelector(".robot.quarantined[data-robot=\"4\"]", BOUND);
    await page.waitForFunction(() => document.querySelectorAll("tbody tr.fresh").length === 5, undefined, BOUND);
    const log = await page.textContent("#log");
    const numbers = await page.$$eval(".obstacle .label", (labels) => labels.map((label) => label.textContent).sort().join());
    expect(numbers === "1,2,3,4,5", `the opponents have the numbers ${numbers}`);
    await page.click('tbody tr[data-robot="2"] td:nth-child(4)');
    await page.waitForFunction(() => document.getElementById("why").textContent.includes("line points fit"), undefined, BOUND);
    await page.screenshot({ path: join(folder, "page-told.png") });
    await page.keyboard.press("Escape");
    await page.keyboard.press("1");
    expect(log.includes("Robot 2 joined") && log.includes("leads"), `the log says: ${log}`);
    for (const [width, height] of [[1280, 800], [1920, 1080]]) {
      await page.setViewportSize({ width, height });
      await page.waitForFunction((wanted) => innerWidth === wanted, width, BOUND);
      await checkLayout(page);
      await checkWidest(page);
      await page.screenshot({ path: join(folder, `page-${width}x${height}.png`) });
    }
    say({ letters_px: Object.fromEntries(await checkLetters(page, 22)) });
    for (const theme of ["dark", "light"]) {
      await page.waitForFunction((wanted) => document.documentElement.dataset.theme === wanted, theme, BOUND);
      await checkContrast(page);
      await page.keyboard.press("d");
    }
  },

  async flips(page) {
    await waitForMark(page, "LIVE");
    const place = () => page.$eval('.robot[data-robot="1"]', (mark) => mark.getBoundingClientRect().x);
    await page.waitForSelector('.robot[data-robot="1"]', BOUND);
    const own = await place();
    await page.keyboard.press("f");
    await page.waitForFunction((x) => document.querySelector('.robot[data-robot="1"]').getBoundingClientRect().x > x + 200, own, BOUND);
    await page.click("#flip");
    await page.waitForFunction((x) => Math.abs(document.querySelector('.robot[data-robot="1"]').getBoundingClientRect().x - x) < 60, own, BOUND);
  },

  /** The test kills robot 2 when it reads "ready". */
  async greys(page) {
    await page.waitForSelector('.robot.fresh[data-robot="2"]', BOUND);
    await page.waitForSelector('tbody tr.fresh[data-robot="2"]', BOUND);
    say({ ready: true });
    await page.waitForSelector('.robot.lost[data-robot="2"]', BOUND);
    say({ lost_at_ms: Date.now() });
    await page.waitForSelector('tbody tr.lost[data-robot="2"]', BOUND);
    await page.waitForFunction(() => document.getElementById("log").textContent.includes("Robot 2 is silent"), undefined, BOUND);
    expect(await page.$('.robot.fresh[data-robot="1"], .robot.late[data-robot="1"]'), "robot 1 greyed out as well");
    await page.screenshot({ path: join(folder, "page-silent-robot.png") });
  },

  /** The test ends the station at "live" and starts it again at "gone". */
  async reconnects(page) {
    await waitForMark(page, "LIVE");
    await page.waitForFunction(() => document.getElementById("air").textContent !== "air –", undefined, BOUND);
    const places = await placesOf(page);
    say({ live: true });
    await waitForMark(page, "NO DATA");
    await expectNoJump(page, places, "when the station falls silent");
    await page.waitForFunction(() => document.getElementById("silence").textContent.includes("does not answer"), undefined, BOUND);
    await page.screenshot({ path: join(folder, "page-no-station.png") });
    say({ gone: true });
    await waitForMark(page, "LIVE");
  },

  /** The test starts a process of another version at "nothing_heard". */
  async explains(page) {
    await waitForMark(page, "NO DATA");
    await page.waitForFunction(() => /Nothing heard yet on domain \d+ of team "demo"/.test(document.getElementById("silence").textContent), undefined, BOUND);
    await page.screenshot({ path: join(folder, "page-nothing-heard.png") });
    say({ nothing_heard: true });
    await page.waitForFunction(() => document.getElementById("silence").textContent.includes("somebody speaks v9 of the topics, which this station does not hear"), undefined, BOUND);
    await page.waitForFunction(() => document.getElementById("log").textContent.includes("Somebody here speaks v9"), undefined, BOUND);
    await page.screenshot({ path: join(folder, "page-other-version.png") });
    for (const theme of ["dark", "light"]) {
      await page.waitForFunction((wanted) => document.documentElement.dataset.theme === wanted, theme, BOUND);
      await checkContrast(page);
      await page.keyboard.press("d");
    }
  },
};

/** The test's robots have been told to move; "done" of the page and of the robot are both looked at. */
scenarios.relocates = async (page) => {
  await waitForMark(page, "LIVE");
  await page.click('tbody tr[data-robot="3"]');
  await page.keyboard.press("r");
  await page.keyboard.press("Home");
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowRight");
  for (let i = 0; i < 9; ++i) await page.keyboard.press("Shift+ArrowLeft");
  await page.screenshot({ path: join(folder, "page-aim.png") });
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector(".action.done")?.textContent.includes("relocate robot 3"), undefined, BOUND);
  await page.click('tbody tr[data-robot="2"]');
  await page.click("#relocate");
  const box = await (await page.$("svg.pitch")).boundingBox();
  const [x, y] = [box.x + box.width * 0.5, box.y + box.height * 0.5];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 60, { steps: 4 });
  await page.screenshot({ path: join(folder, "page-relocate.png") });
  await page.mouse.up();
  const done = await page.waitForFunction(() => [...document.querySelectorAll(".action.done")].find((one) => one.textContent.includes("relocate robot 2"))?.textContent, undefined, BOUND);
  say({ relocated: await done.jsonValue() });
  await page.click("#mute");
  await page.waitForFunction(() => document.querySelector('tbody tr[data-robot="2"]').textContent.includes("muted"), undefined, BOUND);
  await page.click("#unmute");
  await page.waitForFunction(() => !document.querySelector('tbody tr[data-robot="2"]').textContent.includes("muted"), undefined, BOUND);
  await page.waitForFunction(() => [...document.querySelectorAll(".action.done")].some((note) => note.textContent.includes("unmute robot 2")), undefined, BOUND);
  await page.click('tbody tr[data-robot="5"]');
  await page.click("#mute");
  await page.waitForSelector(".action.no-answer", BOUND);
  await page.screenshot({ path: join(folder, "page-orders.png") });
  say({ not_answered: await page.textContent(".action.no-answer") });
  await page.keyboard.press("1");
  const places = await placesOf(page);
  await page.keyboard.press("4");
  await page.click('.theirs[data-command="FREEKICK"]');
  await page.click('.ours[data-command="GOAL"]');
  await page.waitForFunction(() => document.getElementById("score").textContent === "1 : 0", undefined, BOUND);
  await page.keyboard.press("1");
  await expectNoJump(page, places, "when the referee speaks");
};

scenarios.hints = async (page) => {
  await waitForMark(page, "LIVE");
  const ball = await (await page.waitForSelector(".ball-mark.fresh .body", BOUND)).boundingBox();
  await page.keyboard.press("h");
  await page.waitForFunction(() => document.getElementById("hint").textContent.startsWith("Click where the ball is"), undefined, BOUND);
  await page.keyboard.press("Escape");
  expect((await page.textContent("#hint")) === "", "Escape did not put the tool away");
  await page.click("#ball-hint");
  await page.mouse.click(ball.x, ball.y);
  await page.waitForSelector(".action.done", BOUND);
  say({ done: await page.textContent(".action.done") });
  await page.waitForSelector(".ball-mark.hinted", BOUND);
  await page.waitForFunction(() => document.querySelector("#ball h2").textContent.includes("by hint"), undefined, BOUND);
  await page.waitForFunction(() => document.getElementById("log").textContent.includes("The ball hint counts"), undefined, BOUND);
  await page.screenshot({ path: join(folder, "page-hint.png") });
  say({ ready: true });
  await page.waitForFunction(() => document.getElementById("silence").textContent.includes("the leading fusion fell silent"), undefined, BOUND);
  await page.click("#ball-hint");
  await page.mouse.click(ball.x, ball.y);
  await page.waitForSelector(".action.no-answer", BOUND);
  say({ not_answered: await page.textContent(".action.no-answer") });
};

/** Nothing but keys: every explanation is reached, and shown. */
scenarios.types = async (page) => {
  await page.waitForSelector('.robot.quarantined[data-robot="4"]', BOUND);
  await page.waitForSelector(".process", BOUND);
  const { missed, hidden, reached } = await walkEverywhere(page);
  expect(missed.length === 0, `no key leads to ${missed.join("; ")}`);
  expect(hidden.length === 0, `the focus is not seen on ${hidden.join("; ")}`);
  say({ reached });
  await page.focus('#robots [tabindex="0"]');
  await page.keyboard.press("Home");
  for (let i = 0; i < 6; ++i) await page.keyboard.press("ArrowUp");
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowDown");
  for (let i = 0; i < 6; ++i) await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => document.getElementById("why").textContent.startsWith("In quarantine: what it sees lies aside"), undefined, BOUND);
  expect((await explanation(page)) !== "", "the explanation is hidden");
  await page.screenshot({ path: join(folder, "page-explained.png") });
  await page.keyboard.press("Escape");
  expect((await explanation(page)) === "", "Escape did not take the explanation away");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector("#robot h2").textContent === "Robot 4" && !document.getElementById("robot").hidden, undefined, BOUND);
  await page.keyboard.press("?");
  await page.waitForSelector("#keys-dialog[open]", BOUND);
  await page.screenshot({ path: join(folder, "page-keys.png") });
  await page.keyboard.press("Escape");
  await page.waitForSelector("#keys-dialog:not([open])", { ...BOUND, state: "attached" });
};

/** The test starts a second station at "alone" and ends it at "two". */
scenarios.shares = async (page) => {
  await waitForMark(page, "LIVE");
  const noticeSays = (text) => page.waitForFunction((wanted) => document.getElementById("notice").textContent === wanted, text, BOUND);
  await noticeSays("");
  const places = await placesOf(page);
  say({ alone: true });
  await noticeSays("2 coach stations are here: the newest order counts, none tells the game yet");
  await expectNoJump(page, places, "when another station comes");
  await page.keyboard.press("4");
  await page.click('[data-command="START"]');
  await noticeSays("2 coach stations are here: the newest order counts, the game comes from this one");
  const other = await page.context().newPage();
  await other.goto(process.env.OTHER);
  await other.waitForFunction(() => document.getElementById("notice").textContent === "2 coach stations are here: the newest order counts, the game comes from the other", undefined, BOUND);
  await other.screenshot({ path: join(folder, "page-two-stations.png") });
  say({ two: true });
  await noticeSays("");
};

const logSays = (page, text) => page.waitForFunction((wanted) => document.getElementById("log").textContent.includes(wanted), text, BOUND);

scenarios.scrubs = async (page) => {
  await waitForMark(page, "LIVE");
  await page.keyboard.press("b");
  await logSays(page, "Bookmark");
  await page.waitForSelector('.robot.fresh[data-robot="2"]', BOUND);
  const then = await positionOf(page, 2);
  const far = (old) => {
    const mark = document.querySelector('.robot[data-robot="2"]');
    return Math.hypot(Number(mark.dataset.x) - old.x, Number(mark.dataset.y) - old.y) > 0.8;
  };
  await page.waitForFunction(far, then, BOUND);
  await page.keyboard.press(" ");
  await waitForMark(page, "PAUSED");
  const paused = await positionOf(page, 2);
  await page.waitForTimeout(300);
  const still = await positionOf(page, 2);
  expect(still.x === paused.x && still.y === paused.y, "a paused page moves");
  await page.$eval("#scrub", (slider) => {
    slider.value = "0";
    slider.dispatchEvent(new Event("input"));
  });
  await page.waitForFunction(far, paused, BOUND);
  expect((await page.textContent("#position")).startsWith("−"), "the page does not say how far back it is");
  await page.keyboard.press("l");
  await waitForMark(page, "LIVE");
  await page.keyboard.press("PageUp");
  await waitForMark(page, "PAUSED");
  await page.waitForFunction(() => document.querySelector("#log li").querySelector("span").textContent === "Bookmark", undefined, BOUND);
  await page.screenshot({ path: join(folder, "page-paused.png") });
  await page.keyboard.press(" ");
  await waitForMark(page, "REPLAY");
  await page.keyboard.press("l");
  await waitForMark(page, "LIVE");
};

scenarios.replays = async (page) => {
  await waitForMark(page, "REPLAY");
  await page.waitForSelector('.robot[data-robot="2"]', BOUND);
  await page.waitForSelector(".ball-mark .body", BOUND);
  await page.keyboard.press("b");
  await page.waitForFunction(() => document.querySelector(".action.refused")?.textContent.startsWith("This is a recording"), undefined, BOUND);
  await page.selectOption("#timeline select", "0.1");
  await page.click(".skip input");
  await page.keyboard.press("+");
  await page.waitForFunction(() => document.querySelector("#timeline select").value === "0.25", undefined, BOUND);
  await page.selectOption("#timeline select", "2");
  await waitForMark(page, "PAUSED");
  expect((await page.textContent("#position")) > "00:00.5", "the recording did not run");
  const end = await positionOf(page, 2);
  for (let i = 0; i < 12; ++i) await page.keyboard.press(",");
  await page.waitForFunction(
    (old) => {
      const mark = document.querySelector('.robot[data-robot="2"]');
      return Math.hypot(Number(mark.dataset.x) - old.x, Number(mark.dataset.y) - old.y) > 0.02;
    },
    end,
    BOUND,
  );
  await page.screenshot({ path: join(folder, "page-replay.png") });
};

/** A game that another program recorded: places, and nothing that nobody measured. */
scenarios.imports = async (page) => {
  await page.route("**/recording.bin*", (route) => route.fulfill({ status: 503 }));
  await page.reload();
  await page.waitForFunction(() => /recording does not arrive.*503/.test(document.getElementById("silence").textContent), undefined, BOUND);
  await page.screenshot({ path: join(folder, "page-no-recording.png") });
  await page.unroute("**/recording.bin*");
  complaints.length = 0; // of the browser, about the answer 503
  await waitForMark(page, "REPLAY");
  await page.waitForSelector('.robot[data-robot="2"]', BOUND);
  await goThroughTime(page);
  expect((await page.textContent("#leader")) === "Imported", "a fusion is said to lead");
  const row = await page.$$eval('tbody tr[data-robot="2"] td', (cells) => cells.map((one) => one.textContent));
  expect(row[1] === "imported" && /^at [34]\.\d, −1\.0 m$/.test(row[3]) && row.slice(4).every((text) => text === "–"), `robot 2 is said to be ${row.join(", ")}`);
  const drawn = await page.$$eval(".robot .spread, .obstacle .spread", (marks) => marks.filter((mark) => mark.getAttribute("visibility") === "visible").length);
  expect(drawn === 0, "uncertainties are drawn that nobody measured");
  expect((await page.$$(".trail")).length === 0 && (await page.textContent(".obstacle .label")) === "", "opponents are followed that have no ids");
  await checkLayout(page);
  await page.screenshot({ path: join(folder, "page-imported.png") });
};

/** What the page says about itself, for who reads why a test failed. */
const shown = () =>
  browser.pages().at(-1).evaluate(() => ["mark", "silence", "game", "position"].map((id) => `${id}: ${document.getElementById(id)?.textContent ?? "not there"}`).join(", ")).catch((error) => error.message);

/** The test puts the token into the address's fragment, which this scenario takes away first. */
scenarios.asks = async (page) => {
  await page.waitForSelector("#token-dialog[open]", BOUND);
  expect(await page.$eval("#mark", (mark) => mark.textContent === "NO DATA"), "something is shown without the token");
  await page.fill("#token", process.env.TOKEN);
  await page.keyboard.press("Enter");
  await waitForMark(page, "LIVE");
};

/** Second level, for the eyes. */
scenarios.looks = async (page) => {
  await page.setViewportSize({ width: 1920, height: 1080 });
  await waitForMark(page, "LIVE");
  await page.waitForSelector('.robot.fresh[data-robot="5"]', BOUND);
  await page.keyboard.press("v");
  await page.keyboard.press("2");
  await page.waitForSelector(".raw .ray", BOUND);
  await page.click('tbody tr[data-robot="4"]');
  await page.waitForFunction(() => /quarantine: what it sees lies aside.*sightings fitted nothing/.test(document.querySelector(".robot-facts").textContent), undefined, BOUND);
  await page.screenshot({ path: join(folder, "page-quarantine.png") });
  await page.click('tbody tr[data-robot="1"]');
  await page.screenshot({ path: join(folder, "page-robot.png") });
  await page.click("#camera");
  await page.waitForSelector(".sensor.triggered", BOUND);
  await page.waitForFunction(() => document.querySelector(".thumbnail").naturalWidth === 64, undefined, BOUND);
  await page.click("#without");
  await page.waitForSelector(".without.ball", BOUND);
  await page.waitForTimeout(2500);
  await page.screenshot({ path: join(folder, "page-without.png") });
  await page.click("#without");
  await page.keyboard.press("3");
  await page.waitForTimeout(2500);
  await page.screenshot({ path: join(folder, "page-plots.png") });
  await page.keyboard.press("d");
  await page.keyboard.press("4");
  await page.click('.ours[data-command="KICKOFF"]');
  await page.waitForFunction(() => document.getElementById("game").textContent === "our kick-off", undefined, BOUND);
  for (const tab of ["1", "2", "3", "4"]) {
    await page.keyboard.press(tab);
    await checkContrast(page);
  }
  await page.screenshot({ path: join(folder, "page-light.png") });
};

const profile = mkdtempSync(join(tmpdir(), "teamsight-chromium-"));
const complaints = [];
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: "/usr/bin/chromium",
  headless: true,
  viewport: { width: 1280, height: 800 },
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
try {
  const page = await browser.newPage();
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => {
    // A station that is away is not the page's fault.
    if (message.type() === "error" && !message.text().includes("WebSocket")) complaints.push(message.text());
  });
  await page.goto(url);
  await scenarios[scenario](page);
  expect(complaints.length === 0, `the page complains: ${complaints.join("; ")}`);
} catch (error) {
  process.stderr.write(`${scenario}: ${[error.stack, ...complaints, await shown()].join("\n")}\n`);
  process.exitCode = 1;
} finally {
  await browser.close();
  rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
}
