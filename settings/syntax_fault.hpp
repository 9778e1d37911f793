// settings/syntax_fault.hpp: what protobuf's parser complains about, in this project's words.
#pragma once

#include <string>

#include <google/protobuf/descriptor.h>

#include "settings/schema_check.hpp"

namespace teamsight::settings {

/// Turns the parser's message into key, found and expected.
///
/// The key is not in the message: it is found by reading the text up to the complaint.
///
/// @param type     the message type of the whole file
/// @param text     the whole file
/// @param line, column  where the parser complained, from 0; tabs reach to the next multiple of 8
/// @param message  what it said
[[nodiscard]] SchemaFault syntax_fault(const google::protobuf::Descriptor& type,
                                       const std::string& text,
                                       int line,
                                       int column,
                                       const std::string& message);

}  // namespace teamsight::settings
