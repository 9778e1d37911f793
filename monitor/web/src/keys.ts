// monitor/web/src/keys.ts: what the keyboard does.
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
  player(): Player;
  changed(): void;
}

const TABS = ["team", "robot", "plots", "referee"];

/** The next speed in the list. */
export function otherSpeed(speed: number, step: 1 | -1): number {
  const index = SPEEDS.indexOf(speed) + step;
  return SPEEDS[Math.min(Math.max(index, 0), SPEEDS.length - 1)]!;
}

/** Whether a key belongs to what has the focus: text is typed, a box ticked, a choice made. */
export function isTaken(key: string, tag: string, type: string): boolean {
  if (tag === "SELECT") return true;
  if (tag !== "INPUT" || type === "range") return false;
  return type !== "checkbox" || key === " ";
}

/** Calls what a key stands for; false: nothing. */
export function pressed(key: string, to: Commands, nowMs: number): boolean {
  const player = to.player();
  const actions: Record<string, () => void> = {
    f: () => to.flip(),
    v: () => to.cycleRaw(),
    d: () => to.toggleTheme(),
    b: () => to.bookmark(),
    r: () => to.relocate(),
    h: () => to.hint(),
    l: () => player.goLive(),
    " ": () => player.toggle(nowMs),
    ",": () => player.step(-1, nowMs),
    ".": () => player.step(1, nowMs),
    PageUp: () => player.jump(-1, nowMs),
    PageDown: () => player.jump(1, nowMs),
    "+": () => (player.speed = otherSpeed(player.speed, 1)),
    "-": () => (player.speed = otherSpeed(player.speed, -1)),
    ArrowUp: () => to.choose(-1),
    ArrowDown: () => to.choose(1),
    Escape: () => to.giveUp(),
  };
  const tab = TABS[Number(key) - 1];
  const action = actions[key] ?? (tab ? () => to.showTab(tab) : undefined);
  action?.();
  return action !== undefined;
}

export function bindKeys(to: Commands): void {
  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLInputElement;
    if (event.ctrlKey || event.metaKey || event.altKey || isTaken(event.key, target.tagName, target.type)) return;
    if (!pressed(event.key, to, performance.now())) return;
    event.preventDefault();
    to.changed();
  });
}
