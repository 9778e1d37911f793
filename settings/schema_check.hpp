// settings/schema_check.hpp: required keys and ranges of any message, and words for what is
// expected.
#pragma once

#include <optional>
#include <string>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

namespace teamsight::settings {

/// What is wrong with one key of a message.
struct SchemaFault {
  std::string key;  ///< path from the message, e.g. `radial_table.row[2].radius_px`
  std::string found;
  std::string expected;
};

/// Walks over a message and all messages in it.
///
/// @return the first required key that is missing, number that is not finite, or number outside
///         its (range); nothing if the message keeps to its schema
[[nodiscard]] std::optional<SchemaFault> first_fault(const google::protobuf::Message& message);

/// What a field takes, in words: `a number from 1 to 120`, `one of BGR, YUYV, UYVY, GREY`.
[[nodiscard]] std::string expected_value(const google::protobuf::FieldDescriptor& field);

/// The keys that a message takes, in words.
[[nodiscard]] std::string expected_keys(const google::protobuf::Descriptor& type);

}  // namespace teamsight::settings
