// monitor/web/src/explainer.ts: the words behind what is shown, by pointer, by touch and by keyboard alike.
import { html, set, write } from "./dom";

const GAP_PX = 8;

/** Left and top of a bubble beside what it explains: above it where it fits, and within the window. */
export function bubblePlace(
  target: { left: number; top: number; width: number; height: number },
  bubble: { width: number; height: number },
  screen: { width: number; height: number },
): { left: number; top: number } {
  const left = target.left + target.width / 2 - bubble.width / 2;
  const above = target.top - bubble.height - GAP_PX;
  const top = above >= GAP_PX ? above : target.top + target.height + GAP_PX;
  return {
    left: Math.max(GAP_PX, Math.min(left, screen.width - bubble.width - GAP_PX)),
    top: Math.max(GAP_PX, Math.min(top, screen.height - bubble.height - GAP_PX)),
  };
}

/** What the bubble stands beside; that of the table stands above all of it, so that no robot is covered. */
function anchorOf(target: Element): { left: number; top: number; width: number; height: number } {
  const { left, top, width, height } = target.getBoundingClientRect();
  const table = target.closest("table")?.getBoundingClientRect();
  return table ? { left, top: table.top, width, height: table.height } : { left, top, width, height };
}

/**
 * Says what stands in `data-why` of whatever has the pointer or the focus. A button that was clicked keeps quiet:
 * who clicks it knows what it does.
 */
export class Explainer {
  private readonly bubble: HTMLElement;
  private pointed: Element | null = null;
  private focused: Element | null = null;

  constructor(root: HTMLElement) {
    this.bubble = html("div", "why", root);
    set(this.bubble, { role: "tooltip", id: "why", "aria-live": "polite" });
    this.bubble.hidden = true;
    root.addEventListener("pointerover", (event) => this.point(event.pointerType === "mouse" ? event.target : null));
    root.addEventListener("pointerdown", () => this.point(null)); // what is under it is what counts now
    root.addEventListener("focusin", (event) => this.focus(event.target));
    root.addEventListener("focusout", () => this.focus(null));
    // Before the page's keys: the first Escape takes only the words away.
    root.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.away();
    });
  }

  /** What is explained moves and changes; called with each drawing. */
  draw(): void {
    const target = [this.pointed, this.focused].find((one) => one?.isConnected && one.getAttribute("data-why"));
    const words = target?.getAttribute("data-why") ?? "";
    this.bubble.hidden = words === "";
    if (!target || !words) return;
    write(this.bubble, words);
    const place = bubblePlace(anchorOf(target), this.bubble.getBoundingClientRect(), { width: innerWidth, height: innerHeight });
    this.bubble.style.left = `${place.left}px`;
    this.bubble.style.top = `${place.top}px`;
  }

  private point(target: EventTarget | null): void {
    this.pointed = target instanceof Element ? target.closest("[data-why]") : null;
    this.draw();
  }

  private focus(target: EventTarget | null): void {
    this.focused?.removeAttribute("aria-describedby");
    const found = target instanceof Element ? target.closest("[data-why]") : null;
    this.focused = found?.matches(".tool, .tabs *") && !found.matches(":focus-visible") ? null : found;
    this.focused?.setAttribute("aria-describedby", this.bubble.id);
    this.draw();
  }

  private away(): void {
    this.pointed = null;
    this.focus(null);
  }
}
