// bench/page.mjs: the coach station's page and its clients, before a fake team of five robots and a fusion at 30 Hz.
//
// usage: node page.mjs latency|clients [SECONDS]      default: 20 seconds
//   with PAGE_DIR naming where the page's packages are, BUILD_DIR the build tree, SOURCE_DIR the repository
//   latency  from a world's stamp, taken when it is written to the bus, until headless Chromium has drawn it, beside
//            the arrival of the same update at a client that draws nothing
//   clients  processor time of the station with 0, 1 and 10 clients that read everything
// JSON lines on stdout, a table on stderr.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const load = createRequire(join(process.env.PAGE_DIR, "package.json"));
const [mode, seconds = "20"] = process.argv.slice(2);
const { BUILD_DIR, SOURCE_DIR } = process.env;
const DOMAIN = "77";
const CLOCK_TICKS_PER_S = 100; // USER_HZ, which Linux fixes for /proc
const wait = (ms) => new Promise((done) => setTimeout(done, ms));

const children = [];
function start(program, ...args) {
  const child = spawn(program, args, { stdio: ["ignore", "pipe", "inherit"] });
  children.push(child);
  return child;
}

const firstLine = (child) => new Promise((done) => child.stdout.once("data", (bytes) => done(String(bytes).split("\n")[0])));

/** The station and the team that it watches. */
async function startAll() {
  const fake = join(BUILD_DIR, "tests/teamsight-fake-team");
  const profile = join(SOURCE_DIR, "config/dds/loopback.xml");
  for (const robot of [1, 2, 3, 4, 5]) start(fake, "robot", robot, DOMAIN, profile, "demo");
  start(fake, "fusion", 3, DOMAIN, profile, "demo");
  const team = join(SOURCE_DIR, "config/teams/demo.textproto");
  const station = start(join(BUILD_DIR, "bin/teamsight-monitor"), "--team", team, "--team-domain", DOMAIN, "--port", "0");
  return { station, url: JSON.parse(await firstLine(station)).url };
}

/** A client that hands on each message with its moment of arrival, in nanoseconds of CLOCK_MONOTONIC. */
function watch(url, hear) {
  const socket = new (load("ws").WebSocket)(`ws${url.slice(4)}live`);
  socket.on("message", (bytes) => hear(bytes, process.hrtime.bigint()));
  return socket;
}

/** The stamp of a MonitorUpdate, its first field; nothing: the message begins with a greeting. */
function stampOf(bytes) {
  if (bytes[0] !== 0x08) return undefined;
  let [value, at, shift] = [0n, 1, 0n];
  for (; bytes[at] & 0x80; ++at, shift += 7n) value |= BigInt(bytes[at] & 0x7f) << shift;
  return value | (BigInt(bytes[at]) << shift);
}

const quantile = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.ceil(share * sorted.length) - 1)];
const round = (value, digits = 1) => Number(value.toFixed(digits));

function report(stage, samples) {
  const sorted = [...samples].sort((a, b) => a - b);
  const line = { bench: "page", stage, count: sorted.length, median_ms: round(quantile(sorted, 0.5)), p95_ms: round(quantile(sorted, 0.95)), max_ms: round(sorted.at(-1)) };
  process.stdout.write(`${JSON.stringify(line)}\n`);
  process.stderr.write(`${stage.padEnd(44)} ${String(line.count).padStart(6)} ${line.median_ms.toFixed(1).padStart(10)} ${line.p95_ms.toFixed(1).padStart(10)} ${line.max_ms.toFixed(1).padStart(10)}\n`);
  return line;
}

/** In the page: notes what was drawn, once style, layout and painting of that frame are over. */
function noteFrames() {
  globalThis.drawn = [];
  const observe = () => {
    new MutationObserver(() => {
      const { drawnWorld, drawnUpdate } = document.body.dataset;
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => globalThis.drawn.push([drawnWorld, drawnUpdate, performance.timeOrigin + performance.now()]);
      requestAnimationFrame(() => {}); // keeps frames coming
      port2.postMessage(0); // served after the frame that is being made
    }).observe(document.body, { attributeFilter: ["data-drawn-update"] });
  };
  addEventListener("DOMContentLoaded", observe);
}

