// monitor/web/tests/page.test.ts: the parts of the page that compute.
import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { liveAddress, pauseBefore } from "../src/connection";
import { ellipseOf } from "../src/ellipse";
import * as format from "../src/format";
import { MonitorUpdateSchema, RobotRowSchema } from "../src/generated/monitor_pb";
import { PostureStatus, WorldTeammateSchema } from "../src/generated/recording_pb";
import { isTaken } from "../src/keys";
import { OpponentNumbers } from "../src/opponent_numbers";
import { difference, rayEnd, toField } from "../src/raw_layer";
import { headingOf } from "../src/relocate";
import { bitRate, commandText, courseText, gameText, isSecured, thriftText } from "../src/referee_view";
import { isImported, markOf, noticeOf, sceneOf } from "../src/scene";
import { cameraCell, COLUMNS, halfCell, linkCell, loadCell, placeCell, postureCell, rejectedCell, rejectedText, rowsOf, trustCell } from "../src/robot_cells";
import { leaderText } from "../src/side_view";
import { View } from "../src/view";
import { withoutText } from "../src/without_layer";

describe("ellipseOf", () => {
  it("takes the axes from a diagonal covariance", () => {
    const ellipse = ellipseOf(4, 0, 1)!;

    expect(ellipse.major).toBeCloseTo(2 * Math.sqrt(5.991), 9);
    expect(ellipse.minor).toBeCloseTo(Math.sqrt(5.991), 9);
    expect(ellipse.angle).toBeCloseTo(0, 9);
  });

  it("turns with the covariance", () => {
    for (const angle of [-1.4, -0.5, 0.3, 1.2]) {
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const [large, small] = [9, 0.25];
      const ellipse = ellipseOf(large * c * c + small * s * s, (large - small) * c * s, large * s * s + small * c * c)!;

      expect(ellipse.angle).toBeCloseTo(angle, 9);
      expect(ellipse.major / ellipse.minor).toBeCloseTo(6, 9);
    }
  });

  it("draws nothing for what is no covariance", () => {
    expect(ellipseOf(1, 2, 1)).toBeUndefined();
    expect(ellipseOf(0, 0, 0)).toBeUndefined();
    expect(ellipseOf(-1, 0, 1)).toBeUndefined();
    expect(ellipseOf(NaN, 0, 1)).toBeUndefined();
    expect(ellipseOf(Infinity, 0, 1)).toBeUndefined();
  });
});

describe("View", () => {
  it("has y up and turns counter-clockwise angles over", () => {
    const view = new View(false);

    expect(view.place(2, 3)).toEqual({ x: 200, y: -300 });
    expect(view.rotation(Math.PI / 2)).toBeCloseTo(-90, 9);
  });

  it("flipped looks from the other side", () => {
    const view = new View(true);

    expect(view.place(2, 3)).toEqual({ x: -200, y: 300 });
    expect(view.rotation(0)).toBeCloseTo(180, 9);
    expect(view.rotation(Math.PI)).toBeCloseTo(0, 9);
  });
});

describe("format", () => {
  it("tells ages in the unit that reads best", () => {
    expect(format.age(37.4)).toBe("37 ms");
    expect(format.age(2340)).toBe("2.3 s");
    expect(format.age(150_000)).toBe("2 min");
    expect(format.age(7_300_000)).toBe("2 h");
    expect(format.age(NaN)).toBe(format.UNKNOWN);
    expect(format.age(Infinity)).toBe(format.UNKNOWN);
  });

  it("has three grades of freshness", () => {
    expect([0, 199, 200, 999, 1000, NaN].map(format.freshness)).toEqual(["fresh", "fresh", "late", "late", "lost", "lost"]);
  });

  it("keeps small shares visible", () => {
    expect(format.percent(0)).toBe("0 %");
    expect(format.percent(0.012)).toBe("1.2 %");
    expect(format.percent(0.02)).toBe("2 %");
    expect(format.percent(0.97)).toBe("97 %");
  });

  it("says that a latency is not known", () => {
    expect(format.latency(-1)).toBe(format.UNKNOWN);
    expect(format.latency(8.26)).toBe("8.3");
    expect(format.latency(27.6)).toBe("28");
  });

  it("reads masks, odds and quarantines", () => {
    expect(format.robotsIn(0b10000000_00010110)).toEqual([2, 3, 5, 16]);
    expect(format.halfProbability(0)).toBe(0.5);
    expect(format.halfProbability(-40)).toBeLessThan(0.001);
    expect(format.quarantine(3)).toBe("mirrored");
    expect(format.quarantine(99)).toBe("reason 99");
  });
});

