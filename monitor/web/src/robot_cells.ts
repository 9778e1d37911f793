// monitor/web/src/robot_cells.ts: what the table says of one robot, column by column, and why; no DOM.
import { create } from "@bufbuild/protobuf";
import { type MonitorUpdate, type RobotRow, RobotRowSchema } from "./generated/monitor_pb";
import { type ExplainedRobot, PostureStatus, type WorldTeammate } from "./generated/recording_pb";
import * as format from "./format";

/** What a cell says and how it looks. */
export interface Cell {
  text: string;
  tone: "good" | "warn" | "bad" | "dim" | "";
  /** More of it in words; missing: what the column means. */
  why?: string;
}

export interface Column {
  head: string;
  /** Of the table's width; what a game is decided by is written larger. */
  width: number;
  decides?: boolean;
  numeric?: boolean;
  /** What it means. */
  why: string;
  cell(row: RobotRow, told: Told, sinceUpdateMs: number): Cell;
}

/** What the world model has of a robot. */
export interface Told {
  mate?: WorldTeammate | undefined;
  /** Of a game that was imported: nobody has judged its robots, and none was heard. */
  imported: boolean;
}

const cell = (text: string, tone: Cell["tone"] = "", why?: string): Cell => (why ? { text, tone, why } : { text, tone });
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

export function linkCell(row: RobotRow, sinceUpdateMs: number, imported = false): Cell {
  const ageMs = row.ageMs + sinceUpdateMs;
  if (isToldOf(row) && imported) return cell("imported", "dim", "The game was imported: it holds where robots stood, and nothing that they said");
  if (isToldOf(row)) return cell("not heard", "dim", "Known from the world model; the station has not heard it itself");
  if (row.duplicate) return cell("id used twice", "bad", "Two processes speak under this id");
  if (!row.alive) return cell(`lost ${ageMs < 60_000 ? `${(ageMs / 1000).toFixed(1)} s` : format.age(ageMs)}`, "bad", "It fell silent so long ago");
  const tones = { fresh: "good", late: "warn", lost: "bad" } as const;
  return cell(format.age(ageMs), tones[format.freshness(ageMs)]);
}

function lossCell(row: RobotRow): Cell {
  if (row.received === 0n) return DASH;
  return cell(format.percent(row.loss), row.loss > 0.1 ? "bad" : row.loss > 0.02 ? "warn" : "");
}

export function postureCell(row: RobotRow): Cell {
  const report = row.state?.posture;
  if (!report) return DASH;
  if (report.status === PostureStatus.POSTURE_LOST) return cell("lost", "bad", `It does not know where it is; ${report.linePoints} line points`);
  const [xx = NaN, , , yy = NaN] = report.posture?.cov ?? [];
  const centimetres = Math.sqrt(Math.max(xx, yy)) * 100;
  const sigma = `±${centimetres.toFixed(centimetres < 1 ? 1 : 0)} cm`;
  const fit = `${format.percent(report.inlierRatio)} of ${report.linePoints} line points fit`;
  return report.status === PostureStatus.POSTURE_OK
    ? cell(`ok ${sigma}`, "good", fit)
    : cell(`ambiguous ${sigma}`, "warn", `It may stand elsewhere as well; ${fit}`);
}

/** Where the world model has a robot that was not heard itself. */
export function placeCell(mate: WorldTeammate | undefined): Cell {
  if (!mate?.posture || mate.status === PostureStatus.POSTURE_LOST) return DASH;
  const { xM, yM } = mate.posture;
  return cell(`at ${format.signed(xM)}, ${format.signed(yM)} m`, "dim", "Where the world model has it");
}

export function halfCell(row: RobotRow): Cell {
  const report = row.state?.posture;
  if (!report || report.status === PostureStatus.POSTURE_LOST) return DASH;
  const right = format.halfProbability(report.halfLogOdds);
  return cell(format.percent(right), right > 0.9 ? "good" : right < 0.5 ? "bad" : "warn");
}

export function cameraCell(row: RobotRow): Cell {
  if (!row.state) return DASH;
  if (row.state.cameraLost) return cell("lost", "bad", "Its camera gives no frames");
  const frameAge = row.agent && row.agent.frameAgeMs >= 0 ? `Newest frame ${format.age(row.agent.frameAgeMs)} old` : undefined;
  return cell(`${row.state.frameRateHz.toFixed(0)} Hz`, "", frameAge);
}

