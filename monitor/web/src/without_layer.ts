// monitor/web/src/without_layer.ts: the world as it would be if one robot were muted, in dashes over the team's.
import type { MonitorUpdate } from "./generated/monitor_pb";
import { svg } from "./dom";
import { UNITS, type View } from "./view";

const BALL_M = 0.11;
const ROBOT_M = 0.25;

/** How far the best ball would lie from the team's, in words. */
export function withoutText(update: MonitorUpdate): string {
  const without = update.without;
  const [ours, theirs] = [update.world?.balls[0]?.pM, without?.world?.balls[0]?.pM];
  if (!without) return "not asked for";
  if (!theirs) return ours ? "no ball would be known" : "no ball either way";
  if (!ours) return "a ball would be known";
  return `ball ${Math.hypot(ours.x - theirs.x, ours.y - theirs.y).toFixed(2)} m from the team's`;
}

export class WithoutLayer {
  constructor(private readonly root: SVGGElement) {}

  draw(update: MonitorUpdate, view: View, unit: number): void {
    if (this.root.childElementCount > 0) this.root.replaceChildren();
    const world = update.without?.world;
    if (!world) return;
    const ring = (kind: string, x: number, y: number, radius: number): void => {
      const at = view.place(x, y);
      svg("circle", { class: `without ${kind}`, cx: at.x, cy: at.y, r: radius, "stroke-width": 2 * unit, "stroke-dasharray": `${4 * unit} ${3 * unit}` }, this.root);
    };
    const robotSize = Math.max(ROBOT_M * UNITS, 13 * unit) * 1.25;
    for (const mate of world.teammates) {
      if (mate.posture && mate.robotId !== update.without?.robotId) ring("mate", mate.posture.xM, mate.posture.yM, robotSize);
    }
    for (const obstacle of world.obstacles) ring("other", obstacle.xM, obstacle.yM, robotSize);
    for (const ball of world.balls) ring("ball", ball.pM?.x ?? 0, ball.pM?.y ?? 0, Math.max(BALL_M * UNITS, 7 * unit) * 1.7);
  }
}
