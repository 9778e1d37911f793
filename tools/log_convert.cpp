// tools/log_convert.cpp: `teamsight log convert`.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>

#include "process/program.hpp"
#include "tools/log_actions.hpp"
#include "tools/recorded_message.hpp"

namespace teamsight::tools {
namespace {

/// Calls `use(message, parsed)` for everything selected that can be read.
template <class Use>
std::uint64_t for_each_parsed(const recording::McapReader& reader,
                              const LogSelection& selection,
                              const Use& use) {
  RecordedMessages messages;
  std::uint64_t count = 0;
  reader.for_each(span_of(selection, reader.contents()), [&](const recording::Message& message) {
    if (!is_selected(selection, message.channel->topic)) return true;
    const auto* parsed = messages.parse(*message.channel, message.payload);
    if (parsed == nullptr) return true;
    use(message, *parsed);
    ++count;
    return true;
  });
  return count;
}

std::ofstream open_file(const std::filesystem::path& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
  return file;
}

std::uint64_t write_lines(const recording::McapReader& reader,
                          const LogSelection& selection,
                          std::ostream& out) {
  return for_each_parsed(
      reader, selection, [&](const recording::Message& message, const auto& parsed) {
        out << R"({"topic":")" << message.channel->topic << R"(","log_ns":)" << message.stamp.log_ns
            << R"(,"publish_ns":)" << message.stamp.publish_ns << R"(,"message":)"
            << json_of(parsed) << "}\n";
      });
}

/// The columns that any message of a topic has, numbered lists in their numeric order.
struct PathOrder {
  bool operator()(const std::string& a, const std::string& b) const {
    return ::strverscmp(a.c_str(), b.c_str()) < 0;
  }
};

using Columns = std::set<std::string, PathOrder>;

std::string file_name_of(std::string topic) {
  const auto slash = topic.rfind('/');
  if (slash != std::string::npos) topic.erase(0, slash + 1);
  std::ranges::replace_if(
      topic, [](char letter) { return letter == '.' || letter == '\0'; }, '_');
  return (topic.empty() ? "topic" : topic) + ".csv";
}

std::uint64_t write_tables(const recording::McapReader& reader, const LogConvert& request) {
  std::map<const recording::Channel*, Columns> columns;
  for_each_parsed(
      reader, request.selection, [&](const recording::Message& message, const auto& parsed) {
        for (const auto& [path, value] : flat(parsed)) columns[message.channel].insert(path);
      });
  std::filesystem::create_directories(request.out);
  std::map<const recording::Channel*, std::ofstream> files;
  for (const auto& [channel, paths] : columns) {
    std::ofstream file = open_file(request.out / file_name_of(channel->topic));
    file << "log_ns,publish_ns";
    for (const std::string& path : paths) file << "," << path;
    file << "\n";
    files.emplace(channel, std::move(file));
  }
  return for_each_parsed(
      reader, request.selection, [&](const recording::Message& message, const auto& parsed) {
        std::ofstream& file = files.at(message.channel);
        const auto fields = flat(parsed);
        file << message.stamp.log_ns << "," << message.stamp.publish_ns;
        for (const std::string& path : columns.at(message.channel)) {
          const auto found = fields.find(path);
          file << "," << (found == fields.end() ? std::string() : found->second);
        }
        file << "\n";
      });
}

}  // namespace

int log_convert(const LogConvert& request) {
  const recording::McapReader reader(request.in);
  std::uint64_t count = 0;
  if (request.format == "csv") {
    if (request.out.empty()) throw std::runtime_error("log convert: csv needs --out FOLDER");
    count = write_tables(reader, request);
  } else if (request.out.empty()) {
    count = write_lines(reader, request.selection, std::cout);
  } else {
    std::ofstream file = open_file(request.out);
    count = write_lines(reader, request.selection, file);
  }
  return count > 0 ? process::kDone : process::kAnswerIsNo;
}

}  // namespace teamsight::tools
