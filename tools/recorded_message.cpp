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

void flatten(const protobuf::Message& message, const std::string& prefix, Fields& out);

/// One value of a field; `index` is -1 where it is not repeated.
void flatten_value(const protobuf::Message& message,
                   const protobuf::FieldDescriptor& field,
                   int index,
                   Fields& out_by_path,
                   const std::string& path) {
  using Cpp = protobuf::FieldDescriptor;
  const protobuf::Reflection& get = *message.GetReflection();
  const bool one = index < 0;
  switch (field.cpp_type()) {
    case Cpp::CPPTYPE_MESSAGE:
      flatten(
          one ? get.GetMessage(message, &field) : get.GetRepeatedMessage(message, &field, index),
          path + ".",
          out_by_path);
      return;
    case Cpp::CPPTYPE_DOUBLE:
      out_by_path[path] = shortest(one ? get.GetDouble(message, &field)
                                       : get.GetRepeatedDouble(message, &field, index));
      return;
    case Cpp::CPPTYPE_STRING: {
      if (field.type() == Cpp::TYPE_BYTES) return;
      std::string text = "\"";
      for (const char letter :
           one ? get.GetString(message, &field) : get.GetRepeatedString(message, &field, index)) {
        text += letter == '"' ? "\"\"" : std::string(1, letter);
      }
      out_by_path[path] = text + "\"";
      return;
    }
    case Cpp::CPPTYPE_ENUM:
      out_by_path[path] =
          (one ? get.GetEnum(message, &field) : get.GetRepeatedEnum(message, &field, index))
              ->name();
      return;
    default:
      break;
  }
  std::string text;
  protobuf::TextFormat::PrintFieldValueToString(message, &field, index, &text);
  out_by_path[path] = text;
}

void flatten(const protobuf::Message& message, const std::string& prefix, Fields& out) {
  const protobuf::Descriptor& type = *message.GetDescriptor();
  const protobuf::Reflection& get = *message.GetReflection();
  for (int i = 0; i < type.field_count(); ++i) {
    const protobuf::FieldDescriptor& field = *type.field(i);
    const std::string path = prefix + field.name();
    if (!field.is_repeated()) {
      flatten_value(message, field, -1, out, path);
      continue;
    }
    for (int k = 0; k < get.FieldSize(message, &field); ++k) {
      flatten_value(message, field, k, out, path + "." + std::to_string(k));
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
