// tests/monitor/fake_referee_box.mjs: a referee box after RoboCup-MSL/RefBox 2.1, with a script.
//
// usage: node fake_referee_box.mjs PORT [SCRIPT [SCHEMA]]
// SCRIPT: lines "SECONDS COMMAND [ours|theirs] [ROBOT]", "SECONDS raw TEXT" (sent as it is), "SECONDS drop" (closes),
// "SECONDS deaf" (reads no more); seconds since the connection. Every message goes out in two pieces.
// SCHEMA: the league's JSON schema; each world state is held against it.
// JSON lines on stdout: {"port"}, {"connected"}, {"worldstate", "fault"}, {"rate_hz"} each second.
import { readFileSync } from "node:fs";
import { createServer } from "node:net";

const [port, script, schemaFile] = process.argv.slice(2);
const OURS = "224.16.32.127";
const THEIRS = "224.16.32.74";
const say = (what) => process.stdout.write(`${JSON.stringify(what)}\n`);

/** As much of JSON schema draft 4 as the league's uses; undefined: all is well. */
function fault(schema, value, path = "") {
  const kinds = [schema.type].flat().filter(Boolean);
  const kind = value === null ? "null" : Array.isArray(value) ? "array" : typeof value;
  if (kinds.length > 0 && !kinds.includes(kind)) return `${path}: ${kind}, expected ${kinds}`;
  for (const key of schema.required ?? []) if (!(key in value)) return `${path}: no ${key}`;
  for (const [key, inner] of Object.entries(schema.properties ?? {})) {
    const found = kind === "object" && key in value ? fault(inner, value[key], `${path}.${key}`) : undefined;
    if (found) return found;
  }
  for (const [index, item] of (kind === "array" && schema.items ? value : []).entries()) {
    const found = fault(schema.items, item, `${path}[${index}]`);
    if (found) return found;
  }
  return undefined;
}

const schema = schemaFile ? JSON.parse(readFileSync(schemaFile, "utf8")) : {};
const lines = script ? readFileSync(script, "utf8").split("\n").filter((line) => line && !line.startsWith("#")) : [];

function message(words) {
  const [command, side, robot] = words;
  const out = { command, targetTeam: side === "ours" ? OURS : side === "theirs" ? THEIRS : "" };
  if (robot) out.robotID = Number(robot);
  return `${JSON.stringify(out)}\0`;
}

const server = createServer((socket) => {
  say({ connected: true });
  socket.setNoDelay(true);
  const send = (text) => {
    const half = Math.floor(text.length / 2);
    socket.write(text.slice(0, half));
    setTimeout(() => socket.writable && socket.write(text.slice(half)), 5);
  };
  // To the newcomer only, and glued to the state of the game.
  socket.write(message(["WELCOME", "ours"]) + message(["STOP"]));
  const timers = lines.map((line) => {
    const [seconds, ...words] = line.split(" ");
    const act = { drop: () => socket.destroy(), deaf: () => socket.pause(), raw: () => socket.write(`${words.slice(1).join(" ")}\0`) }[words[0]];
    return setTimeout(act ?? (() => send(message(words))), 1000 * Number(seconds));
  });
  let open = "";
  let count = 0;
  socket.on("data", (bytes) => {
    const parts = (open + bytes.toString("latin1")).split("\0");
    open = parts.pop();
    for (const part of parts) {
      ++count;
      try {
        const world = JSON.parse(part);
        if (count % 10 === 1) say({ worldstate: world, fault: fault(schema, world) ?? null });
      } catch (error) {
        say({ fault: String(error) });
      }
    }
  });
  timers.push(setInterval(() => (say({ rate_hz: count }), (count = 0)), 1000));
  socket.on("error", () => undefined);
  socket.on("close", () => (timers.forEach(clearTimeout), say({ connected: false })));
});
server.listen(Number(port), "127.0.0.1", () => say({ port: server.address().port }));
