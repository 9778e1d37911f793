// monitor/web/src/ball_hint.ts: the operator's word about where the ball is, by one click on the field.
import { byId, set, write } from "./dom";
import type { FieldView } from "./field_view";
import type { Orders } from "./orders";

/** Armed by button or key, given by a click; Escape gives up. */
export class BallHint {
  private isArmed = false;

  constructor(
    field: FieldView,
    private readonly orders: Orders,
  ) {
    byId("field").addEventListener("pointerdown", (event) => {
      if (!this.isArmed || (event.target as Element).closest("button")) return;
      event.preventDefault();
      const at = field.toField(event.clientX, event.clientY);
      this.stop();
      this.orders.give({ case: "ballHint", value: { xM: at.x, yM: at.y } });
    });
  }

  start(): void {
    if (!this.orders.token) {
      this.orders.ask();
      return;
    }
    this.isArmed = true;
    write(byId("hint"), "Click where the ball is: of what the robots see, that ball counts. Esc gives up.");
    set(byId("field"), { "data-tool": "ball" });
    set(byId("ball-hint"), { class: "tool on" });
  }

  stop(): void {
    if (!this.isArmed) return;
    this.isArmed = false;
    write(byId("hint"), "");
    set(byId("field"), { "data-tool": "" });
    set(byId("ball-hint"), { class: "tool" });
  }
}
