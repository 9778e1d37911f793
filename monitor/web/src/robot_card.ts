// monitor/web/src/robot_card.ts: one robot close up: its own view against the team's, its camera, orders to it.
import type { MonitorUpdate } from "./generated/monitor_pb";
import type { Thumbnail, VirtualSensors } from "./generated/recording_pb";
import { html, write } from "./dom";
import * as format from "./format";
import type { Orders } from "./orders";
import { difference } from "./raw_layer";
import { rejectedText } from "./robot_cells";
import { withoutText } from "./without_layer";

/** How long a look at camera or line points is asked for at a time, and how often again. */
const LOOK_MS = 4000;
const ASK_AGAIN_MS = 2500;

export class RobotCard {
  robot = 1;
  private looksAtCamera = false;
  private looksAtLines = false;
  private leavesOut = false;
  private askedAt = -Infinity;
  private readonly title: HTMLElement;
  private readonly facts: HTMLElement;
  private readonly picture: HTMLImageElement;
  private readonly camera: HTMLButtonElement;
  private readonly lines: HTMLButtonElement;
  private readonly without: HTMLButtonElement;
  private readonly sensors: HTMLElement;
  private url = "";

  constructor(
    root: HTMLElement,
    private readonly orders: Orders,
    startRelocating: (robot: number) => void,
  ) {
    this.title = html("h2", "", root, "Robot 1");
    const bar = html("div", "robot-orders", root);
    const button = (text: string, why: string, act: () => void): HTMLButtonElement => {
      const element = html("button", "tool", bar, text);
      element.type = "button";
      element.dataset["why"] = why;
      element.addEventListener("click", act);
      return element;
    };
    button("Relocate", "Then drag on the field: where it stands and where it looks (r)", () => startRelocating(this.robot)).id = "relocate";
    button("Mute", "The team goes on without its sightings", () => this.mute(true)).id = "mute";
    button("Unmute", "The team uses its sightings again", () => this.mute(false)).id = "unmute";
    this.camera = button("Camera", "Pictures of its camera and its virtual sensors, up to two a second", () => this.toggleCamera());
    this.camera.id = "camera";
    this.lines = button("Line points", "What it takes for paint", () => this.toggleLines());
    this.without = button("Without it", "What the team would see if it were muted, in dashes", () => this.toggleWithout());
    this.without.id = "without";
    this.picture = html("img", "thumbnail", root);
    this.picture.alt = "";
    this.picture.hidden = true;
    this.sensors = html("div", "sensors", root);
    this.facts = html("dl", "robot-facts", root);
  }

  select(robot: number): void {
    if (robot === this.robot) return;
    this.robot = robot;
    this.looksAtCamera = this.looksAtLines = this.leavesOut = false;
    this.picture.hidden = true;
    this.askedAt = -Infinity;
  }

  private mute(muted: boolean): void {
    this.orders.give({ case: "mute", value: { robotId: this.robot, muted } });
  }

  private toggleCamera(): void {
    this.looksAtCamera = !this.looksAtCamera;
    this.askedAt = -Infinity;
    if (!this.looksAtCamera) this.picture.hidden = true;
  }

  private toggleLines(): void {
    this.looksAtLines = !this.looksAtLines;
    this.askedAt = -Infinity;
  }

  private toggleWithout(): void {
    this.leavesOut = !this.leavesOut;
    this.askedAt = -Infinity;
  }

  show(thumbnails: Thumbnail[]): void {
    const mine = thumbnails.filter((one) => one.sample?.robotId === this.robot).at(-1);
    if (!mine || !this.looksAtCamera) return;
    URL.revokeObjectURL(this.url);
    this.url = URL.createObjectURL(new Blob([mine.jpeg as Uint8Array<ArrayBuffer>], { type: "image/jpeg" }));
    this.picture.src = this.url;
    this.picture.hidden = false;
  }

