// settings/schema_check.cpp: a walk over any message by reflection.
#include "settings/schema_check.hpp"

#include <cmath>
#include <vector>

#include "config.pb.h"
#include "settings/text_format.hpp"

namespace teamsight::settings {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

std::string range_in_words(const FieldDescriptor& field) {
  if (!field.options().HasExtension(config::range)) return {};
  const config::Range& range = field.options().GetExtension(config::range);
  if (range.has_min() && range.has_max()) {
    return " from " + text_of(range.min()) + " to " + text_of(range.max());
  }
  if (range.has_min()) return " of at least " + text_of(range.min());
  return range.has_max() ? " of at most " + text_of(range.max()) : std::string();
}

// All of idl/config.proto's numbers fit a double exactly.
std::optional<double> number_in(const Message& message, const FieldDescriptor& field, int index) {
  const google::protobuf::Reflection& values = *message.GetReflection();
  const bool many = field.is_repeated();
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return many ? values.GetRepeatedDouble(message, &field, index)
                  : values.GetDouble(message, &field);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return static_cast<double>(many ? values.GetRepeatedFloat(message, &field, index)
                                      : values.GetFloat(message, &field));
    case FieldDescriptor::CPPTYPE_INT32:
      return many ? values.GetRepeatedInt32(message, &field, index)
                  : values.GetInt32(message, &field);
    case FieldDescriptor::CPPTYPE_UINT32:
      return many ? values.GetRepeatedUInt32(message, &field, index)
                  : values.GetUInt32(message, &field);
    default:
      return std::nullopt;
  }
}

bool is_in_range(const FieldDescriptor& field, double number) {
  if (!std::isfinite(number)) return false;
  if (!field.options().HasExtension(config::range)) return true;
  const config::Range& range = field.options().GetExtension(config::range);
  return !(range.has_min() && number < range.min()) && !(range.has_max() && number > range.max());
}

SchemaFault inside(const std::string& outer, SchemaFault fault) {
  fault.key = outer + "." + fault.key;
  return fault;
}

std::optional<SchemaFault> fault_of_value(const Message& message,
                                          const FieldDescriptor& field,
                                          int index) {
  const std::string key = field.is_repeated() ? key_of(field.name(), index) : field.name();
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
    const google::protobuf::Reflection& values = *message.GetReflection();
    const Message& nested = field.is_repeated() ? values.GetRepeatedMessage(message, &field, index)
                                                : values.GetMessage(message, &field);
    const auto fault = first_fault(nested);
    return fault ? std::optional(inside(key, *fault)) : std::nullopt;
  }
  const std::optional<double> number = number_in(message, field, index);
  if (!number || is_in_range(field, *number)) return std::nullopt;
  return SchemaFault{key, text_of(*number), expected_value(field)};
}

std::optional<SchemaFault> fault_of_field(const Message& message, const FieldDescriptor& field) {
  const google::protobuf::Reflection& values = *message.GetReflection();
  if (field.is_repeated()) {
    for (int i = 0; i < values.FieldSize(message, &field); ++i) {
      if (auto fault = fault_of_value(message, field, i)) return fault;
    }
    return std::nullopt;
  }
  if (values.HasField(message, &field)) return fault_of_value(message, field, 0);
  if (!field.is_required()) return std::nullopt;
  return SchemaFault{field.name(), "nothing", expected_value(field)};
}

std::string names_of(const google::protobuf::EnumDescriptor& type) {
  std::string names;
  for (int i = 0; i < type.value_count(); ++i) {
    names += (i == 0 ? "" : ", ") + type.value(i)->name();
  }
  return names;
}

}  // namespace

std::optional<SchemaFault> first_fault(const Message& message) {
  const google::protobuf::Descriptor& type = *message.GetDescriptor();
  for (int i = 0; i < type.field_count(); ++i) {
    if (auto fault = fault_of_field(message, *type.field(i))) return fault;
  }
  return std::nullopt;
}

std::string expected_value(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return "a block { ... } with " + expected_keys(*field.message_type());
    case FieldDescriptor::CPPTYPE_ENUM:
      return "one of " + names_of(*field.enum_type());
    case FieldDescriptor::CPPTYPE_STRING:
      return "a text in quotes";
    case FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case FieldDescriptor::CPPTYPE_DOUBLE:
    case FieldDescriptor::CPPTYPE_FLOAT:
      return "a finite number" + range_in_words(field);
    default:
      return "a whole number" + range_in_words(field);
  }
}

std::string expected_keys(const google::protobuf::Descriptor& type) {
  std::string names;
  for (int i = 0; i < type.field_count(); ++i) {
    names += (i == 0 ? "" : ", ") + type.field(i)->name();
  }
  return names;
}

}  // namespace teamsight::settings
