// tests/bus/other_vendor_main.cpp: a robot on another vendor's DDS (Fast DDS), from the same IDL.
//
// usage: other_vendor DOMAIN TAG SECONDS
// Writes Sightings as robot 1, with a ball at (2, 0) m, and reads WorldModel and RobotState, on
// loopback alone. Exit code 0 as soon as a world shows that ball and a RobotState was read, else 1.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include "teamsightPubSubTypes.h"

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;
namespace v1 = teamsight::v1;

std::string domain_tag;  // written before the first packet

/// An RTPS message with the tag in its announcement of a participant, if it holds one: Fast DDS 2.9
/// knows the parameter's number and never sends it, and Cyclone hears nobody without its own tag.
std::vector<std::uint8_t> tagged(std::vector<std::uint8_t> message) {
  constexpr std::uint8_t kData = 0x15;
  constexpr std::array<std::uint8_t, 4> kAnnouncer{0x00, 0x01, 0x00, 0xc2};
  for (std::size_t at = 20; at + 24 <= message.size();) {
    std::size_t length = message[at + 2] | static_cast<std::size_t>(message[at + 3]) << 8U;
    if (length == 0) length = message.size() - at - 4;
    const std::size_t end = at + 4 + length;
    if (end > message.size()) break;
    if (message[at] == kData &&
        std::equal(kAnnouncer.begin(), kAnnouncer.end(), &message[at + 12])) {
      const std::size_t text = (domain_tag.size() + 1 + 3) / 4 * 4;
      std::vector<std::uint8_t> parameter(8 + text);
      parameter[0] = 0x14;
      parameter[1] = 0x40;
      parameter[2] = static_cast<std::uint8_t>(4 + text);
      parameter[4] = static_cast<std::uint8_t>(domain_tag.size() + 1);
      std::copy(domain_tag.begin(), domain_tag.end(), parameter.begin() + 8);
      length += parameter.size();
      message[at + 2] = static_cast<std::uint8_t>(length);
      message[at + 3] = static_cast<std::uint8_t>(length >> 8U);
      const auto sentinel = message.begin() + static_cast<std::ptrdiff_t>(end - 4);
      message.insert(sentinel, parameter.begin(), parameter.end());
      break;
    }
    at = end;
  }
  return message;
}

std::int64_t now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch().count();
}

/// A ball at (2, 0) m, seen by a robot that stands in the centre and looks at the opponent goal.
v1::Sightings sightings(std::uint32_t sequence) {
  constexpr float kMirror_m = 0.8F;
  constexpr float kBall_m = 2.0F;
  constexpr float kBallRadius_m = 0.11F;
  const float range = std::hypot(kBall_m, kMirror_m - kBallRadius_m);
  v1::BallRay ray;
  ray.origin_m({0, 0, kMirror_m});
  ray.direction({kBall_m / range, 0, (kBallRadius_m - kMirror_m) / range});
  ray.cov_direction({1e-5F, 0, 1e-5F});
  ray.confidence(0.9F);
  ray.colour(1);
  v1::Sightings all;
  all.robot_id(1);
  all.sample().robot_id(1);
  all.sample().boot_id(77);
  all.sample().sequence_number(sequence);
  all.publish_ns(now_ns());
  all.exposure_ns(all.publish_ns() - 10'000'000);
  all.posture().status(v1::POSTURE_OK);
  all.posture().posture().cov({1e-4F, 0, 0, 1e-4F, 0, 1e-5F});
  all.posture().half_log_odds(8);
  all.posture().inlier_ratio(0.9F);
  all.posture().line_points(100);
  all.light(1);
  all.balls().push_back(ray);
  return all;
}

bool shows_the_ball(const v1::WorldModel& world) {
  for (const v1::WorldBall& ball : world.balls()) {
    const bool is_there = std::hypot(ball.p_m()[0] - 2.0F, ball.p_m()[1]) < 0.2F;
    if (is_there && (ball.supporters() & 1U) != 0) return true;
  }
  return false;
}

dds::DomainParticipant* join(int domain) {
  dds::DomainParticipantQos qos;
  auto loopback = std::make_shared<rtps::UDPv4TransportDescriptor>();
  loopback->interfaceWhiteList.emplace_back("127.0.0.1");
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(loopback);
  auto& discovery = qos.wire_protocol().builtin.discovery_config;
  discovery.leaseDuration_announcementperiod = {1, 0};
  discovery.leaseDuration = {10, 0};
  return dds::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<std::uint32_t>(domain), qos);
}

