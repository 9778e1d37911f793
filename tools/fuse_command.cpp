// tools/fuse_command.cpp: see tools/fuse_command.hpp.
#include "tools/fuse_command.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bus/leader_clock.hpp"
#include "bus/topics.hpp"
#include "fusion/fusion.hpp"
#include "process/program.hpp"
#include "recording/from_proto.hpp"
#include "recording/output_file.hpp"
#include "recording/topic_channel.hpp"
#include "settings/load.hpp"
#include "tools/log_actions.hpp"

namespace teamsight::tools {
namespace {

constexpr Duration kPeriod = std::chrono::nanoseconds(33'333'333);  // between two worlds

struct Request {
  std::filesystem::path in;
  std::filesystem::path team;
  std::filesystem::path out;
  RobotId without{kNobody};
  LogSelection selection;
};

/// A recorded message as a reader on the recorder's computer took it; nothing if it is none.
template <class Message>
std::optional<bus::Sample<Message>> sample_of(const recording::Message& recorded,
                                              std::int64_t log_minus_host_ns) {
  if (recorded.channel->topic != bus::topic_profile<Message>().topic) return std::nullopt;
  bus::Sample<Message> sample;
  sample.message = recording::from_payload<Message>(recorded.payload);
  if (!sample.message) return std::nullopt;
  sample.received = HostTime(Duration(recorded.stamp.log_ns - log_minus_host_ns));
  return sample;
}

/// The worlds as a recording of their own.
class WorldFile {
 public:
  WorldFile(const std::filesystem::path& path, const recording::Contents& contents)
      : file_(path),
        writer_([this](std::string_view bytes) { return file_.write(bytes); }, contents.library),
        channel_(writer_.add_channel(recording::channel_of<WorldModel>())) {
    for (const auto& [name, values] : contents.metadata) writer_.add_metadata(name, values);
  }

  void write(const WorldModel& world, std::int64_t log_ns) {
    const std::int64_t published_ns = world.stamp.time_since_epoch().count();
    writer_.write(channel_, {log_ns, published_ns, ++sequence_}, recording::payload_of(world));
  }

  /// @throws RecordingError if not everything could be written
  void finish() {
    writer_.finish();
    if (!file_.problem().empty()) throw recording::RecordingError(file_.problem());
  }

 private:
  recording::OutputFile file_;
  recording::McapWriter writer_;
  std::uint16_t channel_;
  std::uint32_t sequence_{0};
};

/// Fusion over one recording: takes its messages one by one, and makes a world 30 times a second.
class FusedRecording {
 public:
  FusedRecording(fusion::Fusion fusion, const Request& request, std::int64_t log_minus_host_ns)
      : fusion_(std::move(fusion)),
        without_(request.without),
        log_minus_host_ns_(log_minus_host_ns) {}

  /// What the leading fusion's clock said first holds for what came before, too.
  ///
  /// @return whether more may be learned of the clocks
  bool learn_clock(const recording::Message& message) {
    has_world_ = hear_clock<WorldModel>(message) || has_world_;
    has_explanation_ = hear_clock<bus::Explanation>(message) || has_explanation_;
    return !has_world_ || !has_explanation_;
  }

  /// @param use  called with each world that is due by then, and its time on the recording's clock
  template <class Use>
  void take(const recording::Message& message, const Use& use) {
    const HostTime host(Duration(message.stamp.log_ns - log_minus_host_ns_));
    now_ = std::max(now_, clock_.at(host));
    if (maker_ == kNobody) next_ = now_ + kPeriod;  // nothing has been seen yet
    for (; next_ <= now_; next_ += kPeriod) {
      WorldModel world = fusion_.world_at(next_);
      world.id = {maker_, kBoot, ++worlds_};
      if (!world.balls.empty()) ++with_ball_;
      use(world, message.stamp.log_ns);
    }
    hear_clock<WorldModel>(message);
    hear_clock<bus::Explanation>(message);
    if (const auto sample = sample_of<bus::Sightings>(message, log_minus_host_ns_)) {
      insert(*sample->message);
    }
  }

