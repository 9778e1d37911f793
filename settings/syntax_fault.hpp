// settings/syntax_fault.hpp: what protobuf's parser complains about, in this project's words.
#pragma once

#include <string>

#include <google/protobuf/descriptor.h>

#include "settings/schema_check.hpp"

namespace teamsight::settings {

/// A complaint and where it points: line and column from 0, tabs reach to the next multiple of 8.
struct SyntaxFault : SchemaFault {
  int line{0};
  int column{0};
};

/// Turns the parser's complaint into key, found and expected.
///
/// The key is not in protobuf's message: it is found by reading the text up to the complaint. For
/// some complaints the parser is already past the word in question; then the place is corrected.
///
/// @param type       the message type of the whole file
/// @param text       the whole file
/// @param complaint  where the parser complained, with its message as `found`
[[nodiscard]] SyntaxFault syntax_fault(const google::protobuf::Descriptor& type,
                                       const std::string& text,
                                       const SyntaxFault& complaint);

}  // namespace teamsight::settings
