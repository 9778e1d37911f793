// tools/recorded_message.cpp: see tools/recorded_message.hpp.
#include "tools/recorded_message.hpp"

#include <array>
#include <cstdio>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

namespace teamsight::tools {

namespace protobuf = google::protobuf;

struct RecordedMessages::Type {
  protobuf::DescriptorPool pool;
  protobuf::DynamicMessageFactory factory;
  std::unique_ptr<protobuf::Message> message;  // goes before the factory
};

RecordedMessages::RecordedMessages() = default;
RecordedMessages::~RecordedMessages() = default;

const protobuf::Message* RecordedMessages::parse(const recording::Channel& channel,
                                                 std::string_view payload) {
  auto& type = types_[&channel];
  if (!type) {
    type = std::make_unique<Type>();
    protobuf::FileDescriptorSet files;
    const bool is_protobuf =
        channel.encoding == "protobuf" && files.ParseFromString(channel.schema.data);
    for (const auto& file : files.file()) static_cast<void>(type->pool.BuildFile(file));
    const protobuf::Descriptor* descriptor =
        is_protobuf ? type->pool.FindMessageTypeByName(channel.schema.name) : nullptr;
    if (descriptor != nullptr) type->message.reset(type->factory.GetPrototype(descriptor)->New());
  }
  if (!type->message) return nullptr;
  const bool is_parsed =
      type->message->ParseFromArray(payload.data(), static_cast<int>(payload.size()));
  return is_parsed ? type->message.get() : nullptr;
}

std::string json_of(const protobuf::Message& message) {
  protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string json;
  if (!protobuf::util::MessageToJsonString(message, &json, options).ok()) return "null";
  return json;
}

namespace {

using Fields = std::map<std::string, std::string>;

std::string shortest(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  double back = 0.0;
  std::array<char, 32> brief{};
  std::snprintf(brief.data(), brief.size(), "%.9g", value);
  std::sscanf(brief.data(), "%lf", &back);
  return back == value ? brief.data() : text.data();
}

/// One value of a field; `index` is -1 where the field is not repeated.
struct Value {
  const protobuf::Message& message;
  const protobuf::FieldDescriptor& field;
  int index;
};

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char letter : text) out += letter == '"' ? "\"\"" : std::string(1, letter);
  return out + "\"";
}

const protobuf::Message& part_of(const Value& value) {
  const protobuf::Reflection& get = *value.message.GetReflection();
  return value.index < 0 ? get.GetMessage(value.message, &value.field)
                         : get.GetRepeatedMessage(value.message, &value.field, value.index);
}

/// As a cell of a table.
std::string text_of(const Value& value) {
  const protobuf::Reflection& get = *value.message.GetReflection();
  const bool is_one = value.index < 0;
  if (value.field.cpp_type() == protobuf::FieldDescriptor::CPPTYPE_DOUBLE) {
    return shortest(is_one ? get.GetDouble(value.message, &value.field)
                           : get.GetRepeatedDouble(value.message, &value.field, value.index));
  }
  if (value.field.cpp_type() == protobuf::FieldDescriptor::CPPTYPE_STRING) {
    return quoted(is_one ? get.GetString(value.message, &value.field)
                         : get.GetRepeatedString(value.message, &value.field, value.index));
  }
  std::string text;
  protobuf::TextFormat::PrintFieldValueToString(value.message, &value.field, value.index, &text);
  return text;
}

void flatten(const protobuf::Message& message, const std::string& prefix, Fields& out);

void flatten(const Value& value, const std::string& path, Fields& out) {
  if (value.field.type() == protobuf::FieldDescriptor::TYPE_BYTES) return;  // a picture is no cell
  if (value.field.cpp_type() == protobuf::FieldDescriptor::CPPTYPE_MESSAGE) {
    flatten(part_of(value), path + ".", out);
  } else {
    out[path] = text_of(value);
  }
}

void flatten(const protobuf::Message& message, const std::string& prefix, Fields& out) {
  const protobuf::Descriptor& type = *message.GetDescriptor();
  const protobuf::Reflection& get = *message.GetReflection();
  for (int i = 0; i < type.field_count(); ++i) {
    const protobuf::FieldDescriptor& field = *type.field(i);
    const std::string path = prefix + field.name();
    if (!field.is_repeated()) {
      flatten(Value{message, field, -1}, path, out);
      continue;
    }
    for (int k = 0; k < get.FieldSize(message, &field); ++k) {
      flatten(Value{message, field, k}, path + "." + std::to_string(k), out);
    }
  }
}

}  // namespace

std::map<std::string, std::string> flat(const protobuf::Message& message) {
  Fields fields;
  flatten(message, "", fields);
  return fields;
}

}  // namespace teamsight::tools