template <class PubSubType>
dds::Topic* topic(dds::DomainParticipant& participant, const std::string& name) {
  dds::TypeSupport type(new PubSubType);  // takes it over
  type->auto_fill_type_object(false);
  type->auto_fill_type_information(false);
  type.register_type(&participant);
  return participant.create_topic(
      "teamsight/v1/" + name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
}

template <class Message, class Use>
void take(dds::DataReader& reader, const Use& use) {
  Message message;
  dds::SampleInfo info;
  while (reader.take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
    if (info.valid_data) use(message);
  }
}

/// The robot's mouth and ears.
struct Robot {
  dds::DataWriter* sightings;
  dds::DataReader* states;
  dds::DataReader* worlds;
};

Robot open_topics(dds::DomainParticipant& participant) {
  dds::DataWriterQos write = dds::DATAWRITER_QOS_DEFAULT;
  write.reliability().kind = dds::BEST_EFFORT_RELIABILITY_QOS;
  write.liveliness().kind = dds::MANUAL_BY_TOPIC_LIVELINESS_QOS;
  write.liveliness().lease_duration = {0, 200'000'000};
  write.liveliness().announcement_period = {0, 100'000'000};
  dds::DataReaderQos read = dds::DATAREADER_QOS_DEFAULT;
  read.reliability().kind = dds::BEST_EFFORT_RELIABILITY_QOS;
  dds::DataReaderQos read_exclusive = read;
  read_exclusive.ownership().kind = dds::EXCLUSIVE_OWNERSHIP_QOS;
  auto* const publisher = participant.create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  auto* const subscriber = participant.create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  return {
      publisher->create_datawriter(topic<v1::SightingsPubSubType>(participant, "Sightings"), write),
      subscriber->create_datareader(topic<v1::RobotStatePubSubType>(participant, "RobotState"),
                                    read),
      subscriber->create_datareader(topic<v1::WorldModelPubSubType>(participant, "WorldModel"),
                                    read_exclusive)};
}

int play(const Robot& robot, std::uint32_t turns) {
  int states = 0;
  int worlds = 0;
  bool has_ball = false;
  std::uint32_t turn = 0;
  while (turn < turns && !(has_ball && states > 0)) {
    v1::Sightings message = sightings(++turn);
    robot.sightings->write(&message);
    std::this_thread::sleep_for(std::chrono::milliseconds(33));
    take<v1::RobotState>(*robot.states, [&](const v1::RobotState& state) {
      const bool is_whole = state.robot_id() == 2 && state.software_version() == "0.1.0-test" &&
                            state.posture().posture().x_m() == 1.5F;
      if (is_whole) ++states;
    });
    take<v1::WorldModel>(*robot.worlds, [&](const v1::WorldModel& world) {
      ++worlds;
      has_ball = has_ball || shows_the_ball(world);
    });
  }
  std::printf("turns %u, states %d, worlds %d, ball %d\n", turn, states, worlds, has_ball);
  return has_ball && states > 0 ? 0 : 1;
}

}  // namespace

// In place of glibc's for every library of the process.
extern "C" ssize_t sendmsg(int socket, const msghdr* message, int flags) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < message->msg_iovlen; ++i) {
    const auto* const start = static_cast<const std::uint8_t*>(message->msg_iov[i].iov_base);
    bytes.insert(bytes.end(), start, start + message->msg_iov[i].iov_len);
  }
  const std::size_t size = bytes.size();
  bytes = tagged(std::move(bytes));
  iovec whole{bytes.data(), bytes.size()};
  msghdr changed = *message;
  changed.msg_iov = &whole;
  changed.msg_iovlen = 1;
  const ssize_t sent = syscall(SYS_sendmsg, socket, &changed, flags);
  return sent < 0 ? sent : static_cast<ssize_t>(size);
}

extern "C" ssize_t sendto(
    int socket, const void* data, size_t size, int flags, const sockaddr* to, socklen_t to_size) {
  iovec whole{const_cast<void*>(data), size};
  msghdr message{};
  message.msg_name = const_cast<sockaddr*>(to);
  message.msg_namelen = to_size;
  message.msg_iov = &whole;
  message.msg_iovlen = 1;
  return sendmsg(socket, &message, flags);
}

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  domain_tag = argv[2];
  eprosima::fastdds::dds::DomainParticipant* const participant = join(std::atoi(argv[1]));
  if (participant == nullptr) return 2;
  const Robot robot = open_topics(*participant);
  if (robot.sightings == nullptr || robot.states == nullptr || robot.worlds == nullptr) return 2;
  const int code = play(robot, 30U * static_cast<std::uint32_t>(std::atoi(argv[3])));
  std::fflush(stdout);
  std::_Exit(code);  // the kernel takes the rest back
}
