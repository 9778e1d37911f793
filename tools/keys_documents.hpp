// tools/keys_documents.hpp: what DDS Security wants to be told of a team, as XML. No files here.
#pragma once

#include <string>

#include "geometry/identity.hpp"

namespace teamsight::tools {

/// Whose identity: a robot, or the coach station with its tools.
struct Speaker {
  RobotId robot{kNobody};  ///< kNobody = the coach station
};

/// "robot3" or "coach": name of the folder, the partition and the certificate's subject.
[[nodiscard]] std::string name_of(Speaker speaker);

/// Who may be in the team's domain at all: only who has an identity; every packet is signed.
[[nodiscard]] std::string governance_document();

/// What one speaker may say: its own topics, in its own partition; it may hear everything.
///
/// @param subject     of its certificate, as RFC 2253 writes it
/// @param not_before  like 2026-01-31T00:00:00, UTC
[[nodiscard]] std::string permissions_document(Speaker speaker,
                                               const std::string& subject,
                                               const std::string& not_before,
                                               const std::string& not_after);

}  // namespace teamsight::tools
