// monitor/web/src/main.ts: the page: updates come in, at most one drawing per screen frame goes out.
import "./style/base.css";
import "./style/bar.css";
import "./style/field.css";
import "./style/timeline.css";
import "./style/side.css";
import "./style/table.css";
import { fromBinary } from "@bufbuild/protobuf";
import { type MonitorUpdate, MonitorUpdateSchema } from "./generated/monitor_pb";
import { BallHint } from "./ball_hint";
import { connect, liveAddress } from "./connection";
import { byId, set, write } from "./dom";
import { Explainer } from "./explainer";
import { FieldView } from "./field_view";
import { History, LIVE_BOUNDS, momentOf, RECORDING_BOUNDS, updatesIn } from "./history";
import { bindKeys, type Commands, makeKeyList } from "./keys";
import { Orders, takeToken } from "./orders";
import { Player } from "./player";
import { Plots } from "./plots";
import { drawGame, makeRefereeButtons } from "./referee_view";
import { Relocate } from "./relocate";
import { RobotCard } from "./robot_card";
import { Roving } from "./roving";
import { markOf, noticeOf, type Scene, sceneOf } from "./scene";
import { BallCard, drawLead, EventLog, ProcessCard } from "./side_view";
import { TableView } from "./table_view";
import { TimelineView } from "./timeline_view";

/** Ages go on when nothing arrives, so the page is drawn now and then without news. */
const IDLE_DRAW_MS = 100;
const RETRY_MS = 1000;

const MARK_WORDS: Record<string, string> = {
  LIVE: "This is now",
  "NO DATA": "What is shown is old: the field says why",
  PAUSED: "A moment of the past, standing; l goes back to live",
  REPLAY: "The past, running; l goes back to live",
};

const field = new FieldView(byId("field"));
const ball = new BallCard(byId("ball"));
const processes = new ProcessCard(byId("processes"));
const log = new EventLog(byId("log"));

let scene: Scene | undefined;
let newest: MonitorUpdate | undefined;
let receivedAt = 0;
let connected = false;
let isDrawingPlanned = false;
let isLoading = false; // a recording: once
let loadTrouble = "";
let raw: "none" | "all" | "chosen" = "none";
let shownIndex = -1;
let shown: MonitorUpdate | undefined;
let history = new History(LIVE_BOUNDS);
let player = new Player(history, false);

const orders = new Orders(byId("actions"), (bytes) => send(bytes), takeToken(location, window.history, sessionStorage));
const relocate = new Relocate(field, orders);
const ballHint = new BallHint(field, orders);
const robotCard = new RobotCard(byId("robot"), orders, startRelocating);
const table = new TableView(byId("robots"), (robot) => robotCard.select(robot), (robot) => {
  robotCard.select(robot);
  showTab("robot");
});
const bar = new Roving(byId("bar"), "", "[data-why]");
const explainer = new Explainer(document.body);
makeKeyList(byId("keys-dialog"));
// Who clicks goes on with the page's keys, in which a button or a box to tick has no part.
document.addEventListener("click", (event) => {
  if (event.detail === 0) return; // by keyboard
  // A box is given the focus after the click on its label.
  setTimeout(() => {
    const one = document.activeElement;
    if (one instanceof HTMLElement && one.matches('button, [type="checkbox"]') && !one.closest("dialog")) one.blur();
  });
});
const plots = new Plots(byId("plots"));
makeRefereeButtons(byId("referee"), orders);
let timeline = makeTimeline();

function makeTimeline(): TimelineView {
  return new TimelineView(player, history, { changed: planDrawing, bookmark });
}

/** The update to show: the newest, or one of the past. */
function chosen(nowMs: number): { update: MonitorUpdate | undefined; since: number } {
  const time = player.timeAt(nowMs);
  if (time === undefined) return { update: newest, since: nowMs - receivedAt };
  const index = history.indexAt(time);
  if (index !== shownIndex) {
    shownIndex = index;
    shown = history.decode(index);
  }
  return { update: shown, since: player.mode === "replay" && shown ? Math.max(time - Number(shown.stampNs) / 1e6, 0) : 0 };
}

function drawMark(update: MonitorUpdate | undefined, since: number): void {
  const state = player.mode;
  const mark = state === "live" ? markOf(update, connected, since) : { live: true, reason: update?.silence ?? "" };
  const word = state === "live" ? (mark.live ? "LIVE" : "NO DATA") : state.toUpperCase();
  set(byId("mark"), { "data-state": state === "live" && !mark.live ? "none" : state, "data-why": MARK_WORDS[word] ?? "" });
  write(byId("mark"), word);
  write(byId("silence"), loadTrouble || mark.reason);
  write(byId("notice"), noticeOf(update));
  set(document.body, { class: state === "live" && mark.live ? "live" : `not-live ${state}` });
}

function draw(): void {
  isDrawingPlanned = false;
  const now = performance.now();
  const { update, since } = chosen(now);
  drawMark(update, since);
  timeline.draw(player.timeAt(now));
  if (player.mode === "replay") planDrawing();
  if (!update) return;
  scene = sceneOf(update, since);
  field.draw(scene, update, raw === "chosen" ? robotCard.robot : raw);
  table.draw(update, since, robotCard.robot);
  ball.draw(scene, update.hint);
  processes.draw(update);
  drawLead(update, since);
  drawGame(update);
  bar.keepStop();
  explainer.draw();
  log.draw(player.mode === "live" ? undefined : update.stampNs);
  robotCard.draw(update, player.mode === "live", now);
  plots.take(update);
  if (newest) orders.draw(newest.actions);
  set(document.body, { "data-drawn-world": String(update.world?.stampNs ?? 0), "data-drawn-update": String(update.stampNs) });
}