const posture = (status: PostureStatus) => ({ status, halfLogOdds: 5, inlierRatio: 0.9, linePoints: 80, posture: { xM: 1, yM: 2, thetaRad: 0.5, cov: [0.01, 0, 0, 0.04, 0, 0.001] } });

const row = (fields: object) => create(RobotRowSchema, { robotId: 2, alive: true, ageMs: 30, ...fields });

describe("a row of the table", () => {
  it("shows a lost link, a late one and a shared id", () => {
    expect(linkCell(row({}), 10)).toEqual({ text: "40 ms", tone: "good" });
    expect(linkCell(row({}), 300).tone).toBe("warn");
    expect(linkCell(row({ alive: false, ageMs: 4000 }), 0)).toMatchObject({ text: "lost 4.0 s", tone: "bad" });
    expect(linkCell(row({ duplicate: true }), 0).text).toBe("id used twice");
  });

  it("shows load and temperature, and warns of heat", () => {
    expect(loadCell(row({ state: { cpuLoad: 0.2, cpuTemperatureDegc: 61.4 } })).text).toBe("20 % 61°");
    expect(loadCell(row({ state: { cpuLoad: 0.2, cpuTemperatureDegc: 95 } })).tone).toBe("bad");
    expect(loadCell(row({ state: { cpuLoad: 0.2 } })).text).toBe("20 %");
  });

  it("shows the posture with the wider of its sigmas", () => {
    expect(postureCell(row({ state: { posture: posture(PostureStatus.POSTURE_OK) } })).text).toBe("ok ±20 cm");
    const fine = { ...posture(PostureStatus.POSTURE_OK), posture: { cov: [0.0016 ** 2, 0, 0, 0.004 ** 2, 0, 0.01] } };
    expect(postureCell(row({ state: { posture: fine } })).text).toBe("ok ±0.4 cm");
    expect(postureCell(row({ state: { posture: posture(PostureStatus.POSTURE_LOST) } })).tone).toBe("bad");
    expect(postureCell(row({})).text).toBe(format.UNKNOWN);
  });

  it("shows no half for a robot that is lost", () => {
    expect(halfCell(row({ state: { posture: posture(PostureStatus.POSTURE_LOST) } })).text).toBe(format.UNKNOWN);
    expect(halfCell(row({ state: { posture: posture(PostureStatus.POSTURE_OK) } })).tone).toBe("good");
  });

  it("shows cameras, trust and what was not used", () => {
    expect(cameraCell(row({ state: { cameraLost: true } })).tone).toBe("bad");
    expect(cameraCell(row({ state: { frameRateHz: 24.8 } })).text).toBe("25 Hz");
    expect(trustCell(row({ explained: { trust: 0.1, quarantine: 4 } }), undefined).text).toBe("kidnapped");
    expect(trustCell(row({ state: { muted: true }, explained: { trust: 1 } }), undefined).text).toBe("muted");
    expect(rejectedCell(row({ explained: { rejectedGate: 3, rejectedLate: 12 } })).text).toBe("12 late +");
    expect(rejectedCell(row({ explained: {} })).text).toBe("0");
    expect(rejectedText(row({ explained: { rejectedGate: 3, rejectedLate: 12, accepted: 70 } }))).toBe(
      "12 frames too late, early or many, 3 sightings fitted nothing (used: 70)",
    );
    expect(rejectedText(row({ explained: { accepted: 70 } }))).toBe("nothing (used: 70)");
    expect(rejectedText(undefined)).toBe("–");
  });
});

