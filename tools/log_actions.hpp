// tools/log_actions.hpp: what `teamsight log` does, one function per subcommand.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "process/domains.hpp"
#include "recording/mcap_reader.hpp"

namespace teamsight::tools {

/// Which part of a recording: seconds since its first message, and topics.
struct LogSelection {
  std::optional<double> from_s;
  std::optional<double> until_s;
  std::vector<std::string> topics;  ///< "RobotState" or "teamsight/v1/RobotState"; none: all
};

/// The selection's span on the recording's own clock.
[[nodiscard]] recording::TimeSpan span_of(const LogSelection& selection,
                                          const recording::Contents& contents);

/// The recording's clock minus that of the computer that recorded, 0 if it does not say; ns.
[[nodiscard]] std::int64_t log_minus_host_of(const recording::Contents& contents);

/// Whether a topic is selected.
[[nodiscard]] bool is_selected(const LogSelection& selection, const std::string& topic);

/// One JSON line per file: span, messages by topic, recorder's facts, damage.
///
/// @return 0; 1 if one of them was cut off
[[nodiscard]] int log_info(const std::vector<std::filesystem::path>& files);

struct LogCut {
  std::filesystem::path in;
  std::filesystem::path out;
  LogSelection selection;
};

/// Copies what is selected into a new, finished file; so it also mends one that was cut off.
[[nodiscard]] int log_cut(const LogCut& request);

struct LogConvert {
  std::filesystem::path in;
  std::filesystem::path out;  ///< of jsonl: a file or empty for stdout; of csv: a folder
  std::string format;         ///< "jsonl" or "csv"
  LogSelection selection;
};

/// By the schemas in the file, so that any protobuf recording can be converted.
[[nodiscard]] int log_convert(const LogConvert& request);

struct LogImport {
  std::filesystem::path worlds;  ///< the referee box's *.A.msl or *.B.msl: one team's world states
  std::filesystem::path events;  ///< its *.msl: the referee's events; may be empty
  std::string own{"cyan"};       ///< colour of that team in the events
  std::filesystem::path out;
};

/// A game as the league's referee box recorded it becomes a recording that the page can replay.
///
/// Positions come into F. The league tells no uncertainty: covariances in the result are assumed.
[[nodiscard]] int log_import(const LogImport& request);

struct LogRecord {
  std::filesystem::path team;
  std::filesystem::path out;
  std::optional<double> seconds;
  std::uint64_t max_megabytes{1024};
  std::string match_tag;
  process::DomainOptions domains;
};

/// Until the time is over or SIGINT; one JSON line at the end.
///
/// @return 0; 1 if nothing was heard or the disk refused
[[nodiscard]] int log_record(const LogRecord& request);

struct LogReplay {
  std::filesystem::path in;
  std::filesystem::path team;
  LogSelection selection;
  double speed{1.0};
  process::DomainOptions domains;
};

/// Puts a recording back on the bus, its stamps moved into the present.
///
/// @return 0; 1 if the selection holds nothing to write
[[nodiscard]] int log_replay(const LogReplay& request);

}  // namespace teamsight::tools
