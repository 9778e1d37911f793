// monitor/web/src/table_view.ts: one row per robot. Columns keep their width, rows their height.
import type { MonitorUpdate, RobotRow } from "./generated/monitor_pb";
import { html, set, write } from "./dom";
import * as format from "./format";
import { COLUMNS, type Column, isToldOf, rowsOf, type Told } from "./robot_cells";
import { Roving } from "./roving";
import { isImported } from "./scene";

function stateOf(row: RobotRow, since: number): string {
  if (isToldOf(row)) return "told";
  return row.alive ? format.freshness(row.ageMs + since) : "lost";
}

const classOf = (column: Column): string => `${column.decides ? "decides" : "explains"}${column.numeric ? " numeric" : ""}`;

/** Rows that are always there, so that nothing jumps when a robot joins. */
const LEAST_ROWS = 5;

export class TableView {
  private readonly body: HTMLTableSectionElement;
  private readonly roving: Roving;

  /**
   * @param choose  the row of this robot has the focus
   * @param open  it was clicked, or Enter pressed
   */
  constructor(
    table: HTMLElement,
    choose: (robot: number) => void,
    private readonly open: (robot: number) => void,
  ) {
    set(table, { role: "grid" });
    const group = html("colgroup", "", table);
    const total = COLUMNS.reduce((sum, column) => sum + column.width, 0);
    for (const column of COLUMNS) html("col", "", group).style.width = `${(100 * column.width) / total}%`;
    const head = html("tr", "", html("thead", "", table));
    for (const column of COLUMNS) set(html("th", classOf(column), head, column.head), { tabindex: -1, "data-why": column.why });
    this.body = html("tbody", "", table);
    this.roving = new Roving(table, "tr:not(.empty)", "th, td");
    const robotOf = (event: Event): number => Number((event.target as Element).closest("tr")?.dataset["robot"] ?? 0);
    this.body.addEventListener("click", (event) => this.openIf(robotOf(event)));
    this.body.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.openIf(robotOf(event));
    });
    this.body.addEventListener("focusin", (event) => {
      if (robotOf(event) > 0) choose(robotOf(event));
    });
  }

  private openIf(robot: number): void {
    if (robot > 0) this.open(robot);
  }

  draw(update: MonitorUpdate, sinceUpdateMs: number, chosen: number): void {
    const mates = new Map(update.world?.teammates.map((mate) => [mate.robotId, mate]));
    const imported = isImported(update);
    const rows = rowsOf(update);
    const count = Math.max(rows.length, LEAST_ROWS);
    while (this.body.rows.length < count) this.addRow();
    while (this.body.rows.length > count) this.body.deleteRow(-1);
    for (let i = 0; i < count; ++i) {
      const line = this.body.rows[i];
      if (!line) continue;
      const row = rows[i];
      this.fill(line, row, { mate: row && mates.get(row.robotId), imported }, sinceUpdateMs);
      line.setAttribute("aria-selected", String(rows[i]?.robotId === chosen));
    }
    this.roving.keepStop();
  }

  private addRow(): void {
    const line = html("tr", "", this.body);
    for (const column of COLUMNS) {
      const place = html("td", classOf(column), line);
      place.tabIndex = -1;
      html("span", "", place);
    }
  }

  private fill(line: HTMLTableRowElement, row: RobotRow | undefined, told: Told, since: number): void {
    const state = row ? stateOf(row, since) : "empty";
    set(line, { class: state, "data-robot": row?.robotId ?? 0 });
    COLUMNS.forEach((column, index) => {
      const place = line.cells[index];
      const words = place?.firstElementChild;
      if (!place || !words) return;
      const content = row ? column.cell(row, told, since) : undefined;
      write(words, content?.text ?? "");
      set(words, { class: content?.tone ?? "" });
      set(place, { "data-why": content ? (content.why ?? column.why) : "" });
    });
  }
}
