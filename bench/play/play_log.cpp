// bench/play/play_log.cpp: see bench/play/play_log.hpp.
#include "bench/play/play_log.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::play {
namespace {

constexpr double kSilentFrom = 6.0;  // s; robot k falls silent k seconds after that
constexpr double kSilentFor = 4.0;   // s

bool is_silent(RobotId robot, double t) {
  const double from = kSilentFrom + robot;
  return robot != 1 && t >= from && t < from + kSilentFor;
}

/// Eyes whose errors are drawn.
class DrawnEyes final : public Eyes {
 public:
  DrawnEyes(const Scenario& scenario, std::uint64_t seed) : play_(scenario.play) {
    for (int i = 0; i < scenario.play.own; ++i) {
      const auto robot = static_cast<RobotId>(i + 1);
      robots_.emplace_back(scenario.perception, robot, seed * 131 + robot);
    }
  }

  void set_fault(std::size_t robot, Fault fault, const Moment& moment) override {
    robots_[robot].set_fault(fault, moment);
  }

  void begin(const Moment& /*first*/) override {}

  void step(const Moment& /*moment*/) override {}

  [[nodiscard]] Frame look(std::size_t robot, const Moment& moment, double since) override {
    Perception& eye = robots_[robot];
    Frame frame;
    frame.observation = eye.look(moment, since, play_);
    frame.seen_balls = eye.seen_balls();
    frame.seen_players = eye.seen_players();
    return frame;
  }

 private:
  PlayParameters play_;
  std::vector<Perception> robots_;
};

/// Plays one seed, step by step.
class Recorder {
 public:
  Recorder(const Scenario& scenario, std::uint64_t seed, Eyes& eyes)
      : play_(scenario.play, play_field(), seed),
        random_(seed * 7919 + 1),
        eyes_(eyes) {
    log_.scenario = scenario;
    for (int i = 0; i < scenario.play.own; ++i) {
      clocks_.emplace_back(scenario.clocks, scenario.network, random_);
      next_frame_.push_back(uniform(random_, 0.0, 1.0 / scenario.perception.rate));
      last_frame_.push_back(0.0);
    }
  }

  PlayLog record(double seconds) {
    log_.moments.push_back(play_.moment());
    begin_faults();
    eyes_.begin(play_.moment());
    while (play_.moment().t < seconds) step();
    std::stable_sort(log_.deliveries.begin(), log_.deliveries.end(), [](auto& a, auto& b) {
      return a.arrival < b.arrival;
    });
    date_deliveries();
    return std::move(log_);
  }

 private:
  void step() {
    play_.step();
    const Moment& moment = play_.moment();
    log_.moments.push_back(moment);
    begin_faults();
    eyes_.step(moment);
    for (std::size_t i = 0; i < clocks_.size(); ++i) {
      if (moment.t >= next_frame_[i]) look(i);
    }
  }

  void begin_faults() {
    const Moment& moment = play_.moment();
    for (const FaultPlan& plan : log_.scenario.faults) {
      if (std::abs(moment.t - plan.from) < 0.5 * Play::kStep) {
        eyes_.set_fault(static_cast<std::size_t>(plan.robot) - 1, plan.fault, moment);
      }
    }
  }

  void look(std::size_t i) {
    const Moment& moment = play_.moment();
    const Scenario& scenario = log_.scenario;
    next_frame_[i] += 1.0 / scenario.perception.rate;
    Frame frame = eyes_.look(i, moment, moment.t - last_frame_[i]);
    frame.exposure = moment.t;
    last_frame_[i] = moment.t;
    if (scenario.is_joining && is_silent(frame.observation.id.robot, moment.t)) return;
    log_.frames.push_back(frame);
    send();
  }

  void send() {
    const NetworkParameters& network = log_.scenario.network;
    const double sent = log_.frames.back().exposure + network.processing;
    if (uniform(random_, 0.0, 1.0) < network.loss) return;
    const int copies = uniform(random_, 0.0, 1.0) < network.duplicates ? 2 : 1;
    for (int copy = 0; copy < copies; ++copy) {
      Delivery delivery;
      delivery.frame = log_.frames.size() - 1;
      delivery.arrival = sent + uniform(random_, network.min_delay, network.max_delay);
      log_.deliveries.push_back(delivery);
    }
  }

  /// As the receiver would, in the order of arrival; undated ones are lost.
  void date_deliveries() {
    std::vector<Delivery> dated;
    for (Delivery& delivery : log_.deliveries) {
      const Frame& frame = log_.frames[delivery.frame];
      PeerClockModel& clock = clocks_[static_cast<std::size_t>(frame.observation.id.robot) - 1];
      clock.advance_to(delivery.arrival, random_);
      const auto converted = clock.convert(frame.exposure, delivery.arrival);
      if (!converted) continue;
      if (const auto error = clock.error_at(delivery.arrival); error && frame.exposure > 2.0) {
        log_.worst_clock_error = std::max(log_.worst_clock_error, std::abs(*error));
      }
      delivery.exposure = converted->time;
      delivery.sigma_exposure = converted->sigma;
      dated.push_back(delivery);
    }
    log_.deliveries = std::move(dated);
  }

  Play play_;
  Random random_;
  PlayLog log_;
  Eyes& eyes_;
  std::vector<PeerClockModel> clocks_;
  std::vector<double> next_frame_;
  std::vector<double> last_frame_;
};

}  // namespace

FieldModel play_field() {
  FieldModel field;
  field.length = 22.0;
  field.width = 14.0;
  field.surround = 1.0;
  return field;
}

const Moment& PlayLog::at(double t) const {
  const auto index = static_cast<std::size_t>(std::max(0.0, std::round(t / Play::kStep)));
  return moments[std::min(index, moments.size() - 1)];
}

fusion::Observation PlayLog::observation(const Delivery& delivery) const {
  fusion::Observation observation = frames[delivery.frame].observation;
  observation.exposure = delivery.exposure;
  observation.sigma_exposure = delivery.sigma_exposure;
  return observation;
}

PlayLog play_log(const Scenario& scenario, std::uint64_t seed, double seconds) {
  DrawnEyes eyes(scenario, seed);
  PlayLog log = play_log(scenario, seed, seconds, eyes);
  log.has_known_errors = true;
  return log;
}

PlayLog play_log(const Scenario& scenario, std::uint64_t seed, double seconds, Eyes& eyes) {
  return Recorder(scenario, seed, eyes).record(seconds);
}

}  // namespace teamsight::play
