// bench/ping_cyclone.cpp: the bare Cyclone DDS pings of ping.hpp: the library's C API and nothing
// else.
#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>

#include <dds/dds.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <teamsight.h>
#include <unistd.h>

#include "bench/ping.hpp"

namespace teamsight::bench {
namespace {

dds_entity_t check(dds_entity_t result, const char* call) {
  if (result < 0) {
    throw std::runtime_error(std::string(call) + ": " + dds_strretcode(-result));
  }
  return result;
}

// A wire sample of the size that ping.hpp states; it points into itself.
struct PingSample {
  explicit PingSample(std::uint8_t robot_id) {
    wire.robot_id = robot_id;
    wire.balls._maximum = wire.balls._length = static_cast<std::uint32_t>(balls.size());
    wire.balls._buffer = balls.data();
    wire.obstacles._maximum = wire.obstacles._length = static_cast<std::uint32_t>(obstacles.size());
    wire.obstacles._buffer = obstacles.data();
  }

  PingSample(const PingSample&) = delete;
  PingSample& operator=(const PingSample&) = delete;
  PingSample(PingSample&&) = delete;
  PingSample& operator=(PingSample&&) = delete;
  ~PingSample() = default;

  std::array<teamsight_v1_BallRay, kPingBalls> balls{};
  std::array<teamsight_v1_ObstacleSighting, kPingObstacles> obstacles{};
  teamsight_v1_Sightings wire{};
};

// The same configuration as that of bus/, without the log file that the library would leave behind.
std::string configuration(const std::string& path) {
  return "file://" + std::filesystem::absolute(path).string() +
         ",<CycloneDDS><Domain Id=\"any\"><Tracing><OutputFile>/dev/null</OutputFile></Tracing>"
         "</Domain></CycloneDDS>";
}

// Participant, writer and reader of one end; a participant hears no writer of its own.
class Node {
 public:
  Node(const PingPlan& plan,
       std::uint8_t robot_id,
       dds_on_data_available_fn on_data,
       void* argument)
      : sample_(robot_id),
        domain_(check(dds_create_domain(plan.domain_id, configuration(plan.profile_path).c_str()),
                      "dds_create_domain")) {
    dds_qos_t* const qos = dds_create_qos();
    dds_qset_ignorelocal(qos, DDS_IGNORELOCAL_PARTICIPANT);
    dds_qset_reliability(qos, DDS_RELIABILITY_BEST_EFFORT, 0);
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 1);
    const dds_entity_t participant =
        check(dds_create_participant(plan.domain_id, nullptr, nullptr), "dds_create_participant");
    const dds_entity_t topic =
        check(dds_create_topic(
                  participant, &teamsight_v1_Sightings_desc, "bench/Sightings", nullptr, nullptr),
              "dds_create_topic");
    writer_ = check(dds_create_writer(participant, topic, qos, nullptr), "dds_create_writer");
    dds_listener_t* const listener = dds_create_listener(argument);
    if (on_data != nullptr) {
      dds_lset_data_available(listener, on_data);
    }
    reader_ = check(dds_create_reader(participant, topic, qos, listener), "dds_create_reader");
    dds_delete_listener(listener);
    dds_delete_qos(qos);
  }

  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  Node(Node&&) = delete;
  Node& operator=(Node&&) = delete;

  ~Node() { dds_delete(domain_); }

  void write() {
    ++sample_.wire.sample.sequence_number;
    dds_write(writer_, &sample_.wire);
  }

  // Takes everything; whether there was anything.
  [[nodiscard]] static bool take(dds_entity_t reader) {
    std::array<void*, 8> samples{};
    std::array<dds_sample_info_t, 8> infos{};
    bool any = false;
    int count = 0;
    do {
      count = dds_take(reader, samples.data(), infos.data(), samples.size(), samples.size());
      for (std::size_t i = 0; count > 0 && i < static_cast<std::size_t>(count); ++i) {
        any = any || infos.at(i).valid_data;
      }
      dds_return_loan(reader, samples.data(), count);
    } while (count == static_cast<int>(samples.size()));
    return any;
  }

  [[nodiscard]] dds_entity_t reader() const { return reader_; }

 private:
  PingSample sample_;
  dds_entity_t domain_;
  dds_entity_t writer_{0};
  dds_entity_t reader_{0};
};

dds_entity_t waitset_on(dds_entity_t reader) {
  const dds_entity_t waitset =
      check(dds_create_waitset(DDS_CYCLONEDDS_HANDLE), "dds_create_waitset");
  check(dds_set_status_mask(reader, DDS_DATA_AVAILABLE_STATUS), "dds_set_status_mask");
  check(dds_waitset_attach(waitset, reader, 0), "dds_waitset_attach");
  return waitset;
}

// Waits for data and takes it; false if none came in time.
bool wait_and_take(dds_entity_t waitset, dds_entity_t reader) {
  std::array<dds_attach_t, 1> triggered{};
  return dds_waitset_wait(waitset, triggered.data(), triggered.size(), kAnswerWithin.count()) > 0 &&
         Node::take(reader);
}

[[noreturn]] void sleep_for_ever() {
  while (true) {
    std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

}  // namespace

PingResult ping_cyclone_waitset(const PingPlan& plan) {
  Node node(plan, 1, nullptr, nullptr);
  const dds_entity_t waitset = waitset_on(node.reader());
  return run_pings(plan, [&] {
    node.write();
    return wait_and_take(waitset, node.reader());
  });
}

void echo_cyclone_waitset(const PingPlan& plan) {
  Node node(plan, 2, nullptr, nullptr);
  const dds_entity_t waitset = waitset_on(node.reader());
  while (true) {
    if (wait_and_take(waitset, node.reader())) {
      node.write();
    }
  }
}

PingResult ping_cyclone_listener(const PingPlan& plan) {
  const int event = ::eventfd(0, EFD_CLOEXEC);
  int argument = event;
  const auto on_data = [](dds_entity_t reader, void* descriptor) {
    const std::uint64_t one = 1;
    if (Node::take(reader)) {
      [[maybe_unused]] const ssize_t done = ::write(*static_cast<int*>(descriptor), &one, 8);
    }
  };
  Node node(plan, 1, on_data, &argument);
  PingResult result = run_pings(plan, [&] {
    node.write();
    pollfd answer{event, POLLIN, 0};
    std::uint64_t count = 0;
    return ::poll(&answer, 1, static_cast<int>(kAnswerWithin / std::chrono::milliseconds(1))) > 0 &&
           ::read(event, &count, sizeof(count)) > 0;
  });
  ::close(event);
  return result;
}

void echo_cyclone_listener(const PingPlan& plan) {
  std::atomic<Node*> self = nullptr;  // data may come before the node is whole
  const auto on_data = [](dds_entity_t reader, void* node) {
    Node* const whole = static_cast<std::atomic<Node*>*>(node)->load();
    if (Node::take(reader) && whole != nullptr) {
      whole->write();
    }
  };
  Node node(plan, 2, on_data, &self);
  self = &node;
  sleep_for_ever();
}

}  // namespace teamsight::bench
