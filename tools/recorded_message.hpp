// tools/recorded_message.hpp: payloads read by the schema that stands in their recording.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "recording/mcap_writer.hpp"

namespace google::protobuf {
class Message;
}

namespace teamsight::tools {

/// Parses the messages of channels by the channels' own schemas.
class RecordedMessages {
 public:
  RecordedMessages();
  ~RecordedMessages();
  RecordedMessages(const RecordedMessages&) = delete;
  RecordedMessages& operator=(const RecordedMessages&) = delete;

  /// The message, valid until the next call for the same channel; null if channel or payload is no
  /// protobuf.
  [[nodiscard]] const google::protobuf::Message* parse(const recording::Channel& channel,
                                                       std::string_view payload);

 private:
  struct Type;
  std::map<const recording::Channel*, std::unique_ptr<Type>> types_;
};

/// All fields, in their order, as JSON; "null" if there is no such text.
[[nodiscard]] std::string json_of(const google::protobuf::Message& message);

/// Every single number, text and flag by its path, e.g. "posture.posture.cov.0".
[[nodiscard]] std::map<std::string, std::string> flat(const google::protobuf::Message& message);

}  // namespace teamsight::tools
