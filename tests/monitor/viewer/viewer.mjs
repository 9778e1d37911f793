// tests/monitor/viewer/viewer.mjs: watches the station as Foxglove does: npm's client of its protocol
// (@foxglove/ws-protocol), schemas from the wire.
//
// usage: node viewer.mjs URL SUBPROTOCOL WANTED_TOPIC..., with PAGE_DIR naming where the packages are.
// Subscribes to every topic. Prints one JSON line once a message of each wanted topic has come.
import { createRequire } from "node:module";
import { join } from "node:path";

const load = createRequire(join(process.env.PAGE_DIR, "package.json"));
const { WebSocket } = load("ws");
const { FoxgloveClient } = load("@foxglove/ws-protocol");
const { createFileRegistry, fromBinary, toJson } = load("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = load("@bufbuild/protobuf/wkt");

const [url, protocol, ...wanted] = process.argv.slice(2);
const socket = new WebSocket(url, [protocol]);
const client = new FoxgloveClient({ ws: socket });
const channels = new Map(); // by our subscription
const seen = { protocol: "", server: {}, topics: {}, statuses: [], newest: {} };

const fail = (text) => {
  process.stderr.write(`${text}\n`);
  process.exit(1);
};

client.on("error", (error) => fail(`error: ${error.message ?? error}`));
client.on("close", (event) => fail(`closed: ${event.code} ${event.reason}`));
client.on("serverInfo", (info) => {
  seen.protocol = socket.protocol;
  seen.server = info;
});
client.on("status", (status) => seen.statuses.push(status));
client.on("advertise", (list) => {
  for (const channel of list) {
    const files = fromBinary(FileDescriptorSetSchema, Buffer.from(channel.schema, "base64"));
    const type = createFileRegistry(files).getMessage(channel.schemaName);
    if (!type) fail(`${channel.topic}: no ${channel.schemaName} in its schema`);
    seen.topics[channel.topic] = 0;
    channels.set(client.subscribe(channel.id), { ...channel, type });
  }
});
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const channel = channels.get(subscriptionId);
  const message = fromBinary(channel.type, new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
  seen.topics[channel.topic] += 1;
  seen.newest[channel.topic] = { ms: Number(timestamp / 1_000_000n), message: toJson(channel.type, message) };
  if (seen.now_ms || !wanted.every((topic) => seen.topics[topic] > 0)) return;
  seen.now_ms = Date.now();
  process.stdout.write(`${JSON.stringify(seen)}\n`, () => process.exit(0));
});
setTimeout(() => fail(`not all came: ${JSON.stringify(seen.topics)}`), 20_000);
