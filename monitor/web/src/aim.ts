// monitor/web/src/aim.ts: a place on the field by keys alone, while a tool asks for one.
import type { FieldView } from "./field_view";

/** In F, metres and radians. */
export interface Aimed {
  x: number;
  y: number;
  theta: number;
}

const STEP_M = 0.25;
const TURN_RAD = Math.PI / 18;
const CENTRE: Aimed = { x: 0, y: 0, theta: 0 };
const MOVES: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** What is said of the keys, behind what is said of the mouse. */
export const AIM_WORDS = "Or arrow keys, Enter";

/**
 * Where a key leads; undefined: it leads nowhere. Arrows go as the screen shows them, with Shift they turn; Home is the
 * centre mark.
 *
 * @param flipped  whether the field is seen from the other side
 */
export function aimed(at: Aimed, key: string, shift: boolean, flipped: boolean): Aimed | undefined {
  if (key === "Home") return CENTRE;
  const move = MOVES[key];
  if (!move) return undefined;
  const [right, up] = move;
  if (shift) return { ...at, theta: at.theta - (right - up) * TURN_RAD };
  const side = flipped ? -STEP_M : STEP_M;
  return { ...at, x: at.x + right * side, y: at.y + up * side };
}

/** Takes the arrow keys and Enter while it is started. */
export class Aim {
  private at: Aimed | undefined;
  private isShown = false;

  /** @param give  called with Enter */
  constructor(
    private readonly field: FieldView,
    private readonly give: (at: Aimed) => void,
  ) {
    // Before whatever has the focus: the tool is what the keys are for.
    document.addEventListener("keydown", (event) => this.press(event), true);
  }

  /** @param at  where to begin; shown with the first arrow, as a mouse may be meant; only what is shown is given */
  start(at: Aimed | undefined): void {
    this.isShown = false;
    this.at = at ?? CENTRE;
  }

  stop(): void {
    this.at = undefined;
    this.field.ghost(undefined, undefined);
  }

  private press(event: KeyboardEvent): void {
    if (!this.at || event.ctrlKey || event.metaKey || event.altKey) return;
    const next = aimed(this.at, event.key, event.shiftKey, this.field.isFlipped);
    if (!next && !(this.isShown && event.key === "Enter")) return;
    event.preventDefault();
    event.stopPropagation();
    if (!next) {
      this.give(this.at);
      return;
    }
    this.at = next;
    this.isShown = true;
    this.field.ghost(next, { x: next.x + Math.cos(next.theta), y: next.y + Math.sin(next.theta) });
  }
}
