// monitor/web/src/ball_hint.ts: the operator's word about where the ball is, by one click on the field.
import { Aim, AIM_WORDS } from "./aim";
import { byId, set, write } from "./dom";
import type { FieldView } from "./field_view";
import type { Orders } from "./orders";

/** Armed by button or key, given by a click; Escape gives up. */
export class BallHint {
  private isArmed = false;
  private readonly aim: Aim;

  constructor(
    field: FieldView,
    private readonly orders: Orders,
  ) {
    this.aim = new Aim(field, ({ x, y }) => this.give(x, y));
    byId("field").addEventListener("pointerdown", (event) => {
      if (!this.isArmed || (event.target as Element).closest("button")) return;
      event.preventDefault();
      const at = field.toField(event.clientX, event.clientY);
      this.give(at.x, at.y);
    });
  }

  private give(xM: number, yM: number): void {
    this.stop();
    this.orders.give({ case: "ballHint", value: { xM, yM } });
  }

  /** @param at  where a ball is thought to be now; undefined: nobody knows */
  start(at: { x: number; y: number } | undefined): void {
    if (!this.orders.token) {
      this.orders.ask();
      return;
    }
    this.isArmed = true;
    this.aim.start(at && { ...at, theta: 0 });
    write(byId("hint"), `Click where the ball is: of what the robots see, that ball counts. ${AIM_WORDS}. Esc gives up.`);
    set(byId("field"), { "data-tool": "ball" });
    set(byId("ball-hint"), { class: "tool on" });
  }

  stop(): void {
    if (!this.isArmed) return;
    this.isArmed = false;
    this.aim.stop();
    write(byId("hint"), "");
    set(byId("field"), { "data-tool": "" });
    set(byId("ball-hint"), { class: "tool" });
  }
}
