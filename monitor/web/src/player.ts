// monitor/web/src/player.ts: which moment is shown: the newest, or one of the past that stands or runs.
import type { History } from "./history";

export type Mode = "live" | "paused" | "replay";

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/** A value with a clock handed in: `nowMs` is any clock that only goes forward. */
export class Player {
  mode: Mode;
  speed = 1;
  skipsStops = false;
  private cursorMs = 0;
  private cursorAt = 0;

  constructor(
    private readonly history: History,
    /** A recording has no present. */
    readonly isRecording: boolean,
  ) {
    this.mode = isRecording ? "paused" : "live";
  }

  /** The station's time that is shown, milliseconds; undefined: the newest. */
  timeAt(nowMs: number): number | undefined {
    if (this.mode === "live") return undefined;
    const first = this.history.firstMs ?? 0;
    const last = this.history.lastMs ?? 0;
    if (this.mode === "replay") {
      this.cursorMs += (nowMs - this.cursorAt) * this.speed;
      if (this.skipsStops) this.cursorMs = this.history.nextRunning(this.cursorMs);
    }
    this.cursorAt = nowMs;
    this.cursorMs = Math.min(Math.max(this.cursorMs, first), last);
    if (this.mode === "replay" && this.cursorMs >= last) this.mode = this.isRecording ? "paused" : "live";
    return this.mode === "live" ? undefined : this.cursorMs;
  }

  goLive(): void {
    if (!this.isRecording) this.mode = "live";
  }

  pause(nowMs: number): void {
    this.seek(this.timeAt(nowMs) ?? this.history.lastMs ?? 0, nowMs);
  }

  play(nowMs: number): void {
    if (this.mode === "live") return;
    if (this.isRecording && this.cursorMs >= (this.history.lastMs ?? 0)) this.cursorMs = this.history.firstMs ?? 0;
    this.cursorAt = nowMs;
    this.mode = "replay";
  }

  toggle(nowMs: number): void {
    if (this.mode === "paused") this.play(nowMs);
    else this.pause(nowMs);
  }

  /** Stands still at `ms`. */
  seek(ms: number, nowMs: number): void {
    this.mode = "paused";
    this.cursorMs = ms;
    this.cursorAt = nowMs;
    this.timeAt(nowMs);
  }

  /** One stored update on or back, and stands still there. */
  step(by: 1 | -1, nowMs: number): void {
    const ms = this.timeAt(nowMs) ?? this.history.lastMs ?? 0;
    const moment = this.history.moment(Math.max(this.history.indexAt(ms) + by, 0));
    this.seek(moment?.ms ?? ms, nowMs);
  }

  /** To the next event, or the last one before. */
  jump(by: 1 | -1, nowMs: number): void {
    const ms = this.timeAt(nowMs) ?? this.history.lastMs ?? 0;
    this.seek(this.history.eventFrom(ms, by) ?? ms, nowMs);
  }
}
