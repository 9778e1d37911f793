// monitor/web/src/opponent_numbers.ts: short numbers for the opponents, as their track ids are long.

/** How long a number stays with a track that is not shown, so that one which comes back keeps it. */
const KEPT_MS = 5000;

/** The smallest free number for each track when it is first shown; another page may count otherwise. */
export class OpponentNumbers {
  private readonly known = new Map<number, { number: number; shownMs: number }>();

  /**
   * Call with all tracks of one moment before asking for their numbers.
   *
   * @param nowMs  the station's time of what is shown; a jump, on or back, gives numbers anew
   */
  show(tracks: number[], nowMs: number): void {
    for (const [track, { shownMs }] of this.known) {
      if (Math.abs(nowMs - shownMs) > KEPT_MS) this.known.delete(track);
    }
    const taken = new Set([...this.known.values()].map((one) => one.number));
    for (const track of [...tracks].sort((a, b) => a - b)) {
      let number = this.known.get(track)?.number ?? 1;
      if (!this.known.has(track)) while (taken.has(number)) ++number;
      taken.add(number);
      this.known.set(track, { number, shownMs: nowMs });
    }
  }

  /** 0: it was not shown lately. */
  of(track: number): number {
    return this.known.get(track)?.number ?? 0;
  }
}
