// monitor/web/src/table_view.ts: one row per robot. Columns keep their width, rows their height.
import { create } from "@bufbuild/protobuf";
import { type MonitorUpdate, type RobotRow, RobotRowSchema } from "./generated/monitor_pb";
import { type ExplainedRobot, PostureStatus, type WorldTeammate } from "./generated/recording_pb";
import { html, set, write } from "./dom";
import * as format from "./format";

/** What a cell says and how it looks. */
export interface Cell {
  text: string;
  tone: "good" | "warn" | "bad" | "dim" | "";
  title?: string;
}

interface Column {
  head: string;
  width: number;
  numeric?: boolean;
  cell(row: RobotRow, mate: WorldTeammate | undefined, sinceUpdateMs: number): Cell;
}

const cell = (text: string, tone: Cell["tone"] = "", title?: string): Cell => (title ? { text, tone, title } : { text, tone });
const DASH = cell(format.UNKNOWN, "dim");

/** Of a robot that the station knows from the world model alone. */
export const isToldOf = (row: RobotRow) => !row.alive && row.received === 0n && row.ageMs === 0;

/** The robots that were heard, and those that only the world model has, by their ids. */
export function rowsOf(update: MonitorUpdate): RobotRow[] {
  const heard = new Set(update.robots.map((row) => row.robotId));
  const told = (update.world?.teammates ?? []).filter((mate) => !heard.has(mate.robotId));
  if (told.length === 0) return update.robots;
  const rows = told.map((mate) => create(RobotRowSchema, { robotId: mate.robotId, latencyP50Ms: -1, latencyP95Ms: -1 }));
  return [...update.robots, ...rows].sort((a, b) => a.robotId - b.robotId);
}

export function linkCell(row: RobotRow, sinceUpdateMs: number): Cell {
  const ageMs = row.ageMs + sinceUpdateMs;
  if (isToldOf(row)) return cell("not itself", "dim", "Known from the world model; the station has not heard it itself");
  if (row.duplicate) return cell("id used twice", "bad", "Two processes speak under this id");
  if (!row.alive) return cell(`lost ${ageMs < 60_000 ? `${(ageMs / 1000).toFixed(1)} s` : format.age(ageMs)}`, "bad");
  const tones = { fresh: "good", late: "warn", lost: "bad" } as const;
  return cell(format.age(ageMs), tones[format.freshness(ageMs)]);
}

export function postureCell(row: RobotRow): Cell {
  const report = row.state?.posture;
  if (!report) return DASH;
  if (report.status === PostureStatus.POSTURE_LOST) return cell("lost", "bad", `${report.linePoints} line points`);
  const [xx = NaN, , , yy = NaN] = report.posture?.cov ?? [];
  const centimetres = Math.sqrt(Math.max(xx, yy)) * 100;
  const sigma = `±${centimetres.toFixed(centimetres < 1 ? 1 : 0)} cm`;
  const title = `${format.percent(report.inlierRatio)} of ${report.linePoints} line points fit`;
  return report.status === PostureStatus.POSTURE_OK
    ? cell(`ok ${sigma}`, "good", title)
    : cell(`ambiguous ${sigma}`, "warn", title);
}

export function halfCell(row: RobotRow): Cell {
  const report = row.state?.posture;
  if (!report || report.status === PostureStatus.POSTURE_LOST) return DASH;
  const right = format.halfProbability(report.halfLogOdds);
  const title = "Probability that it is not on the mirrored place, by its own evidence";
  return cell(format.percent(right), right > 0.9 ? "good" : right < 0.5 ? "bad" : "warn", title);
}

export function cameraCell(row: RobotRow): Cell {
  if (!row.state) return DASH;
  if (row.state.cameraLost) return cell("lost", "bad");
  const frameAge = row.agent && row.agent.frameAgeMs >= 0 ? `newest frame ${format.age(row.agent.frameAgeMs)} old` : undefined;
  return cell(`${row.state.frameRateHz.toFixed(0)} Hz`, "", frameAge);
}

