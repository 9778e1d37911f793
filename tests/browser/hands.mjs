// tests/browser/hands.mjs: hands on the keyboard alone.

/** What has the focus, as a number that stays with it. */
const focused = (page) =>
  page.evaluate(() => {
    const one = document.activeElement;
    if (!one || one === document.body) return 0;
    window.reached ??= [];
    if (!window.reached.includes(one)) window.reached.push(one);
    return window.reached.indexOf(one) + 1;
  });

/** Presses a key as long as it leads to something else; at most `most` times. */
async function goOn(page, key, most, each = async () => undefined) {
  for (let last = await focused(page), i = 0; i < most; ++i) {
    await each();
    await page.keyboard.press(key);
    const now = await focused(page);
    if (now === last) return;
    last = now;
  }
}

/** With the focus in a group: to every place in it, line by line. */
async function walkGroup(page) {
  await goOn(page, "ArrowUp", 40);
  await goOn(page, "ArrowDown", 40, async () => {
    await page.keyboard.press("Home");
    await goOn(page, "ArrowRight", 40);
    await page.keyboard.press("Home");
  });
}

const inGroup = (page) => page.evaluate(() => document.activeElement?.closest("#bar, .processes, #robots") !== null);

/**
 * Goes to everything that Tab and arrow keys lead to.
 *
 * @return the explanations that were not reached, and the places that had the focus without showing it
 */
export async function walkEverywhere(page) {
  await page.evaluate(() => document.activeElement?.blur());
  const unseen = [];
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press("Tab");
    if ((await focused(page)) === 0) break;
    const fault = await page.evaluate(() => {
      const { outlineStyle, outlineWidth } = getComputedStyle(document.activeElement);
      return outlineStyle === "none" || Number.parseFloat(outlineWidth) < 2 ? document.activeElement.outerHTML.slice(0, 80) : "";
    });
    if (fault) unseen.push(fault);
    if (await inGroup(page)) await walkGroup(page);
  }
  return page.evaluate((hidden) => {
    const missed = [...document.querySelectorAll("[data-why]")].filter((one) => one.dataset.why && one.checkVisibility() && one.tagName !== "LABEL" && !one.disabled && !window.reached.includes(one));
    return { missed: missed.map((one) => one.outerHTML.slice(0, 100)), hidden, reached: window.reached.length };
  }, unseen);
}

/** The words that are shown beside what has the focus. */
export const explanation = (page) => page.evaluate(() => (document.getElementById("why").hidden ? "" : document.getElementById("why").textContent));
