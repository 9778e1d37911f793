// monitor/web/tests/explaining.test.ts: the page by keyboard alone, and where its words stand.
import { describe, expect, it } from "vitest";
import { aimed } from "../src/aim";
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

describe("a place by keys", () => {
  const at = { x: 1, y: 2, theta: 0 };

  it("goes as the screen shows it", () => {
    expect(aimed(at, "ArrowRight", false, false)).toEqual({ x: 1.25, y: 2, theta: 0 });
    expect(aimed(at, "ArrowUp", false, false)).toEqual({ x: 1, y: 2.25, theta: 0 });
    expect(aimed(at, "ArrowRight", false, true)).toEqual({ x: 0.75, y: 2, theta: 0 });
  });

  it("is turned with Shift, counter-clockwise to the left", () => {
    expect(aimed(at, "ArrowLeft", true, false)?.theta).toBeCloseTo(Math.PI / 18);
    expect(aimed(at, "ArrowRight", true, true)?.theta).toBeCloseTo(-Math.PI / 18);
  });

  it("begins anew at the centre mark and knows no other keys", () => {
    expect(aimed(at, "Home", false, false)).toEqual({ x: 0, y: 0, theta: 0 });
    expect(aimed(at, "x", false, false)).toBeUndefined();
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
