// monitor/referee/referee.cpp: see monitor/referee/referee.hpp.
#include "monitor/referee/referee.hpp"

#include <chrono>
#include <utility>

#include "bus/clock.hpp"
#include "monitor/referee/world_state.hpp"

namespace teamsight::monitor {
namespace {

// The league wants 10 Hz or more.
constexpr Duration kWorldPeriod = std::chrono::milliseconds(50);
constexpr Duration kGamePeriod = std::chrono::seconds(1);
constexpr std::uint64_t kMostComplaints = 20;

}  // namespace

Referee::Referee(RefereeSettings settings,
                 const bus::Participant& team,
                 bus::Loop& loop,
                 Station& station)
    : settings_(std::move(settings)),
      games_(team),
      others_(team),
      station_(&station),
      book_(settings_.own_address) {
  if (settings_.box) {
    link_ = std::make_unique<BoxLink>(
        *settings_.box,
        loop,
        BoxLink::Listener{[this](std::string_view message) { hear(message); },
                          [this](bool is_connected) {
                            note_connection(is_connected);
                          }});
    loop.every(kWorldPeriod, [this]() { send_world(); });
  }
  loop.on_readable(others_.event_fd(), [this]() { hear_others(); });
  loop.every(kGamePeriod, [this]() { publish(bus::host_now()); });
}

Referee::~Referee() = default;

void Referee::hear(std::string_view message) {
  const auto command = parse_box_command(message);
  if (command) {
    carry_out(*command, "Referee: ");
  } else if (++refused_ <= kMostComplaints) {
    station_->note(bus::host_now(),
                   Level::kWarning,
                   "A message of the referee box could not be read: " + command.error());
  }
}

void Referee::hear_others() {
  const HostTime now = bus::host_now();
  others_.take(now, [&](const bus::Sample<bus::GameState>& sample) {
    if (!sample.message || !book_.hear(*sample.message, settings_.boot, now)) return;
    station_->note(now,
                   Level::kWarning,
                   "Another station tells the robots the game: this one follows it, until it "
                   "gives a command itself");
  });
}

void Referee::carry_out(const BoxCommand& command, const std::string& who) {
  const HostTime now = bus::host_now();
  station_->note(now, Level::kInfo, who + book_.apply(command, now));
  publish(now);
}

void Referee::note_connection(bool is_connected) {
  const HostTime now = bus::host_now();
  book_.set_connected(is_connected);
  station_->note(now,
                 is_connected ? Level::kInfo : Level::kAlarm,
                 is_connected ? "The referee box is connected" : "The referee box is gone");
  sent_at_.clear();
  counted_sent_ = 0;
  publish(now);
}

std::string Referee::by_hand(const RefereeOrder& order) {
  if (link_ && link_->is_connected()) return "the referee box is connected: it decides";
  if (book_.other_has_box(bus::host_now())) {
    return "another station is connected to the referee box: it decides";
  }
  BoxCommand command;
  command.name = order.command;
  if (order.side == Side::kOurs) command.target = GameBook::kOurs;
  if (order.side == Side::kTheirs) command.target = GameBook::kTheirs;
  carry_out(command, "By hand: ");
  return {};
}

void Referee::publish(HostTime now) {
  if (book_.take_over(now)) {
    station_->note(now,
                   Level::kWarning,
                   "The station that told the robots the game is silent: this one goes on with it");
  }
  if (!book_.speaks()) return;
  bus::GameState state = book_.state(now);
  state.id = {kNobody, settings_.boot, ++sequence_};
  state.stamp = stamp_of(now);
  games_.write(state);
}

void Referee::send_world() {
  const HostTime now = bus::host_now();
  if (!link_->is_connected() || station_->world() == nullptr) return;
  WorldStateInput input;
  input.team = settings_.team;
  input.intention = book_.state(now).running ? "play" : "stop";
  input.world = station_->world();
  input.robots = station_->states();
  input.age = station_->world_information_age(now);
  std::string text = world_state(input);
  if (fault_of_world_state(text)) {
    ++refused_;
    return;
  }
  link_->send(std::move(text));
  for (; counted_sent_ < link_->sent(); ++counted_sent_) sent_at_.push_back(now);
  while (!sent_at_.empty() && now - sent_at_.front() > std::chrono::seconds(1)) {
    sent_at_.pop_front();
  }
}

RefereeReport Referee::report(HostTime now) const {
  RefereeReport report;
  report.state = book_.state(now);
  report.last_command = book_.last_command();
  report.has_box = settings_.box.has_value();
  report.tells_game = book_.speaks();
  report.follows_game = book_.follows();
  report.refused = refused_;
  if (link_) report.world_states_skipped = link_->skipped();
  for (const HostTime at : sent_at_) {
    if (now - at <= std::chrono::seconds(1)) report.world_state_rate += 1.0;
  }
  return report;
}

}  // namespace teamsight::monitor