  [[nodiscard]] nlohmann::ordered_json summary() const {
    nlohmann::ordered_json json;
    json["worlds"] = worlds_;
    json["with_ball"] = with_ball_;
    json["sightings"] = offered_;
    json["accepted"] = accepted_;
    json["without_clock"] = without_clock_;
    return json;
  }

  [[nodiscard]] bool has_worlds() const { return accepted_ > 0; }

 private:
  // The worlds go out as those of the first robot that is heard, from a process of its own.
  static constexpr std::uint32_t kBoot = 1;

  template <class Message>
  bool hear_clock(const recording::Message& message) {
    const auto sample = sample_of<Message>(message, log_minus_host_ns_);
    if (sample) clock_.hear(*sample);
    return sample.has_value();
  }

  void insert(const bus::Sightings& seen) {
    if (seen.id.robot == without_) return;
    if (maker_ == kNobody) maker_ = seen.id.robot;
    ++offered_;
    const auto exposure = clock_.moment_of(seen.id.robot, seen.exposure, now_);
    if (!exposure) {
      ++without_clock_;
      return;
    }
    const auto intake = fusion_.insert(
        {seen.id, exposure->time, exposure->sigma, seen.posture, seen.balls, seen.obstacles}, now_);
    if (intake == fusion::Intake::kAccepted) ++accepted_;
  }

  fusion::Fusion fusion_;
  bus::LeaderClock clock_;
  RobotId without_;
  std::int64_t log_minus_host_ns_;
  RobotId maker_{kNobody};
  bool has_world_{false};
  bool has_explanation_{false};
  HostTime now_;
  HostTime next_;
  std::uint32_t worlds_{0};
  std::uint64_t with_ball_{0};
  std::uint64_t offered_{0};
  std::uint64_t accepted_{0};
  std::uint64_t without_clock_{0};
};

fusion::Fusion fusion_for(const std::filesystem::path& team_file) {
  const settings::TeamSettings team = settings::load_team(team_file);
  fusion::Parameters parameters;
  parameters.ball_radius = team.ball_radius;
  parameters.robot_radius = team.robot_radius;
  return fusion::Fusion(parameters, settings::load_field(team.field));
}

int fuse(const Request& request) {
  const recording::McapReader reader(request.in);
  const recording::TimeSpan span = span_of(request.selection, reader.contents());
  FusedRecording fused(fusion_for(request.team), request, log_minus_host_of(reader.contents()));
  std::optional<WorldFile> file;
  if (!request.out.empty()) file.emplace(request.out, reader.contents());
  reader.for_each(span,
                  [&](const recording::Message& message) { return fused.learn_clock(message); });
  reader.for_each(span, [&](const recording::Message& message) {
    fused.take(message, [&](const WorldModel& world, std::int64_t log_ns) {
      if (file) file->write(world, log_ns);
    });
    return true;
  });
  if (file) file->finish();
  std::cout << fused.summary().dump() << std::endl;
  return fused.has_worlds() ? process::kDone : process::kAnswerIsNo;
}

}  // namespace

void add_fuse_command(CLI::App& app, int& exit_code) {
  const auto request = std::make_shared<Request>();
  CLI::App* command = app.add_subcommand("fuse", "Fusion over the Sightings of a recording");
  command->add_option("recording", request->in, "MCAP file")->required();
  command->add_option("--team", request->team, "team file (config/teams)")->required();
  command->add_option("--out", request->out, "new MCAP file with the worlds");
  command->add_option("--without", request->without, "leaves this robot out")
      ->check(CLI::Range(1, int{kMaxRobotId}));
  command->add_option("--from", request->selection.from_s, "seconds since the first message");
  command->add_option("--until", request->selection.until_s, "seconds since the first message");
  command->callback([request, &exit_code] { exit_code = fuse(*request); });
}

}  // namespace teamsight::tools
