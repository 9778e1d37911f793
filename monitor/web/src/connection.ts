// monitor/web/src/connection.ts: the WebSocket to the station; comes back by itself.
import { fromBinary } from "@bufbuild/protobuf";
import { type MonitorUpdate, MonitorUpdateSchema } from "./generated/monitor_pb";

const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 2000;

export interface Listener {
  /** A connection begins: what was logged before comes again. */
  onOpen(): void;
  onUpdate(update: MonitorUpdate, bytes: Uint8Array): void;
  onClose(): void;
  /** The station wants its token before it shows anything. */
  onTokenNeeded(): void;
}

const TOKEN_NEEDED = 4401;

/** The address of the live stream beside the page's own. */
export function liveAddress(page: { protocol: string; host: string }, token = ""): string {
  return `${page.protocol === "https:" ? "wss" : "ws"}://${page.host}/live${token ? `?token=${token}` : ""}`;
}

/** How long to wait before try number `failures` (from 1): doubles up to two seconds. */
export function pauseBefore(failures: number): number {
  return Math.min(FIRST_PAUSE_MS * 2 ** Math.max(0, failures - 1), LONGEST_PAUSE_MS);
}

/** What is said to the station; false: it does not answer. */
export type Send = (bytes: Uint8Array) => boolean;

/** Connects, and connects again whenever the connection ends. */
export function connect(address: () => string, listener: Listener): Send {
  let failures = 0;
  let socket: WebSocket | undefined;
  const open = (): void => {
    socket = new WebSocket(address());
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      failures = 0;
      listener.onOpen();
    };
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => {
      const bytes = new Uint8Array(event.data);
      listener.onUpdate(fromBinary(MonitorUpdateSchema, bytes), bytes);
    };
    socket.onclose = (event) => {
      if (event.code === TOKEN_NEEDED) listener.onTokenNeeded();
      ++failures;
      listener.onClose();
      setTimeout(open, pauseBefore(failures));
    };
  };
  open();
  return (bytes) => {
    if (socket?.readyState !== WebSocket.OPEN) return false;
    socket.send(bytes as Uint8Array<ArrayBuffer>);
    return true;
  };
}
