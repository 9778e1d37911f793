// tests/recording/read_mcap.mjs: reads a recording with @mcap/core, which shares no code with ours.
//
// usage: node read_mcap.mjs FILE [FROM_S UNTIL_S], with PAGE_DIR naming where the packages are.
// One JSON line: messages by topic, all CRCs checked, every payload parsed by the schema in the file.
import { open } from "node:fs/promises";
import { createRequire } from "node:module";
import { join } from "node:path";

const load = createRequire(join(process.env.PAGE_DIR, "package.json"));
const { McapIndexedReader, McapStreamReader } = load("@mcap/core");
const { decompress } = load("fzstd");
const { createFileRegistry, fromBinary } = load("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = load("@bufbuild/protobuf/wkt");

const [path, fromS, untilS] = process.argv.slice(2);
const decompressHandlers = { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) };
const handle = await open(path);
const { size } = await handle.stat();
const bytes = new Uint8Array(size);
await handle.read(bytes, 0, size, 0);

const parsers = new Map();
const topics = {};
const take = (channel, schema, message) => {
  if (!parsers.has(channel.id)) {
    const registry = createFileRegistry(fromBinary(FileDescriptorSetSchema, schema.data));
    parsers.set(channel.id, registry.getMessage(schema.name));
  }
  fromBinary(parsers.get(channel.id), message.data);
  topics[channel.topic] = (topics[channel.topic] ?? 0) + 1;
};

// Every record from the start, with its CRC.
const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
stream.append(bytes);
const channels = new Map();
const schemas = new Map();
for (let record = stream.nextRecord(); record; record = stream.nextRecord()) {
  if (record.type === "Schema") schemas.set(record.id, record);
  if (record.type === "Channel") channels.set(record.id, record);
  if (record.type === "Message") {
    const channel = channels.get(record.channelId);
    take(channel, schemas.get(channel.schemaId), record);
  }
}

// And by the index.
const readable = {
  size: async () => BigInt(size),
  read: async (offset, length) => bytes.subarray(Number(offset), Number(offset + length)),
};
const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
const start = reader.statistics.messageStartTime;
const at = (seconds) => start + BigInt(Math.round(Number(seconds) * 1e9));
let inWindow = 0;
let last = 0n;
let ordered = true;
for await (const message of reader.readMessages(fromS ? { startTime: at(fromS), endTime: at(untilS) } : {})) {
  ordered &&= message.logTime >= last;
  last = message.logTime;
  ++inWindow;
}
const metadata = {};
for await (const record of reader.readMetadata()) metadata[record.name] = Object.fromEntries(record.metadata);
await handle.close();
process.stdout.write(
  `${JSON.stringify({ topics, indexed: inWindow, ordered, done: stream.done(), statistics: Number(reader.statistics.messageCount), metadata })}\n`,
);