export function trustCell(row: RobotRow, mate: WorldTeammate | undefined): Cell {
  if (row.state?.muted) return cell("muted", "warn", "By the operator: it says nothing of what it sees");
  const trust = mate?.trust ?? row.explained?.trust;
  if (trust === undefined) return DASH;
  const code = mate?.quarantine ?? row.explained?.quarantine ?? 0;
  const why = format.quarantine(code);
  if (why) return cell(why, "bad", `In quarantine: ${format.quarantineWords(code)}. The team goes on without what it sees`);
  return cell(format.percent(trust), trust > 0.5 ? "good" : "warn");
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
  return cell(`${format.count(first.count)} ${first.name}${more.length > 0 ? " +" : ""}`, "", `Not used of it: ${rejectedText(row)}`);
}

/** All of it in words. */
export function rejectedText(row: RobotRow | undefined): string {
  const why = row?.explained;
  if (!why) return format.UNKNOWN;
  const some = rejectedBy(why).map(({ words, count }) => `${format.count(count)} ${words}`);
  return `${some.length > 0 ? some.join(", ") : "nothing"} (used: ${format.count(why.accepted)})`;
}

/** The computer's load and, where it measures that, its temperature. */
export function loadCell(row: RobotRow): Cell {
  if (!row.state) return DASH;
  const load = format.percent(row.state.cpuLoad);
  const degrees = row.state.cpuTemperatureDegc;
  const tone = degrees > 90 ? "bad" : row.state.cpuLoad > 0.9 || degrees > 80 ? "warn" : "";
  return degrees ? cell(`${load} ${degrees.toFixed(0)}°`, tone) : cell(load, tone, "Share of a core; the temperature is not measured");
}

function latencyCell(row: RobotRow): Cell {
  if (row.latencyP50Ms < 0) return cell(format.UNKNOWN, "dim", "Its clock cannot be compared with the station's");
  const tone = row.latencyP95Ms > 200 ? "bad" : row.latencyP95Ms > 100 ? "warn" : "";
  return cell(`${format.latency(row.latencyP50Ms)} / ${format.latency(row.latencyP95Ms)}`, tone);
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

function versionCell(row: RobotRow): Cell {
  if (!row.state) return DASH;
  const version = row.state.softwareVersion || format.UNKNOWN;
  return row.otherVersion ? cell(version, "warn", `${version} is not the station's version: install the same packages everywhere`) : cell(version, "dim");
}

/** What decides a game first, then what explains it. */
export const COLUMNS: Column[] = [
  { head: "Robot", width: 3.3, decides: true, why: "Its number; Enter or a click shows it close up", cell: (row) => cell(String(row.robotId)) },
  { head: "Heard", width: 7.1, decides: true, why: "How long ago the newest word of it came", cell: (row, told, since) => linkCell(row, since, told.imported) },
  { head: "Loss", width: 4.1, decides: true, numeric: true, why: "Share of its frames that never came, over the last seconds", cell: (row) => lossCell(row) },
  { head: "Posture", width: 10.6, decides: true, why: "Whether it knows where it stands, and how well", cell: (row, told) => (isToldOf(row) ? placeCell(told.mate) : postureCell(row)) },
  { head: "Half", width: 4.1, decides: true, numeric: true, why: "Probability that it is not on the mirrored place, by its own evidence", cell: (row) => halfCell(row) },
  { head: "Ball", width: 3.8, decides: true, why: "Whether it sees or has the ball", cell: ballCell },
  { head: "Trust", width: 6.25, decides: true, why: "How far the team believes what it sees, or why not", cell: (row, told) => (told.imported ? DASH : trustCell(row, told.mate)) },
  { head: "Not used", width: 7.2, why: "What the fusion did not use of it, most frequent reason first", cell: (row) => rejectedCell(row) },
  { head: "Latency ms", width: 6.2, numeric: true, why: "Exposure to arrival, half and 95 % of the frames", cell: latencyCell },
  { head: "Rate", width: 3.4, numeric: true, why: "Frames that arrived, over the last seconds", cell: (row) => (row.alive ? cell(`${row.rateHz.toFixed(0)} Hz`) : DASH) },
  { head: "Camera", width: 4.1, numeric: true, why: "Frames that its camera gives", cell: (row) => cameraCell(row) },
  { head: "Clock", width: 5.4, numeric: true, why: "Its clock against the leader's", cell: (row) => clockCell(row) },
  { head: "Battery", width: 4, numeric: true, why: "Its battery, as it measures it", cell: (row) => (row.state?.batteryV ? cell(`${row.state.batteryV.toFixed(1)} V`) : DASH) },
  { head: "Drift", width: 4.05, numeric: true, why: "How far its camera seems to be off its calibration, pixels", cell: (row) => (row.state?.calibrationDriftPx ? cell(`${row.state.calibrationDriftPx.toFixed(1)} px`) : DASH) },
  { head: "Load", width: 6, numeric: true, why: "Share of a core; hottest part of the computer, °C", cell: (row) => loadCell(row) },
  { head: "Version", width: 3.9, why: "The software that it runs", cell: (row) => versionCell(row) },
];
