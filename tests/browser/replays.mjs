// tests/browser/replays.mjs: through the time of a recording, by keys and by what a mouse finds.
const BOUND = { timeout: 15_000 };

const expect = (isTrue, what) => {
  if (!isTrue) throw new Error(what);
};

const gameIs = (page, text) => page.waitForFunction((wanted) => document.getElementById("game").textContent === wanted, text, BOUND);

/** Seconds into the recording. */
const shownAt = async (page) => Number((await page.textContent("#position")).split(":")[1]);

/** Stands still at a part of the recording, 0 to 1. */
const scrubTo = (page, part) =>
  page.$eval(
    "#scrub",
    (slider, value) => {
      slider.value = value;
      slider.dispatchEvent(new Event("input"));
    },
    String(1000 * part),
  );

/** Seconds of the recording that go by in one, since it was `start` and `begun` was shown and until `step` is over. */
async function speedOver(page, step, begun, start) {
  await page.waitForFunction((end) => Number(document.getElementById("position").textContent.split(":")[1]) >= end, begun + step, BOUND);
  return (1000 * ((await shownAt(page)) - begun)) / (Date.now() - start);
}

/** From event to event, and where each stands. */
async function jump(page, texts) {
  await scrubTo(page, 0);
  const places = [];
  for (const text of texts) {
    await page.keyboard.press("PageDown");
    await gameIs(page, text);
    places.push(await shownAt(page));
  }
  expect(places.every((at, i) => i === 0 || at > places[i - 1]), `the jumps lead to ${places.join(", ")} s`);
  return places;
}

/** Jumps, leaves stops out and runs at other speeds: a game of six seconds that stands still between its third and its last event. */
export async function goThroughTime(page) {
  const events = await jump(page, ["our kick-off", "running", "stopped", "running"]);
  await page.keyboard.press("PageUp");
  await gameIs(page, "stopped");
  await page.click(".skip");
  await page.selectOption("#timeline select", "0.1");
  await page.keyboard.press(" ");
  await gameIs(page, "running");
  const begun = await shownAt(page);
  expect(begun >= events[3] && begun < events[3] + 0.5, `leaving out the stop from ${events[2]} to ${events[3]} s leads to ${begun} s`);
  const slow = await speedOver(page, 0.25, begun, Date.now());
  expect(slow > 0.05 && slow < 0.3, `at a tenth of the speed ${slow} s go by in a second`);
  await page.click(".skip");
  await scrubTo(page, 0);
  // Until the page shows it, what it showed before would pass for four seconds gone by.
  await page.waitForFunction(() => Number(document.getElementById("position").textContent.split(":")[1]) < 1, undefined, BOUND);
  await page.selectOption("#timeline select", "10");
  const start = Date.now();
  await page.keyboard.press(" ");
  const fast = await speedOver(page, 4, 0, start);
  expect(fast > 2, `at ten times the speed ${fast} s go by in a second`);
}
