// monitor/web/tests/explaining.test.ts: the page by keyboard alone, and where its words stand.
import { describe, expect, it } from "vitest";
import { bubblePlace } from "../src/explainer";
import { stepFrom } from "../src/roving";

describe("arrow keys", () => {
  const counts = [3, 2];

  it("go along a line and from line to line", () => {
    expect(stepFrom({ line: 0, item: 0 }, "ArrowRight", counts)).toEqual({ line: 0, item: 1 });
    expect(stepFrom({ line: 0, item: 1 }, "ArrowDown", counts)).toEqual({ line: 1, item: 1 });
    expect(stepFrom({ line: 1, item: 1 }, "Home", counts)).toEqual({ line: 1, item: 0 });
    expect(stepFrom({ line: 0, item: 0 }, "End", counts)).toEqual({ line: 0, item: 2 });
  });

  it("stay within the group", () => {
    expect(stepFrom({ line: 0, item: 0 }, "ArrowLeft", counts)).toEqual({ line: 0, item: 0 });
    expect(stepFrom({ line: 1, item: 0 }, "ArrowDown", counts)).toEqual({ line: 1, item: 0 });
    expect(stepFrom({ line: 0, item: 2 }, "ArrowDown", counts)).toEqual({ line: 1, item: 1 });
  });

  it("are no others", () => {
    expect(stepFrom({ line: 0, item: 1 }, "x", counts)).toEqual({ line: 0, item: 1 });
  });
});

describe("the bubble", () => {
  const screen = { width: 1000, height: 600 };
  const bubble = { width: 200, height: 50 };

  it("stands above what it explains, in its middle", () => {
    expect(bubblePlace({ left: 400, top: 300, width: 100, height: 20 }, bubble, screen)).toEqual({ left: 350, top: 242 });
  });

  it("stands below where there is no room above", () => {
    expect(bubblePlace({ left: 400, top: 10, width: 100, height: 20 }, bubble, screen).top).toBe(38);
  });

  it("never leaves the window", () => {
    expect(bubblePlace({ left: 980, top: 300, width: 20, height: 20 }, bubble, screen).left).toBe(792);
    expect(bubblePlace({ left: 0, top: 300, width: 20, height: 20 }, bubble, screen).left).toBe(8);
  });
});
