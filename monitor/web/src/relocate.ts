// monitor/web/src/relocate.ts: dragging a robot's posture on the field.
import { byId, set, write } from "./dom";
import type { FieldView } from "./field_view";
import type { Orders } from "./orders";

/** Pressed where it stands, let go where it looks; Escape gives up. */
export class Relocate {
  private robot: number | undefined;
  private from: { x: number; y: number } | undefined;

  constructor(
    private readonly field: FieldView,
    private readonly orders: Orders,
  ) {
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
      const value = { robotId: this.robot, xM: this.from.x, yM: this.from.y, thetaRad: headingOf(this.from, to) };
      this.stop();
      this.orders.give({ case: "relocate", value });
    });
  }

  start(robot: number): void {
    if (!this.orders.token) {
      this.orders.ask();
      return;
    }
    this.robot = robot;
    write(byId("hint"), `Robot ${robot}: press where it stands, drag to where it looks. Esc gives up.`);
    set(byId("field"), { "data-tool": "relocate" });
  }

  stop(): void {
    this.robot = this.from = undefined;
    this.field.ghost(undefined, undefined);
    write(byId("hint"), "");
    set(byId("field"), { "data-tool": "" });
  }
}

/** A drag too short to tell looks to the opponent goal. */
export function headingOf(from: { x: number; y: number }, to: { x: number; y: number }): number {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  return Math.hypot(dx, dy) < 0.1 ? 0 : Math.atan2(dy, dx);
}
