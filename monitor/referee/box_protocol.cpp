// monitor/referee/box_protocol.cpp: see monitor/referee/box_protocol.hpp.
#include "monitor/referee/box_protocol.hpp"

#include <nlohmann/json.hpp>

namespace teamsight::monitor {
namespace {

constexpr std::size_t kLongestWord = 64;

std::string without_blanks(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

void NulFramer::take(std::string_view bytes, const std::function<void(std::string_view)>& use) {
  while (!bytes.empty()) {
    const auto end = bytes.find('\0');
    const std::string_view part = bytes.substr(0, end);
    is_overlong_ = is_overlong_ || open_.size() + part.size() > kLongestMessage;
    if (!is_overlong_) open_ += part;
    if (end == std::string_view::npos) return;
    if (is_overlong_) {
      ++overlong_;
    } else if (!open_.empty()) {
      use(open_);
    }
    reset();
    bytes.remove_prefix(end + 1);
  }
}

void NulFramer::reset() {
  open_.clear();
  is_overlong_ = false;
}

Result<BoxCommand, std::string> parse_box_command(std::string_view json) {
  const auto value = nlohmann::json::parse(json, nullptr, false);
  if (value.is_discarded()) return tl::unexpected(std::string("no JSON"));
  if (!value.is_object()) return tl::unexpected(std::string("no JSON object"));
  const auto name = value.find("command");
  if (name == value.end() || !name->is_string()) {
    return tl::unexpected(std::string("no text \"command\""));
  }
  BoxCommand command;
  command.name = without_blanks(name->get<std::string>());
  const auto target = value.find("targetTeam");
  if (target != value.end() && !target->is_string()) {
    return tl::unexpected(std::string("\"targetTeam\" is no text"));
  }
  if (target != value.end()) command.target = without_blanks(target->get<std::string>());
  if (command.name.empty() || command.name.size() > kLongestWord ||
      command.target.size() > kLongestWord) {
    return tl::unexpected(std::string("a text of a length no command has"));
  }
  const auto robot = value.find("robotID");
  if (robot != value.end() && robot->is_number_integer()) {
    const auto id = robot->get<std::int64_t>();
    if (id >= 0 && id <= 99) command.robot = static_cast<int>(id);  // -1 means "none"
  }
  return command;
}

}  // namespace teamsight::monitor
