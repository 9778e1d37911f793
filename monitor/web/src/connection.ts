// monitor/web/src/connection.ts: the WebSocket to the station; comes back by itself.
import { fromBinary } from "@bufbuild/protobuf";
import { type MonitorUpdate, MonitorUpdateSchema } from "./generated/monitor_pb";

const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 2000;

export interface Listener {
  /** A connection begins: what was logged before comes again. */
  onOpen(): void;
  onUpdate(update: MonitorUpdate): void;
  onClose(): void;
}

/** The address of the live stream beside the page's own. */
export function liveAddress(page: { protocol: string; host: string }): string {
  return `${page.protocol === "https:" ? "wss" : "ws"}://${page.host}/live`;
}

/** How long to wait before try number `failures` (from 1): doubles up to two seconds. */
export function pauseBefore(failures: number): number {
  return Math.min(FIRST_PAUSE_MS * 2 ** Math.max(0, failures - 1), LONGEST_PAUSE_MS);
}

/** Connects, and connects again whenever the connection ends. */
export function connect(address: string, listener: Listener): void {
  let failures = 0;
  const open = (): void => {
    const socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      failures = 0;
      listener.onOpen();
    };
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => {
      listener.onUpdate(fromBinary(MonitorUpdateSchema, new Uint8Array(event.data)));
    };
    socket.onclose = () => {
      ++failures;
      listener.onClose();
      setTimeout(open, pauseBefore(failures));
    };
  };
  open();
}
