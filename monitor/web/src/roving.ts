// monitor/web/src/roving.ts: arrow keys among many things that are one stop of the Tab key.

const STEPS: Record<string, { line: number; item: number }> = {
  ArrowUp: { line: -1, item: 0 },
  ArrowDown: { line: 1, item: 0 },
  ArrowLeft: { line: 0, item: -1 },
  ArrowRight: { line: 0, item: 1 },
  Home: { line: 0, item: -Infinity },
  End: { line: 0, item: Infinity },
};

/** The place that a key leads to among lines of `counts` items; the same place where there is no other. */
export function stepFrom(at: { line: number; item: number }, key: string, counts: number[]): { line: number; item: number } {
  const step = STEPS[key];
  if (!step) return at;
  const line = Math.min(Math.max(at.line + step.line, 0), counts.length - 1);
  return { line, item: Math.min(Math.max(at.item + step.item, 0), (counts[line] ?? 1) - 1) };
}

/** Things that take focus by arrow keys, line by line; Tab enters where it was left. Items have a tabindex from the start. */
export class Roving {
  private stop: HTMLElement | undefined;

  /**
   * @param lines  selects the lines in `root`; "" makes one line of `root`
   * @param items  selects the items in a line
   */
  constructor(
    private readonly root: HTMLElement,
    private readonly lines: string,
    private readonly items: string,
  ) {
    root.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !(event.key in STEPS)) return;
      if (!this.move(event.key)) return;
      event.preventDefault();
      event.stopPropagation(); // the page's own arrow keys are not meant
    });
    root.addEventListener("focusin", (event) => this.stopAt((event.target as Element).closest<HTMLElement>(items)));
  }

  /** Tab finds an item, whatever came and went. */
  keepStop(): void {
    const isThere = this.stop?.isConnected && (this.lines === "" || this.stop.closest(this.lines) !== null);
    if (!isThere) this.stopAt(this.grid()[0]?.[0] ?? null);
  }

  private grid(): HTMLElement[][] {
    const lines = this.lines ? [...this.root.querySelectorAll<HTMLElement>(this.lines)] : [this.root];
    return lines.map((line) => [...line.querySelectorAll<HTMLElement>(this.items)]).filter((line) => line.length > 0);
  }

  private move(key: string): boolean {
    const grid = this.grid();
    const now = document.activeElement?.closest<HTMLElement>(this.items);
    const line = grid.findIndex((items) => items.includes(now!));
    if (!now || line < 0) return false;
    const to = stepFrom({ line, item: grid[line]!.indexOf(now) }, key, grid.map((items) => items.length));
    grid[to.line]?.[to.item]?.focus();
    return true;
  }

  private stopAt(item: HTMLElement | null): void {
    if (!item) return;
    if (this.stop) this.stop.tabIndex = -1;
    this.stop = item;
    item.tabIndex = 0;
  }
}
