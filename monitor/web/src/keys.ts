// monitor/web/src/keys.ts: what the keyboard does, and the list of it.
import { html } from "./dom";
import { type Player, SPEEDS } from "./player";

export interface Commands {
  flip(): void;
  cycleRaw(): void;
  toggleTheme(): void;
  bookmark(): void;
  showTab(name: string): void;
  relocate(): void;
  hint(): void;
  giveUp(): void;
  choose(step: number): void;
  showKeys(): void;
  player(): Player;
  changed(): void;
}

const TABS = ["team", "robot", "plots", "referee"];

/** The next speed in the list. */
export function otherSpeed(speed: number, step: 1 | -1): number {
  const index = SPEEDS.indexOf(speed) + step;
  return SPEEDS[Math.min(Math.max(index, 0), SPEEDS.length - 1)]!;
}

/** Whether a key belongs to what has the focus: text is typed, a box ticked, a choice made, a button pressed. */
export function isTaken(key: string, tag: string, type: string): boolean {
  if (tag === "SELECT") return true;
  if (tag === "BUTTON") return key === " ";
  if (tag !== "INPUT" || type === "range") return false;
  return type !== "checkbox" || key === " ";
}

interface Key {
  /** As KeyboardEvent names them. */
  keys: string[];
  /** As they stand on the keyboard. */
  name: string;
  words: string;
  act(key: string, to: Commands, nowMs: number): void;
}

const key = (keys: string | string[], name: string, words: string, act: Key["act"]): Key => ({ keys: [keys].flat(), name, words, act });
const setSpeed = (step: 1 | -1) => (_key: string, to: Commands) => (to.player().speed = otherSpeed(to.player().speed, step));

const KEYS: Key[] = [
  key(" ", "Space", "pause, go on", (_key, to, now) => to.player().toggle(now)),
  key(",", ",", "one update back", (_key, to, now) => to.player().step(-1, now)),
  key(".", ".", "one update on", (_key, to, now) => to.player().step(1, now)),
  key("PageUp", "Page Up", "event before", (_key, to, now) => to.player().jump(-1, now)),
  key("PageDown", "Page Down", "next event", (_key, to, now) => to.player().jump(1, now)),
  key("+", "+", "faster", setSpeed(1)),
  key("-", "-", "slower", setSpeed(-1)),
  key("l", "l", "back to live", (_key, to) => to.player().goLive()),
  key("b", "b", "bookmark", (_key, to) => to.bookmark()),
  key(TABS.map((_tab, index) => String(index + 1)), "1 to 4", "team, robot, plots, referee", (one, to) => to.showTab(TABS[Number(one) - 1]!)),
  key("ArrowUp", "↑", "robot before", (_key, to) => to.choose(-1)),
  key("ArrowDown", "↓", "next robot", (_key, to) => to.choose(1)),
  key("f", "f", "look from the other side", (_key, to) => to.flip()),
  key("v", "v", "raw views: none, all, the chosen robot's", (_key, to) => to.cycleRaw()),
  key("r", "r", "say where the chosen robot stands", (_key, to) => to.relocate()),
  key("h", "h", "say where the ball is", (_key, to) => to.hint()),
  key("d", "d", "dark, light", (_key, to) => to.toggleTheme()),
  key("?", "?", "this list", (_key, to) => to.showKeys()),
  key("Escape", "Esc", "put away what is open", (_key, to) => to.giveUp()),
];

/** What the browser and the groups of the page do by themselves. */
const MOVES: [string, string][] = [
  ["Tab", "next: game, tools, panels, time, robots"],
  ["← → ↑ ↓", "within these; the framed one explains itself"],
  ["Enter", "press; in a robot's row: it close up"],
];

/** Calls what a key stands for; false: nothing. */
export function pressed(name: string, to: Commands, nowMs: number): boolean {
  const found = KEYS.find((one) => one.keys.includes(name));
  found?.act(name, to, nowMs);
  return found !== undefined;
}

/** Fills the dialog that lists the keys. */
export function makeKeyList(dialog: HTMLElement): void {
  html("h2", "", dialog, "Keys");
  const list = html("dl", "key-list", dialog);
  for (const [name, words] of [...MOVES, ...KEYS.map((one): [string, string] => [one.name, one.words])]) {
    const pair = html("div", "", list);
    html("kbd", "", html("dt", "", pair), name);
    html("dd", "", pair, words);
  }
}

export function bindKeys(to: Commands): void {
  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLInputElement;
    if (event.ctrlKey || event.metaKey || event.altKey || isTaken(event.key, target.tagName, target.type)) return;
    const isAsked = document.querySelector("dialog[open]") !== null;
    if (isAsked && event.key !== "?") return;
    if (!pressed(event.key, to, performance.now())) return;
    event.preventDefault();
    to.changed();
  });
}
