// monitor/viewer/protocol.cpp: see monitor/viewer/protocol.hpp.
#include "monitor/viewer/protocol.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <google/protobuf/stubs/strutil.h>
#include <nlohmann/json.hpp>

namespace teamsight::monitor {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 2> kProtocols{"foxglove.sdk.v1", "foxglove.websocket.v1"};

std::string base64(std::string_view bytes) {
  std::string text;
  google::protobuf::Base64Escape({bytes.data(), bytes.size()}, &text);
  return text;
}

/// A whole number of 32 bits; nothing: it is something else.
std::optional<std::uint32_t> number(const json& value) {
  if (!value.is_number_integer() || value < 0) return std::nullopt;
  if (value > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return value.get<std::uint32_t>();
}

/// The member `key` of an object, if it is a whole number of 32 bits.
std::optional<std::uint32_t> number_in(const json& object, const char* key) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(key);
  return found == object.end() ? std::nullopt : number(*found);
}

/// The member `key` of a request, if it is a list; else an empty one.
json list_in(const json& request, const char* key) {
  const auto found = request.find(key);
  return found != request.end() && found->is_array() ? *found : json::array();
}

/// Adds what an entry of "subscriptions" asks for, if it can be had.
bool subscribe(std::map<std::uint32_t, recording::ChannelId>& all,
               const json& wish,
               std::size_t channels) {
  const auto id = number_in(wish, "id");
  const auto channel = number_in(wish, "channelId");
  const bool is_good = id && channel && *channel < channels && all.size() < kMaxSubscriptions;
  return is_good && all.try_emplace(*id, *channel).second;
}

/// How many entries of a list `take` turns down.
template <class Take>
std::size_t refused_of(const json& list, const Take& take) {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [&](const json& entry) { return !take(entry); }));
}

/// Bytes that are no UTF-8, as a team file's name may have, do not end the station.
std::string text_of(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string name_of(const json& request) {
  if (!request.is_object()) return {};
  const auto op = request.find("op");
  return op != request.end() && op->is_string() ? op->get<std::string>() : std::string();
}

}  // namespace

std::string_view viewer_protocol(std::string_view offered) {
  while (!offered.empty()) {
    const auto comma = offered.find(',');
    std::string_view name = offered.substr(0, comma);
    name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
    name = name.substr(0, name.find(' '));
    const auto known = std::find(kProtocols.begin(), kProtocols.end(), name);
    if (known != kProtocols.end()) return *known;
    offered.remove_prefix(comma == std::string_view::npos ? offered.size() : comma + 1);
  }
  return {};
}

std::string viewer_greeting(std::string_view name, std::string_view session) {
  return text_of({{"op", "serverInfo"},
                  {"name", name},
                  {"capabilities", json::array()},
                  {"supportedEncodings", json::array()},
                  {"metadata", json::object()},
                  {"sessionId", session}});
}

std::string viewer_advertisement(recording::ChannelId first,
                                 const std::vector<recording::Channel>& channels) {
  json list = json::array();
  for (const recording::Channel& channel : channels) {
    list.push_back({{"id", first++},
                    {"topic", channel.topic},
                    {"encoding", channel.encoding},
                    {"schemaName", channel.schema.name},
                    {"schemaEncoding", channel.schema.encoding},
                    {"schema", base64(channel.schema.data)}});
  }
  return text_of({{"op", "advertise"}, {"channels", std::move(list)}});
}

std::string viewer_status(StatusLevel level, std::string_view text) {
  return text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", text}});
}

ViewerHeader viewer_header(std::uint32_t subscription, std::int64_t log_ns) {
  ViewerHeader header{1};  // the opcode of message data
  for (unsigned i = 0; i < 4; ++i) {
    header[1 + i] = static_cast<char>(subscription >> (8 * i) & 0xFFU);
  }
  const auto ns = static_cast<std::uint64_t>(log_ns);
  for (unsigned i = 0; i < 8; ++i) header[5 + i] = static_cast<char>(ns >> (8 * i) & 0xFFU);
  return header;
}

std::string Subscriptions::hear(std::string_view text, std::size_t channels) {
  const json request = json::parse(text, nullptr, false);
  const std::string op = name_of(request);
  std::size_t refused = 0;
  if (op == "subscribe") {
    refused = refused_of(list_in(request, "subscriptions"),
                         [&](const json& wish) { return subscribe(all_, wish, channels); });
  } else if (op == "unsubscribe") {
    refused = refused_of(list_in(request, "subscriptionIds"), [&](const json& entry) {
      const auto id = number(entry);
      return id && all_.erase(*id) != 0;
    });
  } else {
    return viewer_status(StatusLevel::kError,
                         "this station only takes subscribe and unsubscribe, as JSON text");
  }
  if (refused == 0) return {};
  return viewer_status(StatusLevel::kWarning,
                       std::to_string(refused) + " of \"" + op +
                           "\" refused: unknown or repeated number, or too many");
}

}  // namespace teamsight::monitor
