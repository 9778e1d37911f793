// monitor/web/src/referee_view.ts: the game in the bar on top, and the referee's commands by hand.
import type { MonitorUpdate, RecorderReport, RefereeReport } from "./generated/monitor_pb";
import type { Diagnostics } from "./generated/recording_pb";
import { byId, html, set, write } from "./dom";
import * as format from "./format";
import type { Orders } from "./orders";

const PHASES = ["", "before the game", "1st half", "half time", "2nd half", "over", "shoot-out"];
const PIECES = ["", "kick-off", "free kick", "goal kick", "throw-in", "corner", "penalty", "drop ball", "parking"];

/** What is played now, in words; without box and command nobody has told the robots to stop either. */
export function gameText(report: RefereeReport | undefined): string {
  const state = report?.state;
  if (!state || (!report.hasBox && !report.lastCommand)) return "no game";
  const piece = PIECES[state.piece] ?? "";
  if (piece) return state.piece < 7 ? `${state.pieceIsOurs ? "our" : "their"} ${piece}` : piece;
  return state.running ? "running" : "stopped";
}

/** The last command and how long ago it came. */
export function commandText(report: RefereeReport | undefined): string {
  if (!report?.lastCommand) return report?.hasBox ? "no command yet" : "no referee box";
  return `${report.lastCommand} · ${format.age(report.state?.commandAgeMs ?? NaN)} ago`;
}

/** The phase and the last command; said once where the command was the phase. */
export function courseText(report: RefereeReport | undefined): string {
  const phase = PHASES[report?.state?.phase ?? 0] ?? "";
  return phase && phase !== report?.lastCommand ? `${phase} · ${commandText(report)}` : commandText(report);
}

/** What all processes together send, bit/s, as each measures itself; undefined: none says. */
export function bitRate(update: MonitorUpdate): number | undefined {
  const all = speakers(update);
  return all.length === 0 ? undefined : all.reduce((sum, process) => sum + process.wireBps, 0);
}

/** What is left out because the air is full, in the words of whoever leaves out most; empty: nothing. */
export function thriftText(update: MonitorUpdate): string {
  const most = speakers(update).reduce((one, other) => Math.max(one, other.thrift), 0);
  return ["", "fewer diagnostics", "no raw obstacles far from the ball", "world model at 15 Hz", "no raw obstacles"][most] ?? "";
}

/** Whether everybody who is heard speaks with DDS Security on; undefined: nobody is heard. */
export function isSecured(update: MonitorUpdate): boolean | undefined {
  const all = speakers(update);
  return all.length === 0 ? undefined : all.every((process) => process.secured);
}

function speakers(update: MonitorUpdate): Diagnostics[] {
  const agents = update.robots.flatMap((row) => (row.agent && row.alive ? [row.agent] : []));
  return [...agents, ...update.processes];
}

/** The referee box, and how often it hears what the world is like. */
export function boxText(report: RefereeReport | undefined): string {
  if (!report?.hasBox) return "no box";
  return report.state?.boxConnected ? `box ${report.worldStateHz.toFixed(0)} Hz` : "box away";
}

export function recorderText(report: RecorderReport | undefined): string {
  if (!report) return "not recording";
  if (report.problem) return "disk refuses";
  return report.dropped > 0n ? `rec, ${format.count(report.dropped)} lost` : `rec ${(Number(report.bytes) / 1e6).toFixed(0)} MB`;
}

export function drawGame(update: MonitorUpdate): void {
  const report = update.referee;
  const state = report?.state;
  write(byId("score"), `${state?.goalsOwn ?? 0} : ${state?.goalsOpponent ?? 0}`);
  write(byId("game"), gameText(report));
  set(byId("game"), { class: state?.running ? "running" : "" });
  const course = courseText(report);
  write(byId("course"), course);
  set(byId("course"), { "data-why": `What the referee said last: ${course}` });
  const lamp = (id: string, tone: string, text: string, why: string): void => {
    const root = byId(id);
    set(root, { class: `lamp ${id === "box" || id === "air" ? "decides " : ""}${tone}`, "data-why": why });
    write(root, text);
  };
  const hz = report?.worldStateHz ?? 0;
  const connected = state?.boxConnected ?? false;
  lamp("box", !report?.hasBox ? "off" : !connected ? "bad" : hz >= 10 ? "good" : "warn", boxText(report), "World state to the referee box: 10 Hz or more is wanted");
  const bits = bitRate(update);
  const megabits = (bits ?? 0) / 1e6;
  const thrift = thriftText(update);
  const airText = bits === undefined ? "air –" : `air ${megabits.toFixed(2)} of 2.2`;
  lamp("air", bits === undefined ? "off" : megabits > 2.2 ? "bad" : megabits > 2.0 || thrift ? "warn" : "good", thrift ? `${airText} ↓` : airText, `What the team sends, Mbit/s with headers; the league's limit is 2.2. Left out to keep within it: ${thrift || "nothing"}`);
  const secured = isSecured(update);
  lamp("security", secured ? "good" : "off", secured === undefined ? "security –" : secured ? "secured" : "security off", secured ? "Only who has the team's keys can speak or listen" : "Anybody on this network can speak for a robot; teamsight keys makes the team's keys");
  const recorder = update.recorder;
  lamp("recorder", !recorder ? "off" : recorder.problem || recorder.dropped > 0n ? "bad" : "good", recorderText(recorder), recorder?.problem || recorder?.file || "Start the station with --record to record");
}

const BUTTONS: [string, string, boolean][] = [
  ["START", "Start", false],
  ["STOP", "Stop", false],
  ["DROP_BALL", "Drop ball", false],
  ["PARK", "Park", false],
  ["KICKOFF", "Kick-off", true],
  ["FREEKICK", "Free kick", true],
  ["GOALKICK", "Goal kick", true],
  ["THROWIN", "Throw-in", true],
  ["CORNER", "Corner", true],
  ["PENALTY", "Penalty", true],
  ["GOAL", "Goal", true],
  ["SUBGOAL", "Goal denied", true],
  ["FIRST_HALF", "1st half", false],
  ["HALF_TIME", "Half time", false],
  ["SECOND_HALF", "2nd half", false],
  ["END_GAME", "End", false],
];

/** Two columns; where it matters whose it is, ours is on the left and theirs on the right. */
export function makeRefereeButtons(root: HTMLElement, orders: Orders): void {
  for (const [command, text, hasSide] of BUTTONS) {
    const add = (label: string, side: number, tone: string): void => {
      const button = html("button", `tool ${tone}`, root, label);
      button.type = "button";
      button.dataset["command"] = command;
      button.addEventListener("click", () => orders.give({ case: "referee", value: { command, side } }));
    };
    if (!hasSide) add(text, 0, command === "STOP" ? "stop" : "");
    else {
      add(`${text} us`, 1, "ours");
      add(`${text} them`, 2, "theirs");
    }
  }
}
