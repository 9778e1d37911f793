// tools/log_cut.cpp: `teamsight log cut`.
#include <cstdio>
#include <map>

#include "process/program.hpp"
#include "recording/output_file.hpp"
#include "tools/log_actions.hpp"

namespace teamsight::tools {

int log_cut(const LogCut& request) {
  const recording::McapReader reader(request.in);
  recording::OutputFile file(request.out);
  recording::McapWriter writer([&](std::string_view bytes) { return file.write(bytes); },
                               reader.contents().library);
  for (const auto& [name, values] : reader.contents().metadata) writer.add_metadata(name, values);
  std::map<const recording::Channel*, std::uint16_t> channels;
  const auto copy = [&](const recording::Message& message) {
    if (!is_selected(request.selection, message.channel->topic)) return true;
    const auto known = channels.find(message.channel);
    const std::uint16_t id =
        known != channels.end() ? known->second : writer.add_channel(*message.channel);
    channels[message.channel] = id;
    writer.write(id, message.stamp, message.payload);
    return writer.is_good();
  };
  reader.for_each(span_of(request.selection, reader.contents()), copy);
  writer.finish();
  if (!file.problem().empty()) throw recording::RecordingError(file.problem());
  std::printf("{\"file\": \"%s\", \"messages\": %llu}\n",
              request.out.c_str(),
              static_cast<unsigned long long>(writer.messages()));
  return writer.messages() > 0 ? process::kDone : process::kAnswerIsNo;
}

}  // namespace teamsight::tools
