// monitor/web/src/relocate.ts: dragging a robot's posture on the field, or putting it there by keys.
import { Aim, AIM_WORDS, type Aimed } from "./aim";
import { byId, set, write } from "./dom";
import type { FieldView } from "./field_view";
import type { Orders } from "./orders";

/** Pressed where it stands, let go where it looks; Escape gives up. */
export class Relocate {
  private robot: number | undefined;
  private from: { x: number; y: number } | undefined;
  private readonly aim: Aim;

  constructor(
    field: FieldView,
    private readonly orders: Orders,
  ) {
    this.aim = new Aim(field, (at) => this.give(at));
    const area = byId("field");
    area.addEventListener("pointerdown", (event) => {
      if (this.robot === undefined) return;
      event.preventDefault();
      area.setPointerCapture(event.pointerId);
      this.from = field.toField(event.clientX, event.clientY);
    });
    area.addEventListener("pointermove", (event) => {
      if (this.from) field.ghost(this.from, field.toField(event.clientX, event.clientY));
    });
    area.addEventListener("pointerup", (event) => {
      if (!this.from || this.robot === undefined) return;
      const to = field.toField(event.clientX, event.clientY);
      this.give({ ...this.from, theta: headingOf(this.from, to) });
    });
  }

  private give(at: Aimed): void {
    if (this.robot === undefined) return;
    const value = { robotId: this.robot, xM: at.x, yM: at.y, thetaRad: Math.atan2(Math.sin(at.theta), Math.cos(at.theta)) };
    this.stop();
    this.orders.give({ case: "relocate", value });
  }

  /** @param at  where it is taken to stand now; undefined: nobody knows */
  start(robot: number, at: Aimed | undefined): void {
    if (!this.orders.token) {
      this.orders.ask();
      return;
    }
    this.robot = robot;
    this.aim.start(at);
    write(byId("hint"), `Robot ${robot}: press where it stands, drag to where it looks. ${AIM_WORDS}; Shift turns. Esc gives up.`);
    set(byId("field"), { "data-tool": "relocate" });
  }

  stop(): void {
    this.robot = this.from = undefined;
    this.aim.stop();
    write(byId("hint"), "");
    set(byId("field"), { "data-tool": "" });
  }
}

/** A drag too short to tell looks to the opponent goal. */
export function headingOf(from: { x: number; y: number }, to: { x: number; y: number }): number {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  return Math.hypot(dx, dy) < 0.1 ? 0 : Math.atan2(dy, dx);
}
