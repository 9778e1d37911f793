// monitor/web/src/side_view.ts: beside the field: the ball in numbers, processes, events, who leads.
import type { MonitorEvent, MonitorUpdate } from "./generated/monitor_pb";
import type { Diagnostics, ExplainedHint } from "./generated/recording_pb";
import { byId, html, set, write } from "./dom";
import * as format from "./format";
import { Roving } from "./roving";
import type { BallMark, Scene } from "./scene";

const LONGEST_LOG = 200;
const MOST_EVENTS = 5000;

function figure(parent: Element, name: string): HTMLElement {
  const box = html("div", "figure", parent);
  html("span", "figure-name", box, name);
  return html("span", "figure-value", box, format.UNKNOWN);
}

/** What the operator's hint does, after the title. */
export function hintText(hint: ExplainedHint | undefined): string {
  if (!hint) return "";
  const left = `${Math.ceil(hint.leftMs / 1000)} s`;
  return hint.trackId ? ` · by hint, ${left}` : ` · hint: no ball there yet, ${left}`;
}

/** The ball in numbers: always the same boxes, with dashes where nothing is known. */
export class BallCard {
  private readonly title: HTMLElement;
  private readonly values: Record<"speed" | "height" | "place" | "age" | "existence", HTMLElement>;
  private readonly bar: HTMLElement;
  private readonly seenBy: HTMLElement;
  private readonly againstBy: HTMLElement;

  constructor(private readonly root: HTMLElement) {
    this.title = html("h2", "", root, "Ball");
    const figures = html("div", "figures", root);
    this.values = {
      speed: figure(figures, "Speed"),
      height: figure(figures, "Height"),
      age: figure(figures, "Age"),
      place: figure(figures, "Place"),
      existence: figure(figures, "Existence"),
    };
    this.bar = html("div", "bar-fill", html("div", "bar-track", this.values.existence.parentElement ?? figures));
    const seen = html("div", "seen", root);
    html("span", "figure-name", seen, "Seen by");
    this.seenBy = html("span", "chips", seen);
    html("span", "figure-name", seen, "Contradicted by");
    this.againstBy = html("span", "chips against", seen);
  }

  draw(scene: Scene, hint: ExplainedHint | undefined): void {
    const ball = scene.balls[0];
    set(this.root, { "data-freshness": ball?.freshness ?? "lost" });
    write(this.title, (scene.balls.length > 1 ? `Ball (and ${scene.balls.length - 1} more)` : "Ball") + hintText(hint));
    write(this.values.speed, ball ? `${ball.speed.toFixed(1)} m/s` : format.UNKNOWN);
    write(this.values.height, ball ? format.metres(ball.z) : format.UNKNOWN);
    write(this.values.age, ball ? format.age(ball.ageMs) : format.UNKNOWN);
    write(this.values.place, ball ? `${format.signed(ball.x)}, ${format.signed(ball.y)} m` : format.UNKNOWN);
    write(this.values.existence, ball ? format.percent(ball.existence) : format.UNKNOWN);
    this.bar.style.width = `${(ball?.existence ?? 0) * 100}%`;
    this.chips(this.seenBy, ball, ball?.supporters ?? []);
    this.chips(this.againstBy, ball, ball?.rejected ?? []);
  }

  private chips(parent: HTMLElement, ball: BallMark | undefined, robots: number[]): void {
    const text = ball ? robots.join(" ") : "";
    if (parent.dataset["robots"] === text) return;
    parent.dataset["robots"] = text;
    parent.replaceChildren();
    if (robots.length === 0) html("span", "none", parent, format.UNKNOWN);
    for (const robot of robots) html("span", "chip", parent, String(robot));
  }
}

/** One line per process that is no agent; agents have their table. */
export class ProcessCard {
  private readonly list: HTMLElement;
  private readonly dropped: HTMLElement;
  private readonly roving: Roving;

  constructor(root: HTMLElement) {
    html("h2", "", root, "Processes");
    this.list = html("div", "process-list", root);
    this.dropped = html("div", "dropped", root);
    this.roving = new Roving(root, "", "[data-why]");
  }

