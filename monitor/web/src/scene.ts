// monitor/web/src/scene.ts: one update as the things to draw, with ages; no DOM.
import type { MonitorUpdate } from "./generated/monitor_pb";
import { PostureStatus } from "./generated/recording_pb";
import { type Ellipse, ellipseOf } from "./ellipse";
import { type Freshness, freshness, quarantine, robotsIn } from "./format";

export interface RobotMark {
  id: number;
  x: number;
  y: number;
  theta: number;
  ellipse: Ellipse | undefined;
  freshness: Freshness;
  /** The fused posture; false: only what the robot says of itself. */
  fused: boolean;
  lost: boolean;
  quarantined: boolean;
}

export interface BallMark {
  id: number;
  x: number;
  y: number;
  z: number;
  vx: number;
  vy: number;
  speed: number;
  ellipse: Ellipse | undefined;
  existence: number;
  ageMs: number;
  freshness: Freshness;
  supporters: number[];
  rejected: number[];
}

export interface ObstacleMark {
  id: number;
  x: number;
  y: number;
  vx: number;
  vy: number;
  radius: number;
  ellipse: Ellipse | undefined;
  existence: number;
  freshness: Freshness;
}

export interface Scene {
  robots: RobotMark[];
  balls: BallMark[];
  obstacles: ObstacleMark[];
}

/**
 * Whether this is of a game that another program recorded and no fusion made: places and speeds, without uncertainties,
 * and obstacles whose ids mean nothing.
 */
export const isImported = (update: MonitorUpdate): boolean => update.world?.sample?.robotId === 0;

/**
 * What to draw of an update.
 *
 * @param sinceUpdateMs  how long ago the page received it: everything in it is older by so much
 */
export function sceneOf(update: MonitorUpdate, sinceUpdateMs: number): Scene {
  const worldAge = update.worldAgeMs + sinceUpdateMs;
  const spread = isImported(update) ? () => undefined : ellipseOf;
  return {
    robots: robotMarks(update, sinceUpdateMs, worldAge),
    balls: (update.world?.balls ?? []).map((ball) => {
      const ageMs = ball.ageMs + worldAge;
      const [xx = 0, xy = 0, , yy = 0] = ball.covP;
      const vx = ball.vMps?.x ?? 0;
      const vy = ball.vMps?.y ?? 0;
      return {
        id: ball.trackId,
        x: ball.pM?.x ?? 0,
        y: ball.pM?.y ?? 0,
        z: ball.pM?.z ?? 0,
        vx,
        vy,
        speed: Math.hypot(vx, vy, ball.vMps?.z ?? 0),
        ellipse: spread(xx, xy, yy),
        existence: ball.existence,
        ageMs,
        freshness: freshness(ageMs),
        supporters: robotsIn(ball.supporters),
        rejected: robotsIn(ball.rejected),
      };
    }),
    obstacles: (update.world?.obstacles ?? []).map((obstacle) => {
      const [xx = 0, xy = 0, yy = 0] = obstacle.cov;
      return {
        id: obstacle.trackId,
        x: obstacle.xM,
        y: obstacle.yM,
        vx: obstacle.vxMps,
        vy: obstacle.vyMps,
        radius: obstacle.radiusM,
        ellipse: spread(xx, xy, yy),
        existence: obstacle.existence,
        freshness: freshness(obstacle.ageMs + worldAge),
      };
    }),
  };
}

/** A robot that the world model has is drawn from there, any other from its own word. */
function robotMarks(update: MonitorUpdate, sinceUpdateMs: number, worldAge: number): RobotMark[] {
  const marks = new Map<number, RobotMark>();
  for (const mate of update.world?.teammates ?? []) {
    const [xx = 0, xy = 0, , yy = 0] = mate.posture?.cov ?? [];
    marks.set(mate.robotId, {
      id: mate.robotId,
      x: mate.posture?.xM ?? 0,
      y: mate.posture?.yM ?? 0,
      theta: mate.posture?.thetaRad ?? 0,
      ellipse: isImported(update) ? undefined : ellipseOf(xx, xy, yy),
      freshness: freshness(mate.ageMs + worldAge),
      fused: worldAge < 1000,
      lost: mate.status === PostureStatus.POSTURE_LOST,
      quarantined: quarantine(mate.quarantine) !== "",
    });
  }
  for (const row of update.robots) {
    const known = marks.get(row.robotId);
    const age = row.alive ? row.ageMs + sinceUpdateMs : Infinity;
    if (known?.fused) {
      // What the station itself heard of the robot is the truth about its link.
      if (freshness(age) === "lost") known.freshness = "lost";
      continue;
    }
    const posture = row.state?.posture;
    if (!posture?.posture) continue;
    const [xx = 0, xy = 0, , yy = 0] = posture.posture.cov;
    marks.set(row.robotId, {
      id: row.robotId,
      x: posture.posture.xM,
      y: posture.posture.yM,
      theta: posture.posture.thetaRad,
      ellipse: ellipseOf(xx, xy, yy),
      freshness: freshness(age),
      fused: false,
      lost: posture.status === PostureStatus.POSTURE_LOST,
      quarantined: false,
    });
  }
  // A robot that never knew where it was stands nowhere, not at the origin.
  return [...marks.values()].filter((mark) => !mark.lost).sort((a, b) => a.id - b.id);
}

/** The large mark of the page. */
export interface Mark {
  live: boolean;
  reason: string;
}

/** What the operator should know as long as it is so; empty: nothing. */
export function noticeOf(update: MonitorUpdate | undefined): string {
  const others = update?.otherStations ?? 0;
  if (others === 0) return "";
  const referee = update?.referee;
  const one = others === 1 ? "the other" : "another";
  const game = referee?.followsGame ? `the game comes from ${one}` : referee?.tellsGame ? "the game comes from this one" : "none tells the game yet";
  return `${others + 1} coach stations are here: the newest order counts, ${game}`;
}

export function markOf(update: MonitorUpdate | undefined, connected: boolean, sinceUpdateMs: number): Mark {
  if (!connected) return { live: false, reason: "The station does not answer; trying again" };
  if (!update || sinceUpdateMs > 1000) return { live: false, reason: "Nothing from the station yet" };
  if (update.silence) return { live: false, reason: update.silence };
  return { live: true, reason: "" };
}
