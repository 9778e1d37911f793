// monitor/web/src/format.ts: numbers as the operator reads them. Widths change as little as possible.

/** How old data may be before the page shows it differently. */
export type Freshness = "fresh" | "late" | "lost";

const LATE_MS = 200;
const LOST_MS = 1000;

/** Not a number counts as lost. */
export function freshness(ageMs: number): Freshness {
  if (ageMs < LATE_MS) return "fresh";
  return ageMs < LOST_MS ? "late" : "lost";
}

/** What is not known is a dash, never a zero. */
export const UNKNOWN = "–";

export function age(ms: number): string {
  if (!Number.isFinite(ms) || ms < 0) return UNKNOWN;
  if (ms < 1000) return `${Math.round(ms)} ms`;
  if (ms < 60_000) return `${(ms / 1000).toFixed(1)} s`;
  const minutes = ms / 60_000;
  return minutes < 60 ? `${Math.floor(minutes)} min` : `${Math.floor(minutes / 60)} h`;
}

/** A latency; negative: not known. */
export function latency(ms: number): string {
  if (!Number.isFinite(ms) || ms < 0) return UNKNOWN;
  return ms < 10 ? ms.toFixed(1) : ms.toFixed(0);
}

/** A share in 0..1. */
export function percent(share: number): string {
  if (!Number.isFinite(share)) return UNKNOWN;
  const value = share * 100;
  return `${value > 0 && value < 10 && Number(value.toFixed(1)) !== Math.round(value) ? value.toFixed(1) : value.toFixed(0)} %`;
}

/** The probability that a posture is not the mirror image, from its log-odds. */
export function halfProbability(logOdds: number): number {
  return 1 / (1 + Math.exp(-logOdds));
}

export function metres(value: number): string {
  return `${value.toFixed(2)} m`;
}

/** "1 ball", "2 balls". */
export function many(count: number, one: string): string {
  return `${count} ${one}${count === 1 ? "" : "s"}`;
}

/** A coordinate to a tenth, with a minus as wide as a plus. */
export function signed(value: number): string {
  return value.toFixed(1).replace("-", "\u2212");
}

export function count(value: number | bigint): string {
  const n = Number(value);
  if (n < 10_000) return n.toString();
  return n < 1_000_000 ? `${(n / 1000).toFixed(0)} k` : `${(n / 1_000_000).toFixed(1)} M`;
}

/** The robots in a mask: bit i stands for robot i + 1. */
export function robotsIn(mask: number): number[] {
  const robots: number[] = [];
  for (let robot = 1; robot <= 16; ++robot) {
    if (mask & (1 << (robot - 1))) robots.push(robot);
  }
  return robots;
}

const QUARANTINES = [
  "",
  "no posture",
  "biased",
  "mirrored",
  "kidnapped",
  "babbling",
  "duplicate id",
];

const QUARANTINE_WORDS = [
  "",
  "it does not know where it is",
  "what it sees lies aside from what the others see",
  "it stands on the other half",
  "its posture jumped",
  "too many or contradictory samples",
  "two processes speak under its id",
];

/** The same in a sentence. */
export function quarantineWords(code: number): string {
  return QUARANTINE_WORDS[code] ?? quarantine(code);
}

/** Why a robot is not trusted; empty: it is. */
export function quarantine(code: number): string {
  return QUARANTINES[code] ?? `reason ${code}`;
}

/** For the log. */
export function timeOfDay(date: Date): string {
  const two = (n: number): string => n.toString().padStart(2, "0");
  return `${two(date.getHours())}:${two(date.getMinutes())}:${two(date.getSeconds())}`;
}
