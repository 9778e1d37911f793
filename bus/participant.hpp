// bus/participant.hpp: joining a DDS domain from a checked configuration.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "geometry/time.hpp"

namespace teamsight::bus {

/// The process cannot join: one line that names the file, what was found and what was expected.
class BusError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which domain to join, and how.
struct DomainSettings {
  std::uint32_t domain_id{0};
  std::string profile_path;  ///< a Cyclone DDS XML file (config/dds)
  std::string tag;           ///< participants with different tags never meet; empty = none
  /// Folder of this speaker's keys (`teamsight keys`); empty: anybody on the network can speak.
  std::string identity{};
};

/// One DDS participant. All readers and writers of a process are made at start, before any
/// traffic; each keeps its participant alive, so that they are destroyed in order. Move-only. Use
/// from one thread.
///
/// A process may join several domains, and the same domain several times with equal settings. A
/// reader never hears the writers of its own participant: a fusion would take its own world for
/// another's. A test that needs both ends in one process joins twice.
class Participant {
 public:
  /// Reads the profile, makes the domain from it and joins; while no network interface is up, or
  /// the one it names exists but is down, it tries again every second for as long as
  /// `keep_trying()` is true.
  ///
  /// The profile replaces the environment: CYCLONEDDS_URI is not consulted, and a profile that
  /// does not parse never falls back to defaults.
  ///
  /// @throws BusError if the file cannot be read, does not parse, or names a missing interface
  ///         (the library's own reason is in the message), if this process is in the domain with
  ///         other settings, or when keep_trying() turned false
  [[nodiscard]] static Participant join(
      const DomainSettings& settings,
      const std::function<bool()>& keep_trying = [] { return false; });

  Participant(Participant&&) noexcept;
  Participant& operator=(Participant&&) noexcept;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  ~Participant();

  /// Leaves and joins again under a new name: to every peer this process is a new one, and every
  /// peer is new to it, whatever either believed of the other's sequence numbers. Readers and
  /// writers stay usable; what they have counted stays. For that this must be the only participant
  /// of the process in its domain. Takes some 10 ms.
  ///
  /// @return whether it is joined; if not, nothing is written or heard until a later call succeeds
  bool rejoin() noexcept;

  [[nodiscard]] std::uint32_t domain_id() const noexcept;

  /// Whether DDS Security is on.
  [[nodiscard]] bool is_secured() const noexcept;

  /// Silence of a leased topic's writer for so long counts as gone on this network.
  [[nodiscard]] Duration lease() const noexcept;

  /// Cyclone's handle, for bus/ only.
  [[nodiscard]] std::int32_t handle() const noexcept;

  /// In which this speaker writes; empty: security is off. For bus/ only.
  [[nodiscard]] const std::string& partition() const noexcept;

  struct Impl;

  /// Holds the participant while readers and writers live, for bus/ only.
  [[nodiscard]] const std::shared_ptr<Impl>& shared() const noexcept { return impl_; }

 private:
  explicit Participant(std::shared_ptr<Impl> impl);
  std::shared_ptr<Impl> impl_;
};

}  // namespace teamsight::bus
