// monitor/web/src/raw_layer.ts: what each robot itself sees, under the fused picture.
import type { MonitorUpdate, RobotRow } from "./generated/monitor_pb";
import { type BallRay, PostureStatus } from "./generated/recording_pb";
import { svg } from "./dom";
import { UNITS, type View } from "./view";

/** Where a ray meets the height of a ball's centre that lies on the floor; nothing if it never does. */
const BALL_HEIGHT_M = 0.11;
const FARTHEST_M = 25;

export interface FloorPoint {
  x: number;
  y: number;
}

/** From R to F. */
export function toField(x: number, y: number, theta: number, px: number, py: number): FloorPoint {
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  return { x: x + c * px - s * py, y: y + s * px + c * py };
}

/** The floor point of a ball ray in R; a ray that rises ends far out. */
export function rayEnd(ball: BallRay): { x: number; y: number; lies: boolean } | undefined {
  const [origin, direction] = [ball.originM, ball.direction];
  if (!origin || !direction) return undefined;
  const flat = Math.hypot(direction.x, direction.y);
  if (flat < 1e-6) return undefined;
  const down = (BALL_HEIGHT_M - origin.z) / direction.z;
  const lies = down > 0 && down * flat < FARTHEST_M;
  const reach = lies ? down : FARTHEST_M / flat;
  return { x: origin.x + reach * direction.x, y: origin.y + reach * direction.y, lies };
}

/** How far a robot's own ball, posture and obstacles lie from the team's; metres, undefined: none. */
export function difference(row: RobotRow, update: MonitorUpdate): { ball?: number; posture?: number } {
  const posture = row.sightings?.posture?.posture;
  const mate = update.world?.teammates.find((one) => one.robotId === row.robotId)?.posture;
  const ball = update.world?.balls[0]?.pM;
  const out: { ball?: number; posture?: number } = {};
  if (!posture) return out;
  if (mate) out.posture = Math.hypot(mate.xM - posture.xM, mate.yM - posture.yM);
  const ends = (row.sightings?.balls ?? []).map(rayEnd).filter((end) => end?.lies);
  for (const end of ball ? ends : []) {
    const at = toField(posture.xM, posture.yM, posture.thetaRad, end!.x, end!.y);
    out.ball = Math.min(out.ball ?? Infinity, Math.hypot(at.x - ball!.x, at.y - ball!.y));
  }
  return out;
}

export class RawLayer {
  constructor(private readonly root: SVGGElement) {}

  clear(): void {
    if (this.root.childElementCount > 0) this.root.replaceChildren();
  }

  /** @param only  one robot; undefined: all */
  draw(update: MonitorUpdate, view: View, unitsPerPixel: number, only: number | undefined): void {
    this.root.replaceChildren();
    for (const row of update.robots) {
      if (!row.alive || (only !== undefined && row.robotId !== only)) continue;
      const report = row.sightings?.posture;
      if (!report?.posture || report.status === PostureStatus.POSTURE_LOST) continue;
      this.drawRobot(row, view, unitsPerPixel);
    }
  }

  private drawRobot(row: RobotRow, view: View, unit: number): void {
    const posture = row.sightings!.posture!.posture!;
    const group = svg("g", { class: `raw raw-${((row.robotId - 1) % 6) + 1}`, "data-robot": row.robotId }, this.root);
    const place = (x: number, y: number) => {
      const at = toField(posture.xM, posture.yM, posture.thetaRad, x, y);
      return view.place(at.x, at.y);
    };
    const here = view.place(posture.xM, posture.yM);
    for (const point of row.linePoints?.points ?? []) {
      const at = place(point.xM, point.yM);
      svg("circle", { class: point.inlier ? "line-point" : "line-point outlier", cx: at.x, cy: at.y, r: 2 * unit }, group);
    }
    for (const ball of row.sightings!.balls) {
      const end = rayEnd(ball);
      if (!end) continue;
      const at = place(end.x, end.y);
      svg("line", { class: "ray", x1: here.x, y1: here.y, x2: at.x, y2: at.y, "stroke-width": 1.5 * unit, opacity: 0.3 + 0.7 * ball.confidence }, group);
      if (end.lies) svg("circle", { class: "ray-end", cx: at.x, cy: at.y, r: Math.max(BALL_HEIGHT_M * UNITS, 5 * unit), "stroke-width": 2 * unit }, group);
    }
    for (const obstacle of row.sightings!.obstacles) {
      const at = place(obstacle.xM, obstacle.yM);
      const size = Math.max((obstacle.widthM / 2) * UNITS, 6 * unit);
      svg("path", { class: "seen-obstacle", d: `M${at.x - size} ${at.y}L${at.x} ${at.y - size}L${at.x + size} ${at.y}L${at.x} ${at.y + size}z`, "stroke-width": 1.5 * unit }, group);
    }
    svg("circle", { class: "own-posture", cx: here.x, cy: here.y, r: 5 * unit }, group);
  }
}

/** Where the obstacles were in the last seconds. */
export class Trails {
  private readonly tracks = new Map<number, { ms: number; x: number; y: number }[]>();

  constructor(
    private readonly root: SVGGElement,
    private readonly longestMs = 3000,
  ) {}

  draw(update: MonitorUpdate, view: View, unit: number): void {
    const now = Number(update.stampNs) / 1e6;
    for (const obstacle of update.world?.obstacles ?? []) {
      const track = this.tracks.get(obstacle.trackId) ?? [];
      // A jump back in time is another moment of the past: the trail begins anew.
      if ((track.at(-1)?.ms ?? 0) > now) track.length = 0;
      if (now - (track.at(-1)?.ms ?? -Infinity) > 60) track.push({ ms: now, x: obstacle.xM, y: obstacle.yM });
      this.tracks.set(obstacle.trackId, track);
    }
    this.root.replaceChildren();
    for (const [id, track] of this.tracks) {
      while (track.length > 0 && (now - track[0]!.ms > this.longestMs || track[0]!.ms > now)) track.shift();
      if (track.length === 0) this.tracks.delete(id);
      if (track.length < 2) continue;
      const points = track.map((point) => view.place(point.x, point.y));
      svg("polyline", { class: "trail", points: points.map((at) => `${at.x.toFixed(0)},${at.y.toFixed(0)}`).join(" "), "stroke-width": 2 * unit }, this.root);
    }
  }
}