describe("robots that the station has not heard itself", () => {
  it("have a row of their own, as a game that was imported has no other", () => {
    const update = create(MonitorUpdateSchema, { robots: [row({ robotId: 2 })], world: { teammates: [{ robotId: 3, trust: 1 }, { robotId: 2 }] } });

    const rows = rowsOf(update);

    expect(rows.map((one) => one.robotId)).toEqual([2, 3]);
    expect(rows.map((one) => linkCell(one, 0).text)).toEqual(["30 ms", "not heard"]);
    expect(rowsOf(create(MonitorUpdateSchema, {}))).toEqual([]);
  });

  it("stand where the world model has them", () => {
    const mate = create(WorldTeammateSchema, { robotId: 3, status: PostureStatus.POSTURE_OK, posture: { xM: -5.31, yM: 2 } });

    expect(placeCell(mate).text).toBe("at −5.3, 2.0 m");
    expect(placeCell(create(WorldTeammateSchema, { ...mate, status: PostureStatus.POSTURE_LOST })).text).toBe(format.UNKNOWN);
    expect(placeCell(undefined).text).toBe(format.UNKNOWN);
  });

  it("are imported where no fusion made the world model", () => {
    const told = (robotId: number) => create(MonitorUpdateSchema, { world: { sample: { robotId }, teammates: [{ robotId: 3, trust: 1 }] } });
    const [mine] = rowsOf(told(0));

    expect([told(0), told(2), create(MonitorUpdateSchema, {})].map(isImported)).toEqual([true, false, false]);
    expect(linkCell(mine!, 0, true).text).toBe("imported");
    const trust = COLUMNS.find((column) => column.head === "Trust")!;
    expect(trust.cell(mine!, { mate: told(0).world?.teammates[0], imported: true }, 0).text).toBe(format.UNKNOWN);
    expect(trust.cell(mine!, { mate: told(2).world?.teammates[0], imported: false }, 0).text).toBe("100 %");
  });

  it("are not said to have a fusion that leads", () => {
    expect([undefined, 0, 3].map(leaderText)).toEqual(["No fusion leads", "Imported", "Fusion 3 leads"]);
  });
});

describe("OpponentNumbers", () => {
  const numbersOf = (numbers: OpponentNumbers, tracks: number[], nowMs: number): number[] => {
    numbers.show(tracks, nowMs);
    return tracks.map((track) => numbers.of(track));
  };

  it("tells tracks apart whose ids end alike, and keeps each one's number", () => {
    const numbers = new OpponentNumbers();

    expect(numbersOf(numbers, [70_011, 71_011, 72_011], 0)).toEqual([1, 2, 3]);
    expect(numbersOf(numbers, [72_011, 90_000], 100)).toEqual([3, 4]);
    expect(numbersOf(numbers, [71_011, 70_011], 4000)).toEqual([2, 1]);
  });

  it("gives a number away when its track has been gone for a while", () => {
    const numbers = new OpponentNumbers();
    for (let ms = 0; ms <= 8000; ms += 1000) numbers.show(ms === 0 ? [5, 6] : [6], ms);

    expect(numbersOf(numbers, [6, 7], 8000)).toEqual([2, 1]);
    expect(numbers.of(5)).toBe(0);
  });
});

describe("sceneOf", () => {
  const world = { teammates: [{ robotId: 2, status: PostureStatus.POSTURE_OK, ageMs: 20, posture: { xM: 3, yM: 1, thetaRad: 0, cov: [0.01, 0, 0, 0.01, 0, 0.01] } }] };

  it("prefers the fused posture to the robot's own word", () => {
    const update = create(MonitorUpdateSchema, { world, robots: [row({ state: { posture: posture(PostureStatus.POSTURE_OK) } })] });

    const [mark] = sceneOf(update, 0).robots;

    expect(mark).toMatchObject({ id: 2, x: 3, y: 1, fused: true, freshness: "fresh" });
  });

  it("falls back to the robot's own word when no fusion speaks", () => {
    const update = create(MonitorUpdateSchema, { robots: [row({ state: { posture: posture(PostureStatus.POSTURE_OK) } })] });

    expect(sceneOf(update, 0).robots[0]).toMatchObject({ x: 1, y: 2, fused: false });
  });

  it("draws no robot that does not know where it is", () => {
    const update = create(MonitorUpdateSchema, { robots: [row({ state: { posture: posture(PostureStatus.POSTURE_LOST) } })] });

    expect(sceneOf(update, 0).robots).toEqual([]);
  });

  it("greys a robot out as time passes without news", () => {
    const update = create(MonitorUpdateSchema, { world, robots: [row({})] });

    expect(sceneOf(update, 500).robots[0]!.freshness).toBe("late");
    expect(sceneOf(update, 1000).robots[0]!.freshness).toBe("lost");
  });

  it("greys a robot out that the fusion still remembers but nobody hears", () => {
    const update = create(MonitorUpdateSchema, { world, robots: [row({ alive: false })] });

    expect(sceneOf(update, 0).robots[0]!.freshness).toBe("lost");
  });
});