export function trustCell(row: RobotRow, mate: WorldTeammate | undefined): Cell {
  if (row.state?.muted) return cell("muted", "warn", "By the operator: it says nothing of what it sees");
  const trust = mate?.trust ?? row.explained?.trust;
  if (trust === undefined) return DASH;
  const why = format.quarantine(mate?.quarantine ?? row.explained?.quarantine ?? 0);
  return why ? cell(why, "bad") : cell(format.percent(trust), trust > 0.5 ? "good" : "warn");
}

/** Why the fusion did not use samples of a robot: for the table, and in words. */
interface Rejected {
  name: string;
  words: string;
  count: number;
}

/** Most frequent first; only what happened. */
function rejectedBy(why: ExplainedRobot): Rejected[] {
  const reasons: Rejected[] = [
    { name: "gate", words: "sightings fitted nothing", count: why.rejectedGate },
    { name: "late", words: "frames too late, early or many", count: why.rejectedLate },
    { name: "twice", words: "frames twice", count: why.rejectedDuplicate },
    { name: "posture", words: "frames without a posture", count: why.rejectedPosture },
  ];
  return reasons.filter(({ count }) => count > 0).sort((a, b) => b.count - a.count);
}

/** What the fusion did not use, by reason. */
export function rejectedCell(row: RobotRow): Cell {
  if (!row.explained) return DASH;
  const [first, ...more] = rejectedBy(row.explained);
  if (!first) return cell("0", "dim");
  return cell(`${format.count(first.count)} ${first.name}${more.length > 0 ? " +" : ""}`, "", rejectedText(row));
}

/** All of it in words. */
export function rejectedText(row: RobotRow | undefined): string {
  const why = row?.explained;
  if (!why) return format.UNKNOWN;
  const some = rejectedBy(why).map(({ words, count }) => `${format.count(count)} ${words}`);
  return `${some.length > 0 ? some.join(", ") : "nothing"} (used: ${format.count(why.accepted)})`;
}

const COLUMNS: Column[] = [
  { head: "Robot", width: 4.6, cell: (row) => cell(String(row.robotId)) },
  { head: "Heard", width: 8, cell: (row, _mate, since) => linkCell(row, since) },
  { head: "Rate", width: 5.5, numeric: true, cell: (row) => (row.alive ? cell(`${row.rateHz.toFixed(0)} Hz`) : DASH) },
  { head: "Loss", width: 5, numeric: true, cell: (row) => (row.received > 0n ? cell(format.percent(row.loss), row.loss > 0.1 ? "bad" : row.loss > 0.02 ? "warn" : "") : DASH) },
  { head: "Latency", width: 10.2, numeric: true, cell: latencyCell },
  { head: "Posture", width: 15.4, cell: (row) => postureCell(row) },
  { head: "Half", width: 5.5, numeric: true, cell: (row) => halfCell(row) },
  { head: "Ball", width: 6, cell: ballCell },
  { head: "Camera", width: 6, numeric: true, cell: (row) => cameraCell(row) },
  { head: "Trust", width: 8, cell: (row, mate) => trustCell(row, mate) },
  { head: "Not used", width: 9.6, cell: (row) => rejectedCell(row) },
  { head: "Clock", width: 6.8, numeric: true, cell: (row) => clockCell(row) },
  { head: "Battery", width: 6.2, numeric: true, cell: (row) => (row.state?.batteryV ? cell(`${row.state.batteryV.toFixed(1)} V`) : DASH) },
  { head: "Drift", width: 5.6, numeric: true, cell: (row) => (row.state?.calibrationDriftPx ? cell(`${row.state.calibrationDriftPx.toFixed(1)} px`) : DASH) },
  { head: "Load", width: 7.6, numeric: true, cell: (row) => loadCell(row) },
  { head: "Version", width: 5.8, cell: (row) => (row.state ? cell(row.state.softwareVersion || format.UNKNOWN, row.otherVersion ? "warn" : "dim", row.otherVersion ? "Not the station's version" : "") : DASH) },
];

/** The computer's load and, where it measures that, its temperature. */
export function loadCell(row: RobotRow): Cell {
  if (!row.state) return DASH;
  const load = format.percent(row.state.cpuLoad);
  const degrees = row.state.cpuTemperatureDegc;
  const tone = degrees > 90 ? "bad" : row.state.cpuLoad > 0.9 || degrees > 80 ? "warn" : "";
  return degrees ? cell(`${load} ${degrees.toFixed(0)}°`, tone, "Share of a core; hottest part of the computer, °C") : cell(load, tone, "Temperature not measured");
}

