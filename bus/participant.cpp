// bus/participant.cpp: one domain per id and process, made from its profile; participants in it.
#include "bus/participant.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "bus/entity.hpp"
#include "bus/join_failure.hpp"
#include "bus/library_log.hpp"
#include "bus/participant_impl.hpp"
#include "bus/profile.hpp"
#include "bus/security.hpp"

namespace teamsight::bus {

std::int32_t check(std::int32_t code, const char* call) {
  if (code >= 0) return code;
  throw BusError(std::string(call) + ": " + dds_strretcode(code));
}

/// A DDS domain of this process; alive while a participant is in it.
struct Domain {
  Entity entity;
  std::string configuration;
};

namespace {

// The library has one domain per id and process; two participants with the same settings share it.
struct Registry {
  std::mutex mutex;
  std::map<std::uint32_t, std::weak_ptr<Domain>> domains;
};

Registry& registry() {
  static Registry* const instance = new Registry;  // outlives static participants
  return *instance;
}

std::shared_ptr<Domain> shared_domain(const DomainSettings& settings,
                                      const std::string& configuration) {
  std::shared_ptr<Domain> domain = registry().domains[settings.domain_id].lock();
  if (domain && domain->configuration != configuration) {
    throw BusError("DDS profile " + settings.profile_path + ": this process is in domain " +
                   std::to_string(settings.domain_id) + " already, with another profile or tag");
  }
  return domain;
}

using MaybeFailure = std::optional<JoinFailure>;

MaybeFailure try_join(Participant::Impl& out) {
  const DomainSettings& settings = out.settings;
  const std::string& configuration = out.configuration;
  if (MaybeFailure missing = missing_card(settings, configuration)) return missing;
  const std::lock_guard lock(registry().mutex);
  const LibraryLogCapture capture;
  std::shared_ptr<Domain> domain = shared_domain(settings, configuration);
  if (!domain) {
    // Checked: after a failure here dds_create_participant would succeed, with the defaults.
    const dds_entity_t handle = dds_create_domain(settings.domain_id, configuration.c_str());
    if (handle < 0) return failure_of(settings, "dds_create_domain", handle);
    domain = std::make_shared<Domain>(Domain{Entity(handle), configuration});
  }
  const dds_entity_t handle = dds_create_participant(settings.domain_id, nullptr, nullptr);
  if (handle < 0) return failure_of(settings, "dds_create_participant", handle);
  out.domain = domain;
  out.entity = Entity(handle);
  registry().domains[settings.domain_id] = domain;
  return std::nullopt;
}

// One second in short steps, so that a stop is heard at once. Not on the wall clock.
bool wait_while(const std::function<bool()>& keep_trying) {
  constexpr int kSteps = 20;
  constexpr timespec kStep{0, 50'000'000};
  for (int i = 0; i < kSteps && keep_trying(); ++i) {
    clock_nanosleep(CLOCK_MONOTONIC, 0, &kStep, nullptr);
  }
  return keep_trying();
}

}  // namespace

Participant::Impl::~Impl() {
  leave();
}

void Participant::Impl::leave() noexcept {
  // Under the lock: another thread that joins must find the domain either whole or gone.
  const std::lock_guard lock(registry().mutex);
  entity = Entity();
  domain.reset();
}

Membership::Membership(std::shared_ptr<Participant::Impl> participant, Endpoint& endpoint)
    : participant_(std::move(participant)),
      endpoint_(&endpoint) {
  participant_->endpoints.push_back(&endpoint);
}

Membership::~Membership() {
  std::erase(participant_->endpoints, endpoint_);
}

Participant Participant::join(const DomainSettings& settings,
                              const std::function<bool()>& keep_trying) {
  Profile profile = load_profile(settings.profile_path, settings.tag);
  auto impl = std::make_shared<Impl>();
  impl->lease = profile.lease;
  if (!settings.identity.empty()) {
    Identity identity = load_identity(settings.identity);
    profile.text += identity.configuration;
    impl->partition = std::move(identity.partition);
  }
  impl->settings = settings;
  impl->configuration = std::move(profile.text);
  bool has_said = false;
  while (const MaybeFailure failed = try_join(*impl)) {
    if (!failed->may_pass || !keep_trying()) throw BusError(failed->line);
    if (!has_said) std::fprintf(stderr, "%s; trying again every second\n", failed->line.c_str());
    has_said = true;
    if (!wait_while(keep_trying)) throw BusError(failed->line);
  }
  return Participant(std::move(impl));
}

bool Participant::rejoin() noexcept {
  const auto leave_all = [this] {
    for (Endpoint* endpoint : impl_->endpoints) endpoint->leave();
    impl_->leave();
  };
  leave_all();
  try {
    if (try_join(*impl_)) return false;
    for (Endpoint* endpoint : impl_->endpoints) endpoint->enter();
  } catch (const BusError&) {  // half in is worse than out: some would be heard and not hear
    leave_all();
    return false;
  }
  return true;
}

Participant::Participant(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

Participant::Participant(Participant&&) noexcept = default;
Participant& Participant::operator=(Participant&&) noexcept = default;
Participant::~Participant() = default;

std::int32_t Participant::handle() const noexcept {
  return impl_->entity.handle();
}

std::uint32_t Participant::domain_id() const noexcept {
  return impl_->settings.domain_id;
}

bool Participant::is_secured() const noexcept {
  return !impl_->partition.empty();
}

Duration Participant::lease() const noexcept {
  return impl_->lease;
}

const std::string& Participant::partition() const noexcept {
  return impl_->partition;
}

}  // namespace teamsight::bus