  draw(update: MonitorUpdate, isLive: boolean, nowMs: number): void {
    if (isLive && nowMs - this.askedAt > ASK_AGAIN_MS && (this.looksAtCamera || this.looksAtLines || this.leavesOut)) {
      this.askedAt = nowMs;
      const value = { robotId: this.robot, durationMs: LOOK_MS };
      if (this.looksAtCamera) this.orders.give({ case: "thumbnail", value });
      if (this.leavesOut) this.orders.give({ case: "without", value });
      if (this.looksAtLines) this.orders.give({ case: "linePoints", value });
    }
    this.camera.classList.toggle("on", this.looksAtCamera);
    this.lines.classList.toggle("on", this.looksAtLines);
    this.without.classList.toggle("on", this.leavesOut);
    write(this.title, `Robot ${this.robot}`);
    const row = update.robots.find((one) => one.robotId === this.robot);
    this.drawSensors(row?.sensors);
    const aside = row ? difference(row, update) : {};
    const metres = (value: number | undefined): string => (value === undefined ? format.UNKNOWN : `${value.toFixed(2)} m`);
    const seen = row?.sightings;
    const mate = update.world?.teammates.find((one) => one.robotId === this.robot);
    const trust = mate?.trust ?? row?.explained?.trust ?? NaN;
    const why = format.quarantineWords(mate?.quarantine ?? row?.explained?.quarantine ?? 0);
    this.list([
      ["Its ball against the team's", metres(aside.ball)],
      ["Its place against the team's", metres(aside.posture)],
      ["Sees", seen ? `${format.many(seen.balls.length, "ball")}, ${format.many(seen.obstacles.length, "obstacle")}, ${format.many(seen.posture?.linePoints ?? 0, "line point")}` : format.UNKNOWN],
      ["Trusted", `${format.percent(trust)}${why ? `, in quarantine: ${why}` : ""}`],
      ["Not used of it", rejectedText(row)],
      ["Without it", update.without?.robotId === this.robot ? withoutText(update) : format.UNKNOWN],
      ["Right half", `own ${format.percent(format.halfProbability(mate?.halfLogOdds ?? NaN))}, team ${format.percent(format.halfProbability(mate?.halfLogOddsTeam ?? NaN))}`],
      ["Clock against the leader", row?.explained && row.explained.clockSigmaMs > 0 ? `${row.explained.clockOffsetMs.toFixed(1)} ± ${row.explained.clockSigmaMs.toFixed(1)} ms` : format.UNKNOWN],
      ["Battery", row?.state?.batteryV ? `${row.state.batteryV.toFixed(1)} V` : format.UNKNOWN],
      ["Temperature", row?.state?.cpuTemperatureDegc ? `${row.state.cpuTemperatureDegc.toFixed(0)} °C` : format.UNKNOWN],
      ["Calibration drift", row?.state?.calibrationDriftPx ? `${row.state.calibrationDriftPx.toFixed(1)} px` : format.UNKNOWN],
      ["Agent says", row?.agent?.message || (row?.agent ? "well" : format.UNKNOWN)],
    ]);
  }

  /** One line per virtual sensor: what share of its window has its colours, and whether that triggers it. */
  private drawSensors(sensors: VirtualSensors | undefined): void {
    const readings = sensors?.readings ?? [];
    while (this.sensors.childElementCount > readings.length) this.sensors.lastElementChild?.remove();
    readings.forEach((reading, index) => {
      const line = this.sensors.children[index] ?? this.makeSensor();
      line.classList.toggle("triggered", reading.triggered);
      write(line.children[0]!, reading.name);
      (line.children[1]!.firstElementChild as HTMLElement).style.width = `${reading.value * 100}%`;
      write(line.children[2]!, format.percent(reading.value));
    });
  }

  private makeSensor(): Element {
    const line = html("div", "sensor", this.sensors);
    html("span", "", line);
    html("i", "bar-fill", html("span", "bar-track", line));
    html("b", "", line);
    return line;
  }

  private list(entries: [string, string][]): void {
    entries.forEach(([name, value], index) => {
      const term = this.facts.children[2 * index] ?? html("dt", "", this.facts);
      const text = this.facts.children[2 * index + 1] ?? html("dd", "", this.facts);
      write(term, name);
      write(text, value);
    });
  }
}
