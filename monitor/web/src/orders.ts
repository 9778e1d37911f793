// monitor/web/src/orders.ts: orders to the station, with its token; what became of them.
import { create, type MessageInitShape, toBinary } from "@bufbuild/protobuf";
import { type MonitorAction, MonitorRequestSchema } from "./generated/monitor_pb";
import { html } from "./dom";

const STORE = "teamsight.token";

type Order = NonNullable<MessageInitShape<typeof MonitorRequestSchema>["order"]>;

/** Takes the token out of the address, where it stands only once, and keeps it for this tab. */
export function takeToken(location: Location, history: { replaceState(data: unknown, title: string, url: string): void }, store: Storage): string {
  const found = /^#token=([0-9A-Za-z_-]+)$/.exec(location.hash);
  if (found?.[1]) {
    store.setItem(STORE, found[1]);
    history.replaceState(null, "", location.pathname);
  }
  return store.getItem(STORE) ?? "";
}

export class Orders {
  private shown = "";
  private closed = "";

  constructor(
    private readonly root: HTMLElement,
    private readonly send: (bytes: Uint8Array) => boolean,
    public token: string,
  ) {}

  /** No orders from now on, and what to say to one. */
  close(why: string): void {
    this.closed = why;
  }

  give(order: Order): void {
    if (this.closed) {
      this.refuse(this.closed);
      return;
    }
    if (!this.token) {
      this.refuse("Orders need the station's token: open the address it printed, or enter it");
      this.ask();
      return;
    }
    const bytes = toBinary(MonitorRequestSchema, create(MonitorRequestSchema, { token: this.token, order }));
    if (!this.send(bytes)) this.refuse("Not sent: the station does not answer");
  }

  /** Asks the operator for the token; true if there is one now. */
  ask(): boolean {
    const dialog = document.getElementById("token-dialog");
    if (dialog instanceof HTMLDialogElement && !dialog.open) dialog.showModal();
    return this.token !== "";
  }

  accept(token: string): void {
    this.token = token.trim();
    sessionStorage.setItem(STORE, this.token);
  }

  /** Says something that is no order's outcome; stays for a while. */
  tell(what: string, tone: "told" | "refused" = "told"): void {
    const note = html("div", `action ${tone}`, this.root, what);
    setTimeout(() => note.remove(), 6000);
  }

  /** Says why an order was not taken. */
  refuse(why: string): void {
    this.tell(why, "refused");
    if (why === "wrong token") this.ask();
  }

  draw(actions: MonitorAction[]): void {
    const known = actions.filter((action) => !/^(picture|line points) of/.test(action.text) || action.state === "no answer").slice(-3);
    const text = known.map((action) => `${action.commandId} ${action.state}`).join();
    if (text === this.shown) return;
    this.shown = text;
    for (const old of this.root.querySelectorAll(".action:not(.refused, .told)")) old.remove();
    for (const action of known) {
      const words: Record<string, string> = { waiting: "…", done: "✓ done", "no answer": "✗ no answer" };
      const note = html("div", `action ${action.state.replace(" ", "-")}`, this.root);
      html("span", "", note, action.text);
      html("b", "", note, words[action.state] ?? action.state);
    }
  }
}