describe("markOf", () => {
  it("is live only with a connection, fresh updates and nothing to complain about", () => {
    const update = create(MonitorUpdateSchema, {});

    expect(markOf(update, true, 100).live).toBe(true);
    expect(markOf(update, false, 100)).toMatchObject({ live: false, reason: expect.stringContaining("does not answer") });
    expect(markOf(update, true, 1500).live).toBe(false);
    expect(markOf(undefined, true, 0).live).toBe(false);
    expect(markOf(create(MonitorUpdateSchema, { silence: "no fusion" }), true, 0)).toEqual({ live: false, reason: "no fusion" });
  });
});

describe("connection", () => {
  it("stands beside the page and waits longer after each failure", () => {
    expect(liveAddress({ protocol: "http:", host: "127.0.0.1:8080" })).toBe("ws://127.0.0.1:8080/live");
    expect([1, 2, 3, 4, 9].map(pauseBefore)).toEqual([250, 500, 1000, 2000, 2000]);
  });
});

describe("keys", () => {
  it("belong to what has the focus only where it needs them", () => {
    expect(isTaken("b", "INPUT", "text")).toBe(true);
    expect(isTaken("b", "SELECT", "select-one")).toBe(true);
    expect(isTaken(" ", "INPUT", "checkbox")).toBe(true);
    expect(isTaken("b", "INPUT", "checkbox")).toBe(false);
    expect(isTaken(" ", "INPUT", "range")).toBe(false);
    expect(isTaken(" ", "BODY", "")).toBe(false);
    expect(isTaken(" ", "BUTTON", "button")).toBe(true);
    expect(isTaken("b", "BUTTON", "button")).toBe(false);
  });
});

describe("numbers", () => {
  it("are counted in words and signed as wide", () => {
    expect([0, 1, 2].map((count) => format.many(count, "ball"))).toEqual(["0 balls", "1 ball", "2 balls"]);
    expect([-1.25, 3].map(format.signed)).toEqual(["−1.3", "3.0"]);
  });
});

describe("several coach stations", () => {
  const here = (otherStations: number, referee = {}) => noticeOf(create(MonitorUpdateSchema, { otherStations, referee }));

  it("are said with whose game it is", () => {
    expect(here(0)).toBe("");
    expect(here(1, { followsGame: true })).toBe("2 coach stations are here: the newest order counts, the game comes from the other");
    expect(here(1, { tellsGame: true })).toBe("2 coach stations are here: the newest order counts, the game comes from this one");
    expect(here(2, { followsGame: true })).toBe("3 coach stations are here: the newest order counts, the game comes from another");
    expect(here(1)).toBe("2 coach stations are here: the newest order counts, none tells the game yet");
  });
});

describe("the world without one robot", () => {
  const ball = (x: number) => ({ balls: [{ pM: { x, y: 1 } }] });

  it("is compared by its ball", () => {
    expect(withoutText(create(MonitorUpdateSchema, { world: ball(1), without: { robotId: 2, world: ball(1.5) } }))).toBe("ball 0.50 m from the team's");
    expect(withoutText(create(MonitorUpdateSchema, { world: ball(1), without: { robotId: 2, world: {} } }))).toBe("no ball would be known");
    expect(withoutText(create(MonitorUpdateSchema, { world: ball(1) }))).toBe("not asked for");
  });
});

