// monitor/web/tests/time.test.ts: going back in time: what is kept of the past, and how it is played.
import { describe, expect, it } from "vitest";
import { History, type Moment, updatesIn } from "../src/history";
import { Player, SPEEDS } from "../src/player";

const moment = (ms: number, more: Partial<Moment> = {}): Moment => ({ ms, bytes: new Uint8Array(10), events: [], running: undefined, ...more });

function historyOf(...moments: Moment[]): History {
  const history = new History({ longestMs: 1000, mostBytes: 1e6, stepMs: 0 });
  for (const one of moments) history.push(one);
  return history;
}

describe("History", () => {
  it("finds the newest moment at or before a time", () => {
    const history = historyOf(moment(100), moment(200), moment(300));

    expect([50, 100, 250, 900].map((ms) => history.indexAt(ms))).toEqual([-1, 0, 1, 2]);
  });

  it("finds events in both directions", () => {
    const history = historyOf(moment(100), moment(200, { events: ["a"] }), moment(300), moment(400, { events: ["b"] }));

    expect(history.eventFrom(0, 1)).toBe(200);
    expect(history.eventFrom(200, 1)).toBe(400);
    expect(history.eventFrom(400, -1)).toBe(200);
    expect(history.eventFrom(200, -1)).toBeUndefined();
  });

  it("keeps what happened even when updates come too close", () => {
    const history = new History({ longestMs: 1000, mostBytes: 1e6, stepMs: 60 });
    for (const one of [moment(0), moment(30), moment(35, { events: ["x"] }), moment(40)]) history.push(one);

    expect(history.length).toBe(2);
    expect(history.eventFrom(0, 1)).toBe(35);
  });

  it("stays within its bytes and begins anew with a station that was started again", () => {
    const history = new History({ longestMs: Infinity, mostBytes: 100, stepMs: 0 });
    for (let ms = 0; ms < 50; ++ms) history.push(moment(ms));
    expect(history.length).toBeLessThanOrEqual(10);

    history.push(moment(3));
    expect(history.length).toBe(1);
  });

  it("leaves out the time in which the game stands", () => {
    const history = historyOf(moment(0, { running: true }), moment(100, { running: false }), moment(200, { running: false }), moment(300, { running: true }));

    expect(history.nextRunning(50)).toBe(50);
    expect(history.nextRunning(150)).toBe(300);
  });

  it("splits a recording, also one that is cut off", () => {
    const body = new Uint8Array([2, 0, 0, 0, 7, 8, 1, 0, 0, 0, 9, 5, 0, 0, 0, 1]);

    expect([...updatesIn(body)].map((part) => [...part])).toEqual([[7, 8], [9]]);
  });
});

describe("Player", () => {
  it("stands still when paused and runs at its speed in replay", () => {
    const player = new Player(historyOf(moment(0), moment(500), moment(1000)), false);
    player.seek(100, 5000);
    expect(player.timeAt(9000)).toBe(100);

    player.speed = 0.5;
    player.play(9000);
    expect(player.timeAt(9200)).toBe(200);
    expect(player.mode).toBe("replay");
  });

  it("skips stopped play, and goes from a tenth to ten times the speed", () => {
    const stop = { running: false };
    const player = new Player(historyOf(moment(0, { running: true }), moment(100, stop), moment(600, stop), moment(700, { running: true }), moment(990)), true);
    player.skipsStops = true;
    player.play(0);
    expect(player.timeAt(150)).toBe(700);

    player.speed = SPEEDS[0]!;
    expect(player.timeAt(650)).toBe(750);
    player.speed = SPEEDS.at(-1)!;
    expect(player.timeAt(660)).toBe(850);
  });

  it("is live again when it has caught up, and never with a recording", () => {
    const history = historyOf(moment(0), moment(1000));
    const live = new Player(history, false);
    live.seek(900, 0);
    live.play(0);
    expect(live.timeAt(500)).toBeUndefined();
    expect(live.mode).toBe("live");

    const recording = new Player(history, true);
    recording.goLive();
    recording.play(0);
    recording.timeAt(5000);
    expect(recording.mode).toBe("paused");
  });

  it("steps from update to update and jumps from event to event", () => {
    const player = new Player(historyOf(moment(0), moment(40), moment(80, { events: ["x"] })), false);
    player.seek(0, 0);
    player.step(1, 0);
    expect(player.timeAt(0)).toBe(40);
    player.jump(1, 0);
    expect(player.timeAt(0)).toBe(80);
    player.step(-1, 0);
    expect(player.timeAt(0)).toBe(40);
  });
});
