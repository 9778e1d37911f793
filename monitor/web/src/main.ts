// monitor/web/src/main.ts: the page: updates come in, at most one drawing per screen frame goes out.
import "./style.css";
import type { MonitorUpdate } from "./generated/monitor_pb";
import { connect, liveAddress } from "./connection";
import { byId, set, write } from "./dom";
import { FieldView } from "./field_view";
import { markOf, sceneOf } from "./scene";
import { BallCard, drawLead, EventLog, ProcessCard } from "./side_view";
import { TableView } from "./table_view";

/** Ages go on when nothing arrives, so the page is drawn now and then without news. */
const IDLE_DRAW_MS = 100;

const field = new FieldView(byId("field"));
const table = new TableView(byId("robots"));
const ball = new BallCard(byId("ball"));
const processes = new ProcessCard(byId("processes"));
const log = new EventLog(byId("log"));

let newest: MonitorUpdate | undefined;
let receivedAt = 0;
let connected = false;
let isDrawingPlanned = false;

function draw(): void {
  isDrawingPlanned = false;
  const since = performance.now() - receivedAt;
  const mark = markOf(newest, connected, since);
  set(byId("mark"), { "data-state": mark.live ? "live" : "none" });
  write(byId("mark"), mark.live ? "LIVE" : "NO DATA");
  write(byId("silence"), mark.reason);
  set(document.body, { class: mark.live ? "live" : "not-live" });
  if (!newest) return;
  const scene = sceneOf(newest, since);
  field.draw(scene, newest);
  table.draw(newest, since);
  ball.draw(scene);
  processes.draw(newest);
  drawLead(newest, since);
}

function planDrawing(): void {
  if (isDrawingPlanned) return;
  isDrawingPlanned = true;
  requestAnimationFrame(draw);
}

function flip(): void {
  field.flip();
  planDrawing();
}

byId("flip").addEventListener("click", flip);
document.addEventListener("keydown", (event) => {
  if (event.key === "f" && !event.ctrlKey && !event.metaKey && !event.altKey) flip();
});

connect(liveAddress(window.location), {
  onOpen: () => {
    connected = true;
    log.clear();
  },
  onUpdate: (update) => {
    if (update.field) {
      field.setField(update.field);
      write(byId("team"), `${update.team} · ${update.field.name} · domain ${update.domainId}`);
    }
    log.add(update.events, update.stampNs);
    newest = update;
    receivedAt = performance.now();
    planDrawing();
  },
  onClose: () => {
    connected = false;
    planDrawing();
  },
});

setInterval(planDrawing, IDLE_DRAW_MS);
planDrawing();