async function measureLatency() {
  const { url } = await startAll();
  const profile = mkdtempSync(join(tmpdir(), "teamsight-bench-"));
  const browser = await load("playwright-core").chromium.launchPersistentContext(profile, {
    executablePath: "/usr/bin/chromium",
    headless: true,
    viewport: { width: 1280, height: 800 },
    args: ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
  });
  const arrivals = new Map();
  try {
    const page = await browser.newPage();
    await page.addInitScript(noteFrames);
    await page.goto(url);
    await page.waitForFunction(() => document.getElementById("mark").textContent === "LIVE");
    await wait(3000);
    const socket = watch(url, (bytes, at) => arrivals.set(String(stampOf(bytes)), at));
    await page.evaluate(() => void (globalThis.drawn.length = 0));
    await wait(1000 * Number(seconds));
    const drawn = await page.evaluate(() => globalThis.drawn);
    socket.close();
    tell(drawn, arrivals);
  } finally {
    await browser.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** Chromium's wall clock and ours are one; the worlds' stamps are of the monotonic clock. */
function tell(drawn, arrivals) {
  const wallMinusHostMs = performance.timeOrigin + performance.now() - Number(process.hrtime.bigint()) / 1e6;
  const toUpdate = [], toArrival = [], toDrawn = [];
  const seen = new Set();
  for (const [world, update, wallMs] of drawn) {
    const arrived = arrivals.get(update);
    if (world === "0" || arrived === undefined || seen.has(world)) continue;
    seen.add(world);
    const worldMs = Number(world) / 1e6;
    toUpdate.push(Number(update) / 1e6 - worldMs);
    toArrival.push(Number(arrived) / 1e6 - worldMs);
    toDrawn.push(wallMs - wallMinusHostMs - worldMs);
  }
  process.stderr.write(`${"a world is written, and then".padEnd(44)} ${"count".padStart(6)} ${"median, ms".padStart(10)} ${"p95, ms".padStart(10)} ${"max, ms".padStart(10)}\n`);
  report("the station makes an update of it", toUpdate);
  const bare = report("it arrives at a client that draws nothing", toArrival);
  const whole = report("it is drawn in the browser", toDrawn);
  const shown = { bench: "page", stage: "drawn over arrived", median_ratio: round(whole.median_ms / bare.median_ms, 2), p95_ratio: round(whole.p95_ms / bare.p95_ms, 2) };
  process.stdout.write(`${JSON.stringify(shown)}\n`);
}

/** Processor time of a process so far, in seconds. */
function cpuSeconds(pid) {
  const fields = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ");
  return (Number(fields[11]) + Number(fields[12])) / CLOCK_TICKS_PER_S;
}

async function measureClients() {
  const { station, url } = await startAll();
  await wait(4000);
  process.stderr.write(`${"clients".padStart(8)} ${"updates/s each".padStart(16)} ${"kB/s each".padStart(12)} ${"station, % of a core".padStart(22)}\n`);
  for (const count of [0, 1, 10]) {
    let [messages, bytes] = [0, 0];
    const sockets = Array.from({ length: count }, () => watch(url, (data) => ((messages += 1), (bytes += data.length))));
    await wait(1500);
    [messages, bytes] = [0, 0];
    const [before, began] = [cpuSeconds(station.pid), performance.now()];
    await wait(1000 * Number(seconds));
    const elapsed = (performance.now() - began) / 1000;
    const each = Math.max(count, 1) * elapsed;
    const line = { bench: "clients", clients: count, updates_hz: round(messages / each), kilobytes_per_s: round(bytes / each / 1000), station_cpu_percent: round((100 * (cpuSeconds(station.pid) - before)) / elapsed) };
    process.stdout.write(`${JSON.stringify(line)}\n`);
    process.stderr.write(`${String(count).padStart(8)} ${line.updates_hz.toFixed(1).padStart(16)} ${line.kilobytes_per_s.toFixed(1).padStart(12)} ${line.station_cpu_percent.toFixed(1).padStart(22)}\n`);
    for (const socket of sockets) socket.close();
  }
}

try {
  await { latency: measureLatency, clients: measureClients }[mode]();
} finally {
  for (const child of children) child.kill("SIGTERM");
}
