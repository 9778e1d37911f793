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

#include <net/if.h>

#include "bus/entity.hpp"
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

struct JoinFailure {
  std::string reason;
  bool may_pass{false};  // an interface is only down
};

// The library ends its message about an unknown interface like this, its name before it.
constexpr std::string_view kNoSuchInterface = ": does not match an available interface";

bool names_an_existing_interface(const std::string& reason) {
  const std::size_t end = reason.find(kNoSuchInterface);
  if (end == std::string::npos) return false;
  const std::size_t before = reason.find_last_of(" ;\n", end == 0 ? 0 : end - 1);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return if_nametoindex(reason.substr(start, end - start).c_str()) != 0;
}

std::string interface_list() {
  std::string all;
  struct if_nameindex* const cards = ::if_nameindex();
  for (const auto* card = cards; card != nullptr && card->if_index != 0; ++card) {
    all += (all.empty() ? "" : ", ") + std::string(card->if_name);
  }
  if (cards != nullptr) ::if_freenameindex(cards);
  return all.empty() ? "none" : all;
}

// What an operator can do about what the library says; empty: nothing that is known.
std::string advice_on(const std::string& reason) {
  if (reason.find("failed to find interfaces") != std::string::npos) {
    return "; no network card is up, this computer has: " + interface_list();
  }
  if (reason.find(kNoSuchInterface) != std::string::npos) {
    return " This computer has: " + interface_list() + "; name one of them in NetworkInterface";
  }
  if (reason.find("has expired") != std::string::npos) {
    return "; make new ones: teamsight keys --renew";
  }
  return {};
}

JoinFailure failure_of(const char* call, dds_return_t code) {
  std::string reason = LibraryLogCapture::text();
  const bool none_up = reason.find("failed to find interfaces") != std::string::npos;
  const bool may_pass = none_up || names_an_existing_interface(reason);
  if (reason.empty()) reason = std::string(call) + ": " + dds_strretcode(code);
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  // How the library calls a text that it was given: nobody set that variable.
  constexpr std::string_view kGivenText = "CYCLONEDDS_URI+0 ";
  if (const std::size_t at = reason.find(kGivenText); at != std::string::npos) {
    reason.erase(at, kGivenText.size());
  }
  return {reason + advice_on(reason), may_pass};
}

// The line that says why: which file, what was found, what to do.
std::string line_of(const DomainSettings& settings, const JoinFailure& failure) {
  const bool is_keys = failure.reason.find("ertificate") != std::string::npos;
  return (is_keys ? "security " + settings.identity : "DDS profile " + settings.profile_path) +
         ": " + failure.reason;
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
  const std::lock_guard lock(registry().mutex);
  const LibraryLogCapture capture;
  std::shared_ptr<Domain> domain = shared_domain(settings, configuration);
  if (!domain) {
    // Checked: after a failure here dds_create_participant would succeed, with the defaults.
    const dds_entity_t handle = dds_create_domain(settings.domain_id, configuration.c_str());
    if (handle < 0) return failure_of("dds_create_domain", handle);
    domain = std::make_shared<Domain>(Domain{Entity(handle), configuration});
  }
  const dds_entity_t handle = dds_create_participant(settings.domain_id, nullptr, nullptr);
  if (handle < 0) return failure_of("dds_create_participant", handle);
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
    const std::string line = line_of(settings, *failed);
    if (!failed->may_pass || !keep_trying()) throw BusError(line);
    if (!has_said) std::fprintf(stderr, "%s; trying again every second\n", line.c_str());
    has_said = true;
    if (!wait_while(keep_trying)) throw BusError(line);
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
