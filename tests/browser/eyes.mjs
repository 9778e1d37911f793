// tests/browser/eyes.mjs: what eyes would say of the page: whether all fits, can be read at 3 m, and stands out.

const fail = (faults) => {
  if (faults.length > 0) throw new Error(faults.join("; "));
};

/** Everything on one screen: nothing to scroll, no panel outside or without size, no word cut off. */
export async function checkLayout(page) {
  fail(
    await page.evaluate(() => {
      const found = [];
      const root = document.documentElement;
      if (root.scrollHeight > innerHeight || root.scrollWidth > innerWidth) found.push("the page scrolls");
      for (const selector of [".bar", ".field", ".ball", ".processes", ".log", ".timeline", ".robots"]) {
        const box = document.querySelector(selector).getBoundingClientRect();
        if (box.width < 50 || box.height < 20) found.push(`${selector} has no size`);
        if (box.right > innerWidth + 1 || box.bottom > innerHeight + 1) found.push(`${selector} sticks out`);
      }
      for (const cell of document.querySelectorAll("tbody td, th, .lamp, .lead b, .lead span, .brand-team, #game, #course, .figure-value, .chips")) {
        if (cell.scrollWidth > cell.clientWidth + 1 && cell.clientWidth > 0) found.push(`"${cell.textContent}" does not fit`);
      }
      return found;
    }),
  );
}

/** The widest words that a place may have to show. */
const WIDEST = {
  "th:nth-child(2)": ["id used twice", "lost 59.9 s", "not heard", "imported"],
  "th:nth-child(3)": ["100 %"],
  "th:nth-child(4)": ["ambiguous ±100 cm", "at −11.1, −8.2 m"],
  "th:nth-child(5)": ["100 %"],
  "th:nth-child(6)": ["sees it"],
  "th:nth-child(7)": ["duplicate id", "no posture", "kidnapped"],
  "th:nth-child(8)": ["9999 posture +", "1.2 M posture +"],
  "th:nth-child(9)": ["1234 / 1234"],
  "th:nth-child(10)": ["30 Hz"],
  "th:nth-child(11)": ["30 Hz"],
  "th:nth-child(12)": ["−86400 s", "−999.9 ms"],
  "th:nth-child(13)": ["24.6 V"],
  "th:nth-child(14)": ["12.3 px"],
  "th:nth-child(15)": ["400 % 100°"],
  "#ball .figure:nth-child(1) .figure-value": ["12.3 m/s"],
  "#ball .figure:nth-child(2) .figure-value": ["−0.12 m"],
  "#ball .figure:nth-child(3) .figure-value": ["999 ms", "59.9 s"],
  "#ball .figure:nth-child(4) .figure-value": ["−10.3, −8.2 m"],
  "#ball .figure:nth-child(5) .figure-value": ["100 %"],
  "#box": ["box 20 Hz", "box away"],
  "#air": ["air 12.34 of 2.2 ↓"],
  "#security": ["security off"],
  "#recorder": ["not recording", "rec 1024 MB", "rec, 9999 lost"],
  "#game": ["before the game", "their free kick"],
  "#course": ["2nd half · FREEKICK theirs · 12.3 s ago"],
  "#leader": ["No fusion leads", "Fusion 16 leads"],
};

/** Every place has room for the widest words that it may have to show. */
export async function checkWidest(page) {
  fail(
    await page.evaluate((widest) => {
      const found = [];
      for (const [selector, texts] of Object.entries(widest)) {
        const head = document.querySelector(selector);
        const place = head.tagName === "TH" ? document.querySelector(selector.replace("th", "tbody td")) : head;
        const words = place.firstElementChild ?? place;
        const before = words.textContent;
        for (const text of texts) {
          words.textContent = text;
          if (place.scrollWidth > place.clientWidth + 1) found.push(`"${text}" does not fit into ${selector}: ${place.scrollWidth} of ${place.clientWidth} px`);
        }
        words.textContent = before;
      }
      return found;
    }, WIDEST),
  );
}

/** What a coach looks for during a game. */
const DECIDES = ["td.decides span", "#score", "#game", "#course", "#box", "#air", "#leader", "#lead-age", "#mark", "#log li span", ".ball .figure-value", ".chip", ".robot .label"];

/**
 * The sizes of the letters that decide, in pixels of the screen, smallest first.
 *
 * On a screen of 24 inches with 1920x1080 a pixel is 0.277 mm; a capital of 22 px letters is 0.73 em = 4.4 mm high, at
 * 3 m 5 minutes of arc: what an eye of normal sight reads.
 */
export const letterSizes = (page) =>
  page.evaluate((selectors) => {
    const sizes = selectors.map((selector) => {
      const all = [...document.querySelectorAll(selector)].filter((one) => one.textContent !== "" || one.tagName === "text");
      const sizeOf = (one) => Number.parseFloat(getComputedStyle(one).fontSize) * (one.getScreenCTM?.().a ?? 1);
      return [selector, all.length === 0 ? 0 : Math.min(...all.map(sizeOf))];
    });
    return sizes.sort((a, b) => a[1] - b[1]);
  }, DECIDES);

/** @param least  pixels */
export async function checkLetters(page, least) {
  const sizes = await letterSizes(page);
  fail(sizes.filter(([, size]) => size < least - 0.05).map(([selector, size]) => `${selector} is written in ${size.toFixed(1)} px, expected ${least} or more`));
  return sizes;
}

/** Every word stands out from its ground by 4.5 to 1, as WCAG asks of letters. */
export async function checkContrast(page) {
  fail(
    await page.evaluate(() => {
      const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
      const rgba = (colour) => {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = colour;
        canvas.fillRect(0, 0, 1, 1);
        const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
        return [r, g, b, a / 255];
      };
      const over = (top, ground) => [0, 1, 2].map((i) => top[3] * top[i] + (1 - top[3]) * ground[i]);
      const groundOf = (element) => {
        if (!element) return [255, 255, 255];
        const style = getComputedStyle(element);
        // The page's own ground is a gradient between two colours that hardly differ.
        if (element === document.body) return over(rgba(style.getPropertyValue("--ground")), [0, 0, 0]);
        const own = rgba(style.backgroundColor);
        return own[3] === 1 ? own : over(own, groundOf(element.parentElement));
      };
      const light = (colour) => {
        const [r, g, b] = colour.map((value) => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const found = new Set();
      for (const element of document.querySelectorAll("body *:not(svg *)")) {
        const has = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim());
        if (!has || element.closest(":disabled, tr.lost, option") || element.checkVisibility?.() === false) continue;
        const ground = groundOf(element);
        const ink = over(rgba(getComputedStyle(element).color), ground);
        const [high, low] = [light(ink), light(ground)].sort((a, b) => b - a);
        const ratio = (high + 0.05) / (low + 0.05);
        if (ratio < 4.5) found.add(`"${element.textContent.trim().slice(0, 20)}" stands out by ${ratio.toFixed(1)} only`);
      }
      return [...found];
    }),
  );
}
