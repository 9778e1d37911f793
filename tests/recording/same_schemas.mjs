// tests/recording/same_schemas.mjs: compares idl/foxglove.proto with the schemas that Foxglove publishes
// (npm's @foxglove/schemas), message by message: every field's name, number, type and whether it repeats.
//
// usage: node same_schemas.mjs FOXGLOVE_PROTO FOLDER, with PAGE_DIR naming where the packages are. FOLDER is written to.
// Prints how many messages agree; a difference is named, exit code 1.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";

const load = createRequire(join(process.env.PAGE_DIR, "package.json"));
const { foxgloveEnumSchemas, foxgloveMessageSchemas, generateProto } = load("@foxglove/schemas/internal");
const { fromBinary } = load("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = load("@bufbuild/protobuf/wkt");

const [ours, folder] = process.argv.slice(2);
mkdirSync(join(folder, "foxglove"), { recursive: true });
const names = Object.keys(foxgloveMessageSchemas);
for (const name of names) {
  const enums = Object.values(foxgloveEnumSchemas).filter((entry) => entry.parentSchemaName === name);
  writeFileSync(join(folder, "foxglove", `${name}.proto`), generateProto(foxgloveMessageSchemas[name], enums));
}

/// Every message of some .proto files, and of those nested in them, as name -> sorted lines about its fields.
const messagesOf = (root, files) => {
  const out = join(folder, "set.bin");
  execFileSync("protoc", ["-I", root, `--descriptor_set_out=${out}`, ...files]);
  const all = new Map();
  for (const file of fromBinary(FileDescriptorSetSchema, readFileSync(out)).file) {
    for (const message of file.messageType) {
      const fields = message.field.map((f) => `${f.number} ${f.name} ${f.type} ${f.typeName} ${f.label}`);
      const values = message.enumType.flatMap((e) => e.value.map((v) => `${e.name}.${v.name}=${v.number}`));
      all.set(`${file.package}.${message.name}`, [...fields, ...values].sort().join("\n"));
    }
  }
  return all;
};

const theirs = messagesOf(folder, names.map((name) => join(folder, "foxglove", `${name}.proto`)));
let same = 0;
for (const [name, fields] of messagesOf(dirname(ours), [ours])) {
  if (theirs.get(name) !== fields) {
    process.stderr.write(`${name}: we have\n${fields}\nFoxglove has\n${theirs.get(name)}\n`);
    process.exitCode = 1;
  } else {
    same += 1;
  }
}
process.stdout.write(`${JSON.stringify({ same })}\n`);
