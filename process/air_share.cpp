// process/air_share.cpp: see air_share.hpp.
#include "process/air_share.hpp"

#include <optional>
#include <utility>

#include "bus/clock.hpp"
#include "bus/wire_meter.hpp"

namespace teamsight::process {
namespace {

constexpr Duration kStep = std::chrono::seconds(1);
constexpr double kJitter = 0.1;
constexpr double kTellRate =
    4000.0;  // bytes/s of what the team can do without; line points take 2.6 kB/s
constexpr double kTellBurst = 3000.0;
constexpr double kNear = 4.0;  // m

/// Where the surest ball ray meets the floor, roughly; nothing: it points at the sky.
std::optional<Eigen::Vector2d> ball_on_floor(const bus::Sightings& sightings) {
  const BallRay* best = nullptr;
  for (const BallRay& ball : sightings.balls) {
    if (best == nullptr || ball.confidence > best->confidence) best = &ball;
  }
  if (best == nullptr || best->ray_R.direction.z() >= 0.0) return std::nullopt;
  const double length = -best->ray_R.origin.z / best->ray_R.direction.z();
  return Eigen::Vector2d(best->ray_R.origin.x + length * best->ray_R.direction.x(),
                         best->ray_R.origin.y + length * best->ray_R.direction.y());
}

}  // namespace

AirShare::AirShare(const bus::Participant& team, std::string process)
    : team_(&team),
      process_(std::move(process)),
      others_(team),
      governor_(GovernorParameters{}),
      bucket_(kTellRate, kTellBurst),
      bytes_(bus::wire_counters(team.domain_id()).bytes),
      measured_(bus::host_now()) {}

void AirShare::attach(bus::Loop& loop) {
  loop.on_readable(others_.event_fd(), [this] { listen(); });
  loop.every(
      kStep, [this] { step(); }, kJitter);
}

void AirShare::listen() {
  const HostTime now = bus::host_now();
  others_.take(now, [&](const bus::Sample<bus::Diagnostics>& sample) {
    if (sample.message) governor_.heard(sample.message->process, sample.message->wire_bps, now);
  });
}

void AirShare::step() {
  const HostTime now = bus::host_now();
  const std::uint64_t bytes = bus::wire_counters(team_->domain_id()).bytes;
  own_bps_ = 8.0 * static_cast<double>(bytes - bytes_) / to_seconds(now - measured_);
  bytes_ = bytes;
  measured_ = now;
  governor_.heard(process_, own_bps_, now);
  governor_.step(now);
  ++steps_;
}

bool AirShare::may_tell(std::size_t bytes, HostTime now) {
  constexpr std::uint32_t kRarely = 3;
  if (thrift() >= Thrift::kRareDiagnostics && steps_ % kRarely != 0) return false;
  return bucket_.take(static_cast<double>(bytes), now);
}

void AirShare::tell(bus::Diagnostics& report) const {
  report.wire_bps = own_bps_;
  report.thrift = static_cast<std::uint8_t>(thrift());
  report.secured = team_->is_secured();
  if (report.message.empty()) report.message = to_text(thrift());
}

std::size_t trim(bus::Sightings& sightings, Thrift thrift) {
  if (thrift < Thrift::kNearObstacles) return 0;
  const Eigen::Vector2d centre = ball_on_floor(sightings).value_or(Eigen::Vector2d::Zero());
  return std::erase_if(sightings.obstacles, [&](const ObstacleSighting& obstacle) {
    return thrift == Thrift::kNoObstacles || (obstacle.p_RO.vector() - centre).norm() > kNear;
  });
}

}  // namespace teamsight::process
