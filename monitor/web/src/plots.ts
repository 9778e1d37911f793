// monitor/web/src/plots.ts: any number of the updates over time.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { MonitorUpdate } from "./generated/monitor_pb";
import { html } from "./dom";

const LONGEST_S = 120;
const STEP_MS = 100;
/** Of a plot and of the letters on its axes. */
const HEIGHT_REM = 8;
const LETTERS_REM = 0.7;
const FIRST = ["world.balls.0.vMps.x", "robots.0.latencyP50Ms"];

const pixels = (rem: number): number => Math.round(rem * Number.parseFloat(getComputedStyle(document.documentElement).fontSize));

/** Every number by its path, e.g. "robots.2.state.batteryV"; bytes and stamps are left out. */
export function numbersIn(value: unknown, prefix = "", out = new Map<string, number>()): Map<string, number> {
  if (typeof value === "number") out.set(prefix, value);
  else if (typeof value === "boolean") out.set(prefix, value ? 1 : 0);
  else if (typeof value === "object" && value !== null && !(value instanceof Uint8Array)) {
    for (const [key, inner] of Object.entries(value)) {
      if (key.startsWith("$") || key === "field" || key === "linePoints") continue;
      numbersIn(inner, prefix ? `${prefix}.${key}` : key, out);
    }
  } else if (typeof value === "bigint" && !/Ns$/.test(prefix)) out.set(prefix, Number(value));
  return out;
}

/** The number at a path; undefined: there is none now. */
export function numberAt(update: MonitorUpdate, path: string): number | undefined {
  let value: unknown = update;
  for (const key of path.split(".")) value = (value as Record<string, unknown> | undefined)?.[key];
  if (typeof value === "boolean") return value ? 1 : 0;
  return typeof value === "number" ? value : typeof value === "bigint" ? Number(value) : undefined;
}

interface Plot {
  path: string;
  values: (number | null)[];
  chart: uPlot;
}

export class Plots {
  private times: number[] = [];
  private readonly plots: Plot[] = [];
  private readonly list: HTMLDataListElement;
  private readonly area: HTMLElement;
  private takenMs = -Infinity;
  private listed = 0;

  constructor(private readonly root: HTMLElement) {
    const form = html("form", "plot-form", root);
    const input = html("input", "", form);
    input.placeholder = "a number, e.g. robots.0.rateHz";
    input.setAttribute("list", "paths");
    input.id = "plot-path";
    this.list = html("datalist", "", form);
    this.list.id = "paths";
    html("button", "tool", form, "Plot").type = "submit";
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (input.value) this.add(input.value);
      input.value = "";
    });
    this.area = html("div", "plot-area", root);
    for (const path of FIRST) this.add(path);
  }

  add(path: string): void {
    const holder = html("div", "plot", this.area);
    holder.dataset["path"] = path;
    const style = getComputedStyle(document.documentElement);
    const colour = (name: string): string => style.getPropertyValue(name).trim();
    const axis = { stroke: () => colour("--dim"), grid: { stroke: () => colour("--edge"), width: 1 }, ticks: { stroke: () => colour("--edge") }, font: `${pixels(LETTERS_REM)}px ${getComputedStyle(document.body).fontFamily}` };
    const chart = new uPlot(
      {
        width: Math.max(this.area.clientWidth, 280),
        height: pixels(HEIGHT_REM),
        title: path,
        legend: { show: false },
        scales: { x: { time: false } },
        axes: [{ ...axis, size: pixels(1.6) }, { ...axis, size: pixels(3.2) }],
        series: [{}, { stroke: () => colour("--own"), width: 2, spanGaps: false }],
      },
      [[], []],
      holder,
    );
    const plot: Plot = { path, values: this.times.map(() => null), chart };
    this.plots.push(plot);
    const remove = html("button", "plot-close", holder, "×");
    remove.type = "button";
    remove.setAttribute("aria-label", `Remove ${path}`);
    remove.addEventListener("click", () => {
      this.plots.splice(this.plots.indexOf(plot), 1);
      chart.destroy();
      holder.remove();
    });
  }

  /** Takes a value of each plot; draws only while it is seen. */
  take(update: MonitorUpdate): void {
    const ms = Number(update.stampNs) / 1e6;
    if (ms < this.takenMs) {
      this.times = [];
      for (const plot of this.plots) plot.values = [];
    } else if (ms - this.takenMs < STEP_MS) return;
    this.takenMs = ms;
    this.times.push(ms / 1000);
    for (const plot of this.plots) plot.values.push(numberAt(update, plot.path) ?? null);
    while (this.times[0]! < ms / 1000 - LONGEST_S) {
      this.times.shift();
      for (const plot of this.plots) plot.values.shift();
    }
    if (this.root.offsetParent === null) return;
    this.draw(update);
  }

  private draw(update: MonitorUpdate): void {
    const last = this.times.at(-1) ?? 0;
    const ago = this.times.map((time) => time - last);
    for (const plot of this.plots) {
      const width = Math.max(this.area.clientWidth, 280);
      const height = pixels(HEIGHT_REM);
      if (plot.chart.width !== width || plot.chart.height !== height) plot.chart.setSize({ width, height });
      plot.chart.setData([ago, plot.values]);
    }
    const paths = numbersIn(update);
    if (paths.size === this.listed) return;
    this.listed = paths.size;
    this.list.replaceChildren(...[...paths.keys()].map((path) => new Option(path, path)));
  }
}