function latencyCell(row: RobotRow): Cell {
  if (row.latencyP50Ms < 0) return cell(format.UNKNOWN, "dim", "Its clock cannot be compared with the station's");
  const tone = row.latencyP95Ms > 200 ? "bad" : row.latencyP95Ms > 100 ? "warn" : "";
  return cell(`${format.latency(row.latencyP50Ms)} / ${format.latency(row.latencyP95Ms)} ms`, tone, "Exposure to arrival, half and 95 % of the frames");
}

/** Against the leader's clock; hosts that were started at other times differ by days. */
export function clockCell(row: RobotRow): Cell {
  const why = row.explained;
  if (!why || why.clockSigmaMs <= 0) return DASH;
  const far = Math.abs(why.clockOffsetMs) >= 10_000;
  const text = far ? `${(why.clockOffsetMs / 1000).toFixed(0)} s` : `${why.clockOffsetMs.toFixed(1)} ms`;
  return cell(text, why.clockSigmaMs > 5 ? "warn" : "", `${why.clockOffsetMs.toFixed(2)} ± ${why.clockSigmaMs.toFixed(2)} ms against the leader's clock`);
}

function ballCell(row: RobotRow): Cell {
  if (!row.state) return DASH;
  if (row.state.hasBall) return cell("has it", "good");
  return row.state.seesBall ? cell("sees it", "good") : DASH;
}

function stateOf(row: RobotRow, since: number): string {
  if (isToldOf(row)) return "told";
  return row.alive ? format.freshness(row.ageMs + since) : "lost";
}

/** Rows that are always there, so that nothing jumps when a robot joins. */
const LEAST_ROWS = 5;

export class TableView {
  private readonly body: HTMLTableSectionElement;

  constructor(table: HTMLElement, choose: (robot: number) => void) {
    const group = html("colgroup", "", table);
    const total = COLUMNS.reduce((sum, column) => sum + column.width, 0);
    for (const column of COLUMNS) html("col", "", group).style.width = `${(100 * column.width) / total}%`;
    const head = html("tr", "", html("thead", "", table));
    for (const column of COLUMNS) html("th", column.numeric ? "numeric" : "", head, column.head);
    this.body = html("tbody", "", table);
    this.body.addEventListener("click", (event) => {
      const line = (event.target as Element).closest("tr");
      const robot = Number(line?.dataset["robot"] ?? 0);
      if (robot > 0) choose(robot);
    });
  }

  draw(update: MonitorUpdate, sinceUpdateMs: number, chosen: number): void {
    // Nobody has judged the robots of a game that was imported.
    const judged = update.world?.sample?.robotId ? update.world.teammates : [];
    const mates = new Map(judged.map((mate) => [mate.robotId, mate]));
    const rows = rowsOf(update);
    const count = Math.max(rows.length, LEAST_ROWS);
    while (this.body.rows.length < count) this.addRow();
    while (this.body.rows.length > count) this.body.deleteRow(-1);
    for (let i = 0; i < count; ++i) {
      const line = this.body.rows[i];
      if (!line) continue;
      this.fill(line, rows[i], mates, sinceUpdateMs);
      line.setAttribute("aria-selected", String(rows[i]?.robotId === chosen));
    }
  }

  private addRow(): void {
    const line = html("tr", "", this.body);
    for (const column of COLUMNS) html("span", "", html("td", column.numeric ? "numeric" : "", line));
  }

  private fill(line: HTMLTableRowElement, row: RobotRow | undefined, mates: Map<number, WorldTeammate>, since: number): void {
    const state = row ? stateOf(row, since) : "empty";
    set(line, { class: state, "data-robot": row?.robotId ?? 0 });
    COLUMNS.forEach((column, index) => {
      const place = line.cells[index]?.firstElementChild;
      if (!place) return;
      const content = row ? column.cell(row, mates.get(row.robotId), since) : cell("");
      write(place, content.text);
      set(place, { class: content.tone, title: content.title ?? "" });
    });
  }
}
