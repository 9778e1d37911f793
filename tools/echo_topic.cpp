// tools/echo_topic.cpp: see tools/echo_topic.hpp.
#include "tools/echo_topic.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

#include <google/protobuf/util/json_util.h>

#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/reader.hpp"
#include "recording.pb.h"
#include "recording/to_proto.hpp"

namespace teamsight::tools {
namespace {

const char* name_of(bus::Presence presence) {
  switch (presence) {
    case bus::Presence::kAlive:
      return "alive";
    case bus::Presence::kSilent:
      return "silent";
    case bus::Presence::kGone:
      return "gone";
  }
  return "unknown";
}

template <class Proto, class Message>
std::string json_of(const Message& message) {
  Proto proto;
  recording::to_proto(message, proto);
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string json;
  if (!google::protobuf::util::MessageToJsonString(proto, &json, options).ok()) return "null";
  return json;
}

template <class Proto, class Message>
void print(const std::string& topic, const bus::Sample<Message>& sample) {
  const std::string message = sample.message ? json_of<Proto>(*sample.message) : "null";
  std::printf("{\"topic\":\"%s\",\"presence\":\"%s\",\"received_ns\":%lld,\"message\":%s}\n",
              topic.c_str(),
              name_of(sample.presence),
              static_cast<long long>(sample.received.time_since_epoch().count()),
              message.c_str());
  std::fflush(stdout);
}

std::string reason_for_silence(std::uint32_t writers, const bus::ReadCounters& counters) {
  for (std::size_t i = 0; i < bus::kRejectReasons; ++i) {
    if (counters.rejected[i] == 0) continue;
    return std::to_string(counters.total_rejected()) +
           " samples were dropped, the first reason is " +
           std::string(bus::to_string(static_cast<bus::Reject>(i)));
  }
  return writers == 0 ? "nobody writes it there"
                      : std::to_string(writers) + " writers are there but sent nothing";
}

template <class Message, class Proto>
int listen(const EchoRequest& request) {
  bus::Loop loop;
  const bus::Participant participant =
      bus::Participant::join(request.domain, [&]() { return loop.keeps_running(); });
  bus::Reader<Message> reader(participant);
  std::uint64_t heard = 0;
  loop.on_readable(reader.event_fd(), [&]() {
    reader.take(bus::host_now(), [&](const bus::Sample<Message>& sample) {
      if (request.count && heard >= *request.count) return;
      print<Proto>(request.topic, sample);
      if (sample.message) ++heard;
    });
    if (request.count && heard >= *request.count) loop.stop();
  });
  if (request.duration) loop.every(*request.duration, [&]() { loop.stop(); });
  loop.run();
  if (heard > 0) return 0;
  std::fprintf(stderr,
               "teamsight echo: no %s on domain %u with tag \"%s\": %s\n",
               request.topic.c_str(),
               request.domain.domain_id,
               request.domain.tag.c_str(),
               reason_for_silence(reader.live_writers(), reader.counters()).c_str());
  return 1;
}

struct Topic {
  std::string_view name;
  bool is_inside_host;
  int (*listen)(const EchoRequest&);
};

constexpr std::array kTopics{
    Topic{"ClockEcho", false, listen<bus::ClockEcho, v1::ClockEcho>},
    Topic{"ClockProbe", false, listen<bus::ClockProbe, v1::ClockProbe>},
    Topic{"Command", false, listen<bus::Command, v1::Command>},
    Topic{"Diagnostics", false, listen<bus::Diagnostics, v1::Diagnostics>},
    Topic{"Explanation", false, listen<bus::Explanation, v1::Explanation>},
    Topic{"GameState", false, listen<bus::GameState, v1::GameState>},
    Topic{"LinePoints", false, listen<bus::LinePoints, v1::LinePoints>},
    Topic{"Odometry", true, listen<bus::Odometry, v1::Odometry>},
    Topic{"RobotState", false, listen<bus::RobotState, v1::RobotState>},
    Topic{"Sightings", false, listen<bus::Sightings, v1::Sightings>},
    Topic{"Thumbnail", false, listen<bus::Thumbnail, v1::Thumbnail>},
    Topic{"Truth", true, listen<bus::Truth, v1::Truth>},
    Topic{"VirtualSensors", true, listen<bus::VirtualSensors, v1::VirtualSensors>},
    Topic{"WorldModel", false, listen<WorldModel, v1::WorldModel>},
};

const Topic& topic_named(std::string_view name) {
  std::string all;
  for (const Topic& topic : kTopics) {
    if (topic.name == name) return topic;
    all += (all.empty() ? "" : ", ") + std::string(topic.name);
  }
  throw std::runtime_error("echo: there is no topic \"" + std::string(name) +
                           "\", expected one of " + all);
}

}  // namespace

std::vector<std::string_view> echo_topics() {
  std::vector<std::string_view> names;
  names.reserve(kTopics.size());
  for (const Topic& topic : kTopics) names.push_back(topic.name);
  return names;
}

bool is_host_topic(std::string_view topic) {
  return topic_named(topic).is_inside_host;
}

int echo(const EchoRequest& request) {
  return topic_named(request.topic).listen(request);
}

}  // namespace teamsight::tools
