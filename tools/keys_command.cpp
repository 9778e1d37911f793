// tools/keys_command.cpp: see keys_command.hpp. The cryptography is openssl's, the program.
#include "tools/keys_command.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "process/program.hpp"
#include "settings/load.hpp"
#include "tools/keys_documents.hpp"

namespace teamsight::tools {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path out;
  fs::path team;
  std::vector<int> robots;
  int days{400};
  bool renew{false};
};

// Curve P-256: the library knows this and RSA, and its handshake is the faster one.
constexpr const char* kCurve = "ec_paramgen_curve:P-256";

/// A file without a name for what openssl says, which matters only if it fails.
using Chatter = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Chatter make_chatter() {
  Chatter chatter(std::tmpfile(), &std::fclose);
  if (!chatter) throw std::runtime_error("keys: cannot make a temporary file in TMPDIR or /tmp");
  return chatter;
}

std::string last_line(std::FILE* file) {
  std::rewind(file);
  std::array<char, 512> buffer{};
  std::string line;
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), file) != nullptr) {
    line = buffer.data();
  }
  line.erase(line.find_last_not_of("\r\n") + 1);
  return line;
}

/// Starts a program of the path whose standard error goes to `chatter`.
///
/// @return its exit code; 128 and more if a signal ended it
int run_program(std::vector<std::string>& words, std::FILE* chatter) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(chatter), STDERR_FILENO);
  pid_t child = 0;
  const int failure = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) {
    throw std::runtime_error("keys: cannot start openssl; expected the package openssl installed");
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void run(std::vector<std::string> words) {
  words.insert(words.begin(), "openssl");
  const Chatter chatter = make_chatter();
  if (run_program(words, chatter.get()) == 0) return;
  throw std::runtime_error("keys: openssl " + words[1] + " failed: " + last_line(chatter.get()));
}

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("keys: cannot write " + path.string());
}

void make_key(const fs::path& path) {
  run({"genpkey", "-quiet", "-algorithm", "EC", "-pkeyopt", kCurve, "-out", path.string()});
}

std::string subject(const std::string& team, const std::string& name) {
  return "/O=" + team + "/CN=" + name;
}

// One of the two: an identity authority that also signed permissions would let every robot sign its
// own in this version of the library (CVE-2023-24011).
void make_authority(const fs::path& folder,
                    const std::string& name,
                    const std::string& team,
                    int days) {
  const fs::path key = folder / (name + ".key");
  const fs::path certificate = folder / (name + ".pem");
  if (fs::exists(key) && fs::exists(certificate)) return;
  make_key(key);
  run({"req",
       "-x509",
       "-new",
       "-key",
       key.string(),
       "-days",
       std::to_string(days),
       "-subj",
       subject(team, name),
       "-out",
       certificate.string()});
}

void sign(const fs::path& document, const fs::path& authority, const fs::path& out) {
  run({"smime",
       "-sign",
       "-in",
       document.string(),
       "-text",
       "-out",
       out.string(),
       "-signer",
       (authority / "permissions_ca.pem").string(),
       "-inkey",
       (authority / "permissions_ca.key").string()});
}

std::string utc(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
  return text;
}

void certify(const fs::path& folder,
             const fs::path& authority,
             const std::string& subject_name,
             int days) {
  const fs::path request = folder / "request.pem";
  run({"req",
       "-new",
       "-key",
       (folder / "identity.key").string(),
       "-subj",
       subject_name,
       "-out",
       request.string()});
  run({"x509",
       "-req",
       "-in",
       request.string(),
       "-CA",
       (authority / "identity_ca.pem").string(),
       "-CAkey",
       (authority / "identity_ca.key").string(),
       "-CAcreateserial",
       "-days",
       std::to_string(days),
       "-out",
       (folder / "identity.pem").string()});
  fs::remove(request);
}

void make_identity(const Options& options, const std::string& team, Speaker speaker) {
  const fs::path authority = options.out / "authority";
  const fs::path folder = options.out / name_of(speaker);
  if (fs::exists(folder / "permissions.p7s") && !options.renew) return;
  fs::create_directories(folder);
  make_key(folder / "identity.key");
  certify(folder, authority, subject(team, name_of(speaker)), options.days);
  const auto now = std::chrono::system_clock::now();
  const std::string text = permissions_document(speaker,
                                                "CN=" + name_of(speaker) + ",O=" + team,
                                                utc(now - std::chrono::hours(24)),
                                                utc(now + std::chrono::hours(24 * options.days)));
  write_file(folder / "permissions.xml", text);
  sign(folder / "permissions.xml", authority, folder / "permissions.p7s");
  write_file(folder / "governance.xml", governance_document());
  sign(folder / "governance.xml", authority, folder / "governance.p7s");
  for (const char* shared : {"identity_ca.pem", "permissions_ca.pem"}) {
    fs::copy_file(authority / shared, folder / shared, fs::copy_options::overwrite_existing);
  }
  fmt::print("{}\n", nlohmann::json{{"identity", folder.string()}}.dump());
}

int make_keys(const Options& options) {
  const std::string team = settings::load_team(options.team).name;
  ::umask(0077);  // keys are nobody else's to read
  const fs::path authority = options.out / "authority";
  fs::create_directories(authority);
  make_authority(authority, "identity_ca", team, options.days);
  make_authority(authority, "permissions_ca", team, options.days);
  make_identity(options, team, {});
  for (const int robot : options.robots) {
    make_identity(options, team, {static_cast<RobotId>(robot)});
  }
  return process::kDone;
}

}  // namespace

void add_keys_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "keys", "The team's authorities, and one identity per robot and for the coach station");
  command->add_option("--out", options->out, "folder; what is there stays as it is")->required();
  command->add_option("--team", options->team, "team file (config/teams)")->required();
  command->add_option("--robots", options->robots, "their ids, e.g. 1,2,3")
      ->required()
      ->delimiter(',')
      ->check(CLI::Range(1, static_cast<int>(kMaxRobotId)));
  command->add_option("--days", options->days, "how long they are good for")
      ->capture_default_str()
      ->check(CLI::Range(1, 3650));
  command->add_flag("--renew", options->renew, "new identities, from the same authorities");
  command->callback([options, &exit_code]() { exit_code = make_keys(*options); });
}

}  // namespace teamsight::tools
