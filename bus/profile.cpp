// bus/profile.cpp: checks what the library would silently take for "all defaults".
#include "bus/profile.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "bus/participant.hpp"
#include "bus/topics.hpp"

namespace teamsight::bus {
namespace {

constexpr std::string_view kRootStart = "<CycloneDDS";
constexpr std::string_view kRootEnd = "</CycloneDDS>";
constexpr std::size_t kMaxTag = 64;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw BusError("DDS profile " + path + ": " + reason);
}

std::string read_file(const std::string& path) {
  if (std::error_code code; std::filesystem::is_directory(path, code)) {
    fail(path, "is a directory, expected a file");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, std::string("cannot be read: ") + std::generic_category().message(errno));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Line breaks stay, so that the library's line numbers are those of the file.
void blank_comments(const std::string& path, std::string& text) {
  for (std::size_t start = text.find("<!--"); start != std::string::npos;
       start = text.find("<!--", start)) {
    const std::size_t end = text.find("-->", start);
    if (end == std::string::npos) fail(path, "a comment has no end");
    std::replace_if(
        text.begin() + static_cast<std::ptrdiff_t>(start),
        text.begin() + static_cast<std::ptrdiff_t>(end + 3),
        [](char c) { return c != '\n'; },
        ' ');
  }
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

void check_root(const std::string& path, std::string_view text) {
  const std::string_view body = trimmed(text);
  if (!body.starts_with(kRootStart) || !body.ends_with(kRootEnd) ||
      body.find(kRootEnd) + kRootEnd.size() != body.size()) {
    fail(path, "expected exactly one <CycloneDDS> ... </CycloneDDS> and nothing else");
  }
}

// A section for another domain does not apply, and what does not apply is a default.
void check_domains(const std::string& path, const std::string& text) {
  constexpr std::string_view kDomain = "<Domain";
  bool found = false;
  for (std::size_t at = text.find(kDomain); at != std::string::npos;
       at = text.find(kDomain, at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) fail(path, "a <Domain> tag has no end");
    const std::size_t attributes = at + kDomain.size();
    if (std::isalnum(static_cast<unsigned char>(text[attributes])) != 0) continue;
    const std::string_view inside =
        trimmed(std::string_view(text).substr(attributes, end - attributes));
    if (!inside.empty() && inside != "Id=\"any\"" && inside != "id=\"any\"") {
      fail(path, "<Domain " + std::string(inside) + ">, expected <Domain Id=\"any\">");
    }
    found = true;
  }
  if (!found) fail(path, "has no <Domain> section");
}

// Our own word in the file, as XML has it for other programs' words; blanked, because the library
// takes none but its own.
Duration take_lease(const std::string& path, std::string& text) {
  constexpr std::string_view kStart = "<?teamsight";
  constexpr std::string_view kLease = " lease_ms=\"";
  constexpr long kShortest = 100;  // three frames at 30 Hz
  constexpr long kLongest = 5000;
  const std::size_t start = text.find(kStart);
  if (start == std::string::npos) return kDefaultLease;
  const std::size_t end = text.find("?>", start);
  if (end == std::string::npos) fail(path, "<?teamsight has no end \"?>\"");
  const std::string inside = text.substr(start + kStart.size(), end - start - kStart.size());
  char* rest = nullptr;
  const bool named = inside.starts_with(kLease);
  const long lease = named ? std::strtol(inside.c_str() + kLease.size(), &rest, 10) : 0;
  if (!named || trimmed(rest) != "\"" || lease < kShortest || lease > kLongest) {
    fail(path,
         "<?teamsight" + inside + "?>, expected <?teamsight lease_ms=\"N\"?> with N from " +
             std::to_string(kShortest) + " to " + std::to_string(kLongest));
  }
  text.replace(start, end + 2 - start, end + 2 - start, ' ');
  return std::chrono::milliseconds(lease);
}

// The card of its first interface; "" if it names none.
std::string card_in(const std::string& text) {
  constexpr std::string_view kInterface = "<NetworkInterface";
  constexpr std::string_view kName = "name=\"";
  const std::size_t start = text.find(kInterface);
  if (start == std::string::npos) return {};
  const std::string inside = text.substr(start, text.find('>', start) - start);
  const std::size_t name = inside.find(kName);
  if (name == std::string::npos) return {};
  const std::size_t begin = name + kName.size();
  return inside.substr(begin, inside.find('"', begin) - begin);
}

void check_tag(const std::string& path, std::string_view tag) {
  const auto allowed = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  };
  if (tag.size() > kMaxTag || !std::all_of(tag.begin(), tag.end(), allowed)) {
    fail(path,
         "tag '" + std::string(tag) + "', expected at most 64 letters, digits, '_', '-' or '.'");
  }
}

}  // namespace

Profile load_profile(const std::string& path, std::string_view tag) {
  check_tag(path, tag);
  Profile profile;
  std::string& text = profile.text;
  text = read_file(path);
  blank_comments(path, text);
  profile.lease = take_lease(path, text);
  check_root(path, text);
  check_domains(path, text);
  profile.card = card_in(text);
  if (!tag.empty()) {
    text += "<CycloneDDS><Domain Id=\"any\"><Discovery><Tag>";
    text += tag;
    text += "</Tag></Discovery></Domain></CycloneDDS>";
  }
  return profile;
}

}  // namespace teamsight::bus
