// monitor/web/src/timeline_view.ts: the bar below the field: pause, step, speed, where in time.
import { byId, html, set, svg, write } from "./dom";
import type { History } from "./history";
import { type Player, SPEEDS } from "./player";

export interface TimelineActions {
  changed(): void;
  bookmark(): void;
}

/** "−12.3 s" behind the newest, or "01:02.3" into a recording. */
export function positionText(ms: number, firstMs: number, lastMs: number, isRecording: boolean): string {
  if (!isRecording) return ms >= lastMs ? "now" : `−${((lastMs - ms) / 1000).toFixed(1)} s`;
  const seconds = Math.max(ms - firstMs, 0) / 1000;
  const minutes = Math.floor(seconds / 60);
  return `${String(minutes).padStart(2, "0")}:${(seconds % 60).toFixed(1).padStart(4, "0")}`;
}

/** Drawn, because not every computer has a font with these signs. */
const ICONS = {
  before: "M2 3h2v10H2zM14 3v10L5 8z",
  back: "M11 3v10L4 8z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  play: "M4 3v10l9-5z",
  on: "M5 3v10l7-5z",
  next: "M12 3h2v10h-2zM2 3v10l9-5z",
  star: "M8 1.5l2 4.3 4.7.6-3.5 3.2.9 4.7L8 12l-4.1 2.3.9-4.7L1.3 6.4 6 5.8z",
} as const;

export class TimelineView {
  private readonly slider: HTMLInputElement;
  private readonly toggleIcon: SVGPathElement;
  private readonly live: HTMLButtonElement;
  private readonly position: HTMLElement;
  private readonly speed: HTMLSelectElement;
  private readonly marks: HTMLElement;
  private marked = -1;

  constructor(
    private readonly player: Player,
    private readonly history: History,
    private readonly actions: TimelineActions,
  ) {
    const root = byId("timeline");
    root.replaceChildren();
    const button = (text: string, why: string, act: () => void): HTMLButtonElement => {
      const element = html("button", "tool", root, text);
      element.type = "button";
      element.dataset["why"] = why;
      element.addEventListener("click", () => {
        act();
        this.actions.changed();
      });
      return element;
    };
    const icon = (shape: keyof typeof ICONS, title: string, act: () => void): HTMLButtonElement => {
      const element = button("", title, act);
      element.setAttribute("aria-label", title);
      svg("path", { d: ICONS[shape] }, svg("svg", { viewBox: "0 0 16 16", class: "icon" }, element));
      return element;
    };
    const now = (): number => performance.now();
    icon("before", "Event before (Page Up)", () => player.jump(-1, now()));
    icon("back", "One update back (,)", () => player.step(-1, now()));
    const toggle = icon("pause", "Pause, go on (space)", () => player.toggle(now()));
    toggle.id = "toggle";
    this.toggleIcon = toggle.querySelector("path")!;
    icon("on", "One update on (.)", () => player.step(1, now()));
    icon("next", "Next event (Page Down)", () => player.jump(1, now()));
    const track = html("div", "track", root);
    this.marks = html("div", "track-marks", track);
    this.slider = html("input", "", track);
    this.slider.type = "range";
    this.slider.id = "scrub";
    this.slider.min = "0";
    this.slider.max = "1000";
    this.slider.setAttribute("aria-label", "Where in time");
    this.slider.addEventListener("input", () => {
      const first = history.firstMs ?? 0;
      const last = history.lastMs ?? 0;
      player.seek(first + ((last - first) * Number(this.slider.value)) / 1000, now());
      this.actions.changed();
    });
    this.position = html("span", "position", root);
    this.position.id = "position";
    this.speed = html("select", "tool", root);
    this.speed.dataset["why"] = "Speed (+ and −)";
    this.speed.setAttribute("aria-label", "Speed");
    for (const speed of SPEEDS) html("option", "", this.speed, `${speed}×`).value = String(speed);
    this.speed.addEventListener("change", () => {
      player.speed = Number(this.speed.value);
      this.speed.blur(); // the keys are the page's again
      this.actions.changed();
    });
    const skip = html("label", "tool skip", root);
    const box = html("input", "", skip);
    box.type = "checkbox";
    box.dataset["why"] = skip.dataset["why"] = "Leaves out the time in which the game stands still";
    box.addEventListener("change", () => (player.skipsStops = box.checked));
    html("span", "", skip, "skip stops");
    icon("star", "Bookmark now (b)", () => actions.bookmark());
    this.live = button("Live", "Back to the newest (l)", () => player.goLive());
    this.live.id = "go-live";
  }

  draw(ms: number | undefined): void {
    const first = this.history.firstMs ?? 0;
    const last = this.history.lastMs ?? 0;
    const at = ms ?? last;
    if (document.activeElement !== this.slider || this.player.mode !== "paused") {
      this.slider.value = String(last > first ? (1000 * (at - first)) / (last - first) : 1000);
    }
    set(this.toggleIcon, { d: this.player.mode === "paused" ? ICONS.play : ICONS.pause });
    write(this.position, positionText(at, first, last, this.player.isRecording));
    this.speed.value = String(this.player.speed);
    this.live.disabled = this.player.mode === "live" || this.player.isRecording;
    this.drawMarks(first, last);
  }

  /** Where something happened; made again every second at most, as the past moves slowly. */
  private drawMarks(first: number, last: number): void {
    const tick = Math.floor(last / 1000);
    if (tick === this.marked || last <= first) return;
    this.marked = tick;
    this.marks.replaceChildren();
    let count = 0;
    for (let ms = this.history.eventFrom(first - 1, 1); ms !== undefined && count < 200; ++count) {
      const mark = html("i", "", this.marks);
      mark.style.left = `${((100 * (ms - first)) / (last - first)).toFixed(2)}%`;
      ms = this.history.eventFrom(ms, 1);
    }
  }
}
