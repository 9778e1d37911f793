// tools/log_info.cpp: `teamsight log info`, and which part of a recording is meant.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "geometry/time.hpp"
#include "process/program.hpp"
#include "tools/log_actions.hpp"

namespace teamsight::tools {
namespace {

nlohmann::ordered_json describe(const std::filesystem::path& file,
                                const recording::Contents& contents) {
  nlohmann::ordered_json line;
  line["file"] = file.string();
  line["bytes"] = contents.file_bytes;
  line["library"] = contents.library;
  line["messages"] = contents.messages;
  line["start_ns"] = contents.span.from_ns;
  line["duration_s"] = to_seconds(Duration{contents.span.until_ns - contents.span.from_ns});
  nlohmann::ordered_json topics = nlohmann::ordered_json::object();
  for (const auto& [id, channel] : contents.channels) {
    const auto count = contents.message_counts.find(id);
    if (count == contents.message_counts.end()) continue;
    topics[channel.topic] = {{"schema", channel.schema.name}, {"messages", count->second}};
  }
  line["topics"] = topics;
  line["metadata"] = contents.metadata;
  line["damage"] = nullptr;
  if (!contents.damage.empty()) line["damage"] = contents.damage;
  return line;
}

}  // namespace

std::int64_t log_minus_host_of(const recording::Contents& contents) {
  const auto facts = contents.metadata.find("teamsight.recording");
  if (facts == contents.metadata.end()) return 0;
  const auto offset = facts->second.find("log_minus_host_ns");
  if (offset == facts->second.end()) return 0;
  return std::strtoll(offset->second.c_str(), nullptr, 10);
}

recording::TimeSpan span_of(const LogSelection& selection, const recording::Contents& contents) {
  recording::TimeSpan span;
  const std::int64_t start_ns = contents.span.from_ns;
  if (selection.from_s) span.from_ns = start_ns + from_seconds(*selection.from_s).count();
  if (selection.until_s) span.until_ns = start_ns + from_seconds(*selection.until_s).count();
  return span;
}

bool is_selected(const LogSelection& selection, const std::string& topic) {
  return selection.topics.empty() ||
         std::ranges::any_of(selection.topics, [&](const std::string& wanted) {
           return topic == wanted || topic.ends_with("/" + wanted);
         });
}

int log_info(const std::vector<std::filesystem::path>& files) {
  bool is_whole = true;
  for (const std::filesystem::path& file : files) {
    const recording::McapReader reader(file);
    const auto line = describe(file, reader.contents());
    std::puts(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    if (reader.contents().damage.empty()) continue;
    is_whole = false;
    std::fprintf(stderr,
                 "teamsight log: %s: %s; what stands before is there, `teamsight log cut` makes a "
                 "whole file of it\n",
                 file.c_str(),
                 reader.contents().damage.c_str());
  }
  return is_whole ? process::kDone : process::kAnswerIsNo;
}

}  // namespace teamsight::tools