describe("raw layer", () => {
  it("puts what a robot sees into the field", () => {
    const at = toField(1, 2, Math.PI / 2, 3, 0);

    expect(at.x).toBeCloseTo(1, 9);
    expect(at.y).toBeCloseTo(5, 9);
  });

  it("ends a ray where a ball on the floor would lie", () => {
    const row = create(RobotRowSchema, { sightings: { balls: [{ originM: { x: 0, y: 0, z: 0.51 }, direction: { x: 0.6, y: 0, z: -0.08 } }] } });

    expect(rayEnd(row.sightings!.balls[0]!)!.x).toBeCloseTo(3, 9);
    expect(rayEnd(row.sightings!.balls[0]!)!.lies).toBe(true);
  });

  it("says how far a robot's own view lies from the team's", () => {
    const update = create(MonitorUpdateSchema, { world: { balls: [{ pM: { x: 3, y: 0.5, z: 0.1 } }], teammates: [{ robotId: 2, posture: { xM: 0.3, yM: 0 } }] } });
    const row = create(RobotRowSchema, { robotId: 2, sightings: { posture: { posture: { xM: 0, yM: 0, thetaRad: 0 } }, balls: [{ originM: { z: 0.51 }, direction: { x: 0.6, z: -0.08 } }] } });

    expect(difference(row, update).ball).toBeCloseTo(0.5, 6);
    expect(difference(row, update).posture).toBeCloseTo(0.3, 6);
  });
});

describe("orders", () => {
  it("takes a drag's direction for the heading, a click for the opponent goal", () => {
    expect(headingOf({ x: 0, y: 0 }, { x: 0, y: 1 })).toBeCloseTo(Math.PI / 2, 9);
    expect(headingOf({ x: 0, y: 0 }, { x: 0.05, y: 0.05 })).toBe(0);
  });

  it("says what is played", () => {
    const update = create(MonitorUpdateSchema, { referee: { hasBox: true, state: { piece: 1, pieceIsOurs: true } } });

    expect(gameText(update.referee)).toBe("our kick-off");
    expect(commandText(update.referee)).toBe("no command yet");
    expect(gameText(undefined)).toBe("no game");
    expect(gameText(create(MonitorUpdateSchema, { referee: { state: {} } }).referee)).toBe("no game");
    expect(gameText(create(MonitorUpdateSchema, { referee: { hasBox: true, state: {} } }).referee)).toBe("stopped");
    const told = (phase: number, lastCommand: string) => create(MonitorUpdateSchema, { referee: { hasBox: true, lastCommand, state: { phase, commandAgeMs: 3000 } } }).referee;
    expect(courseText(told(1, "before the game"))).toBe("before the game · 3.0 s ago");
    expect(courseText(told(2, "START"))).toBe("1st half · START · 3.0 s ago");
    expect(courseText(undefined)).toBe("no referee box");
  });
});

describe("the team on the air", () => {
  const process = { process: "fusion/1", wireBps: 4e5, thrift: 0, secured: true };

  it("adds up everybody's rate, but not that of an agent that is gone", () => {
    const robots = [{ alive: true, agent: { wireBps: 2e5 } }, { alive: false, agent: { wireBps: 9e5 } }];

    expect(bitRate(create(MonitorUpdateSchema, { robots, processes: [process] }))).toBe(6e5);
    expect(bitRate(create(MonitorUpdateSchema, {}))).toBeUndefined();
  });

  it("says what the thriftiest leaves out", () => {
    const update = create(MonitorUpdateSchema, { processes: [process, { ...process, thrift: 3 }] });

    expect(thriftText(update)).toBe("world model at 15 Hz");
    expect(thriftText(create(MonitorUpdateSchema, { processes: [process] }))).toBe("");
  });

  it("calls a team secured only if all are", () => {
    expect(isSecured(create(MonitorUpdateSchema, { processes: [process] }))).toBe(true);
    expect(isSecured(create(MonitorUpdateSchema, { processes: [process, { ...process, secured: false }] }))).toBe(false);
    expect(isSecured(create(MonitorUpdateSchema, {}))).toBeUndefined();
  });
});