  draw(update: MonitorUpdate): void {
    const processes = update.processes;
    while (this.list.childElementCount > processes.length) this.list.lastElementChild?.remove();
    processes.forEach((process, index) => {
      const line = this.list.children[index] ?? this.makeLine();
      set(line, { class: `process ${process.healthy ? "well" : "ill"}`, "data-why": processText(process) });
      write(line.children[1]!, process.process);
      write(line.children[2]!, `${format.latency(process.stepMsP95)} ms`);
      write(line.children[3]!, format.percent(process.cpuLoad));
    });
    const dropped = update.rejected.map((counter) => `${counter.name} ${format.count(counter.value)}`).join(", ");
    const words = dropped ? `Dropped here: ${dropped}` : processes.length === 0 ? "none heard" : "";
    write(this.dropped, words);
    this.dropped.hidden = words === "";
    set(this.dropped, { class: dropped ? "dropped" : "none" });
    if (dropped) set(this.dropped, { tabindex: this.dropped.tabIndex, "data-why": `Samples that this station did not use, by topic and reason: ${dropped}` });
    else this.dropped.removeAttribute("data-why");
    this.roving.keepStop();
  }

  private makeLine(): Element {
    const line = html("div", "", this.list);
    line.tabIndex = -1;
    html("span", "dot", line);
    html("span", "process-name", line);
    html("span", "process-number", line);
    html("span", "process-number", line);
    return line;
  }
}

/** How a process is, in words. */
export function processText(process: Diagnostics): string {
  const how = process.message || (process.healthy ? "well" : "not well");
  return `${process.process}: ${how}. 95 % of its steps take less than ${format.latency(process.stepMsP95)} ms; it takes ${format.percent(process.cpuLoad)} of a core`;
}

interface LogLine {
  stampNs: bigint;
  level: string;
  text: string;
  time: string;
}

/** The newest event on top; of the past those that had happened by then. */
export class EventLog {
  private lines: LogLine[] = [];
  private shown = 0;

  constructor(private readonly root: HTMLElement) {}

  clear(): void {
    this.lines = [];
    this.shown = 0;
    this.root.replaceChildren();
  }

  /**
   * @param nowNs  the station's clock when they were sent, to tell the time of day
   * @param dateMinusStampNs  of a recording: what makes a date of its stamps
   */
  add(events: MonitorEvent[], nowNs: bigint, dateMinusStampNs = 0n): void {
    for (const event of events) {
      const dateMs = dateMinusStampNs ? Number(event.stampNs + dateMinusStampNs) / 1e6 : Date.now() - Number(nowNs - event.stampNs) / 1e6;
      this.lines.push({ stampNs: event.stampNs, level: event.level, text: event.text, time: format.timeOfDay(new Date(dateMs)) });
    }
    if (this.lines.length > MOST_EVENTS) this.lines.splice(0, this.lines.length - MOST_EVENTS);
    if (events.length > 0) this.shown = -1;
  }

  /** @param untilNs  the moment that is shown, by the station's clock; undefined: the newest */
  draw(untilNs: bigint | undefined): void {
    const happened = untilNs === undefined ? this.lines.length : this.lines.findLastIndex((line) => line.stampNs <= untilNs) + 1;
    if (happened === this.shown) return;
    this.shown = happened;
    this.root.replaceChildren();
    for (const line of this.lines.slice(Math.max(0, happened - LONGEST_LOG), happened).reverse()) {
      const item = html("li", line.level, this.root);
      html("time", "", item, line.time);
      html("span", "", item, line.text);
    }
  }
}

/** Whose world model it is; 0: nobody's, of a game that was imported. */
export function leaderText(robot: number | undefined): string {
  if (robot === undefined) return "No fusion leads";
  return robot === 0 ? "Imported" : `Fusion ${robot} leads`;
}

/** Which fusion's picture this is. */
export function drawLead(update: MonitorUpdate, sinceUpdateMs: number): void {
  const root = byId("lead");
  const world = update.world;
  const ageMs = update.worldAgeMs + sinceUpdateMs;
  set(root, { "data-freshness": world ? format.freshness(ageMs) : "lost", "data-why": "Whose world model is shown, and how long ago it came" });
  write(byId("leader"), leaderText(world?.sample?.robotId));
  write(byId("lead-age"), world ? `${format.age(Math.round(ageMs / 10) * 10)} ago` : format.UNKNOWN);
}