function planDrawing(): void {
  if (isDrawingPlanned) return;
  isDrawingPlanned = true;
  requestAnimationFrame(draw);
}

function showTab(name: string): void {
  for (const button of byId("tabs").querySelectorAll("button")) button.classList.toggle("on", button.dataset["tab"] === name);
  for (const tab of document.querySelectorAll<HTMLElement>(".tab")) tab.hidden = tab.dataset["tab"] !== name;
}

function flip(): void {
  field.flip();
  planDrawing();
}

function cycleRaw(): void {
  raw = raw === "none" ? "all" : raw === "all" ? "chosen" : "none";
  write(byId("raw"), `Raw: ${raw}`);
  planDrawing();
}

function setTheme(theme: string): void {
  set(document.documentElement, { "data-theme": theme });
  write(byId("theme"), theme === "light" ? "Dark" : "Light");
  localStorage.setItem("teamsight.theme", theme);
}

function toggleTheme(): void {
  setTheme(document.documentElement.dataset["theme"] === "light" ? "dark" : "light");
}

function startRelocating(robot: number): void {
  ballHint.stop();
  relocate.start(robot, scene?.robots.find((one) => one.id === robot));
}

function startHinting(): void {
  relocate.stop();
  ballHint.start(scene?.balls[0]);
}

function putToolsAway(): void {
  relocate.stop();
  ballHint.stop();
}

function showKeys(): void {
  const dialog = byId("keys-dialog") as HTMLDialogElement;
  if (dialog.open) dialog.close();
  else dialog.showModal();
}

function bookmark(): void {
  orders.give({ case: "bookmark", value: { text: "" } });
}

const commands: Commands = {
  flip,
  cycleRaw,
  toggleTheme,
  bookmark,
  showTab,
  relocate: () => startRelocating(robotCard.robot),
  hint: startHinting,
  giveUp: putToolsAway,
  choose: (step) => robotCard.select(Math.min(Math.max(robotCard.robot + step, 1), 16)),
  showKeys,
  player: () => player,
  changed: planDrawing,
};
bindKeys(commands);
byId("flip").addEventListener("click", flip);
byId("raw").addEventListener("click", cycleRaw);
byId("ball-hint").addEventListener("click", startHinting);
byId("theme").addEventListener("click", toggleTheme);
byId("show-keys").addEventListener("click", showKeys);
byId("tabs").addEventListener("click", (event) => {
  const button = (event.target as Element).closest("button");
  if (button?.dataset["tab"]) showTab(button.dataset["tab"]);
});
byId("token-form").addEventListener("submit", () => orders.accept((byId("token") as HTMLInputElement).value));
setTheme(localStorage.getItem("teamsight.theme") ?? "dark");

async function fetchRecording(address: string): Promise<Uint8Array> {
  for (;;) {
    try {
      const answer = await fetch(`${address}${orders.token ? `?token=${orders.token}` : ""}`);
      if (!answer.ok) throw new Error(`the station answers ${answer.status}`);
      const body = new Uint8Array(await answer.arrayBuffer());
      loadTrouble = "";
      return body;
    } catch (error) {
      loadTrouble = `The recording does not arrive (${(error as Error).message}): asked for again every second`;
      await new Promise((resolve) => setTimeout(resolve, RETRY_MS));
    }
  }
}

/** The station shows a recording: all of it is fetched, and there is no present. */
async function loadRecording(address: string, dateMinusStampNs: bigint): Promise<void> {
  if (isLoading || player.isRecording) return;
  isLoading = true;
  const body = await fetchRecording(address);
  history = new History(RECORDING_BOUNDS);
  player = new Player(history, true);
  set(document.body, { "data-shows": "recording" });
  orders.close("This is a recording: nobody takes orders or bookmarks");
  shownIndex = -1;
  log.clear();
  for (const bytes of updatesIn(body)) {
    const update = fromBinary(MonitorUpdateSchema, bytes);
    history.push(momentOf(update, bytes));
    log.add(update.events, update.stampNs, dateMinusStampNs);
  }
  timeline = makeTimeline();
  player.seek(history.firstMs ?? 0, performance.now());
  player.play(performance.now());
  planDrawing();
}

function take(update: MonitorUpdate, bytes: Uint8Array): void {
  if (update.field) {
    field.setField(update.field);
    write(byId("team"), update.team);
    write(byId("where"), ` · ${update.field.name}${update.recording ? "" : ` · domain ${update.domainId}`}`);
  }
  if (update.refused) orders.refuse(update.refused);
  if (update.recording) {
    void loadRecording(update.recording, update.dateMinusStampNs);
    return;
  }
  robotCard.show(update.thumbnails);
  log.add(update.events, update.stampNs);
  newest = update;
  receivedAt = performance.now();
  history.push(momentOf(update, bytes));
  planDrawing();
}

const send = connect(() => liveAddress(window.location, orders.token), {
  onOpen: () => {
    connected = true;
    if (!player.isRecording) log.clear();
  },
  onUpdate: take,
  onClose: () => {
    connected = false;
    planDrawing();
  },
  onTokenNeeded: () => orders.ask(),
});

setInterval(planDrawing, IDLE_DRAW_MS);
planDrawing();
