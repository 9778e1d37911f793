// monitor/web/src/history.ts: the updates of the last minutes, or of a recording, by the station's clock.
import { fromBinary } from "@bufbuild/protobuf";
import { type MonitorUpdate, MonitorUpdateSchema } from "./generated/monitor_pb";

/** What is kept of one update; the bytes are decoded again when they are looked at. */
export interface Moment {
  /** The station's clock, milliseconds. */
  ms: number;
  bytes: Uint8Array;
  /** Texts of the events in it. */
  events: string[];
  /** Whether the game ran; undefined: nobody said. */
  running: boolean | undefined;
}

export interface Bounds {
  longestMs: number;
  mostBytes: number;
  /** Updates closer than this to the one before are left out, unless something happened in them. */
  stepMs: number;
}

/** Ten minutes at 15 Hz, or what fits in memory. */
export const LIVE_BOUNDS: Bounds = { longestMs: 600_000, mostBytes: 120e6, stepMs: 60 };
export const RECORDING_BOUNDS: Bounds = { longestMs: Infinity, mostBytes: Infinity, stepMs: 0 };

export function momentOf(update: MonitorUpdate, bytes: Uint8Array): Moment {
  return {
    ms: Number(update.stampNs) / 1e6,
    bytes,
    events: update.events.map((event) => event.text),
    running: update.referee?.state?.running,
  };
}

/** Moments in the order of their time. A station that starts anew begins a new history. */
export class History {
  private moments: Moment[] = [];
  private bytes = 0;

  constructor(private readonly bounds: Bounds) {}

  get length(): number {
    return this.moments.length;
  }

  get firstMs(): number | undefined {
    return this.moments[0]?.ms;
  }

  get lastMs(): number | undefined {
    return this.moments.at(-1)?.ms;
  }

  push(moment: Moment): void {
    const last = this.lastMs;
    if (last !== undefined && moment.ms < last) this.clear();
    const isClose = last !== undefined && moment.ms >= last && moment.ms - last < this.bounds.stepMs;
    if (isClose && moment.events.length === 0) return;
    this.moments.push(moment);
    this.bytes += moment.bytes.length;
    while (this.moments.length > 1 && this.isBeyondBounds(moment.ms)) this.bytes -= this.moments.shift()!.bytes.length;
  }

  private isBeyondBounds(nowMs: number): boolean {
    return nowMs - this.moments[0]!.ms > this.bounds.longestMs || this.bytes > this.bounds.mostBytes;
  }

  clear(): void {
    this.moments = [];
    this.bytes = 0;
  }

  /** The index of the newest moment at or before `ms`; -1: all are later. */
  indexAt(ms: number): number {
    let low = 0;
    let high = this.moments.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.moments[middle]!.ms <= ms) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  moment(index: number): Moment | undefined {
    return this.moments[index];
  }

  decode(index: number): MonitorUpdate | undefined {
    const moment = this.moments[index];
    return moment && fromBinary(MonitorUpdateSchema, moment.bytes);
  }

  /** When the next event after `ms`, or with `step` -1 the last one before it, happened. */
  eventFrom(ms: number, step: 1 | -1): number | undefined {
    let index = this.indexAt(ms);
    if (step === -1 && this.moments[index]?.ms === ms) index -= 1;
    else if (step === 1) index += 1;
    for (; index >= 0 && index < this.moments.length; index += step) {
      const moment = this.moments[index]!;
      if (moment.events.length > 0 && (step === 1 ? moment.ms > ms : moment.ms < ms)) return moment.ms;
    }
    return undefined;
  }

  /** The first time from `ms` on at which the game is not known to stand still. */
  nextRunning(ms: number): number {
    for (let index = Math.max(this.indexAt(ms), 0); index < this.moments.length; ++index) {
      const moment = this.moments[index]!;
      if (moment.running !== false) return Math.max(moment.ms, ms);
    }
    return this.lastMs ?? ms;
  }
}

/** Splits a recording as the station serves it: each update behind its length, 4 bytes, little-endian. */
export function* updatesIn(body: Uint8Array): Generator<Uint8Array> {
  const view = new DataView(body.buffer, body.byteOffset, body.byteLength);
  for (let at = 0; at + 4 <= body.length; ) {
    const size = view.getUint32(at, true);
    if (at + 4 + size > body.length) return;
    yield body.subarray(at + 4, at + 4 + size);
    at += 4 + size;
  }
}
