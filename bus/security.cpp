// bus/security.cpp: see security.hpp.
#include "bus/security.hpp"

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include "bus/participant.hpp"

namespace teamsight::bus {
namespace {

constexpr std::string_view kCoach = "coach";
constexpr std::string_view kRobot = "robot";

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw BusError("security " + path + ": " + reason);
}

std::string readable(const std::string& folder, const char* name) {
  std::string path = folder + "/" + name;
  if (::access(path.c_str(), R_OK) != 0) {
    const bool is_there = errno != ENOENT;
    fail(path,
         std::generic_category().message(errno) + ", expected a folder made by `teamsight keys`" +
             (is_there ? " that this user may read: chown -R USER " + folder
                       : "; make one for this robot with --robots, or copy it from where it is"));
  }
  return path;
}

// A key that others can read is as good as given away.
std::string private_key(const std::string& folder) {
  std::string path = readable(folder, "identity.key");

  struct stat info {};

  if (::stat(path.c_str(), &info) != 0 || (info.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    fail(path, "others may read it, expected a key of this user alone: chmod 600 " + path);
  }
  return path;
}

std::string element(const std::string& name, const std::string& path) {
  return "<" + name + ">file:" + path + "</" + name + ">";
}

std::string plugin(const std::string& what, const std::string& library) {
  return "<Library path=\"dds_security_" + library + "\" initFunction=\"init_" + what +
         "\" finalizeFunction=\"finalize_" + what + "\"/>";
}

}  // namespace

Identity load_identity(const std::string& folder) {
  const std::string home = std::filesystem::absolute(folder).lexically_normal().string();
  Identity identity;
  identity.partition = std::filesystem::path(home).filename().string();
  if (!speaker_of(identity.partition)) fail(home, "expected a folder called robot<id> or coach");
  identity.configuration = "<CycloneDDS><Domain Id=\"any\"><Security><Authentication>" +
                           plugin("authentication", "auth") +
                           element("IdentityCertificate", readable(home, "identity.pem")) +
                           element("IdentityCA", readable(home, "identity_ca.pem")) +
                           element("PrivateKey", private_key(home)) +
                           "</Authentication><AccessControl>" + plugin("access_control", "ac") +
                           element("PermissionsCA", readable(home, "permissions_ca.pem")) +
                           element("Governance", readable(home, "governance.p7s")) +
                           element("Permissions", readable(home, "permissions.p7s")) +
                           "</AccessControl><Cryptographic>" + plugin("crypto", "crypto") +
                           "</Cryptographic></Security></Domain></CycloneDDS>";
  return identity;
}

std::optional<RobotId> speaker_of(std::string_view partition) noexcept {
  if (partition == kCoach) return kNobody;
  if (!partition.starts_with(kRobot)) return std::nullopt;
  const std::string_view digits = partition.substr(kRobot.size());
  unsigned id = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), id);
  const bool is_whole = error == std::errc{} && end == digits.data() + digits.size();
  if (!is_whole || id == 0 || id > kMaxRobotId) return std::nullopt;
  return static_cast<RobotId>(id);
}

}  // namespace teamsight::bus
