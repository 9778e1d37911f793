// bench/latency.cpp: round trips between two processes: bare UDP, bare Cyclone DDS and bus/, side
// by side.
//
// The ways take turns in rounds, so that a disturbance of the machine meets all of them. Every
// round starts fresh processes.
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bench/child_process.hpp"
#include "bench/ping.hpp"
#include "bench/quantiles.hpp"
#include "process/program.hpp"

namespace teamsight::bench {
namespace {

struct Options {
  PingPlan plan;
  std::int64_t pause_us{0};
  std::size_t rounds{10};
  bool apart{false};   // the two processes on a processor each
  int cpu{-1};         // of a measuring process; -1: wherever the system puts it
  std::string role;    // empty: the process that compares
  std::string method;  // of a measuring process
};

const PingMethod& method_named(const std::string& name) {
  const auto* const found =
      std::find_if(kPingMethods.begin(), kPingMethods.end(), [&](const PingMethod& method) {
        return method.name == name;
      });
  if (found == kPingMethods.end()) {
    throw std::runtime_error("--method is '" + name + "'; expected udp, cyclone_... or bus");
  }
  return *found;
}

// A port that was free a moment ago.
std::uint16_t free_udp_port() {
  const int descriptor = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof(address);
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const bool ok =
      ::bind(descriptor, any, length) == 0 && ::getsockname(descriptor, any, &length) == 0;
  ::close(descriptor);
  if (!ok) {
    throw std::runtime_error("no UDP port is free");
  }
  return ntohs(address.sin_port);
}

// Keeps this process, with all its threads to come, on one processor.
void stay_on(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(cpu), &set);
  if (::sched_setaffinity(0, sizeof(set), &set) != 0) {
    throw std::runtime_error("cannot stay on processor " + std::to_string(cpu));
  }
}

std::vector<std::string> arguments_of(const Options& options,
                                      const std::string& role,
                                      const PingMethod& method) {
  const int cpu = !options.apart ? -1 : role == "echo" ? 0 : 1;
  return {"--role",
          role,
          "--method",
          std::string(method.name),
          "--domain",
          std::to_string(options.plan.domain_id),
          "--profile",
          options.plan.profile_path,
          "--udp-port",
          std::to_string(options.plan.udp_port),
          "--count",
          std::to_string(options.plan.count),
          "--pause-us",
          std::to_string(options.pause_us),
          "--cpu",
          std::to_string(cpu)};
}

// A measuring process prints the number of lost pings and then each round trip in nanoseconds.
void print(const PingResult& result) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{}\n", result.lost);
  for (const Duration trip : result.round_trips) {
    fmt::format_to(std::back_inserter(text), "{}\n", trip.count());
  }
  fmt::print("{}", std::string_view(text.data(), text.size()));
}

void add_printed(const std::string& text, PingResult& result) {
  std::istringstream lines(text);
  std::size_t lost = 0;
  lines >> lost;
  result.lost += lost;
  for (Duration::rep nanoseconds = 0; lines >> nanoseconds;) {
    result.round_trips.emplace_back(nanoseconds);
  }
}

void run_round(const Options& options, std::map<std::string_view, PingResult>& results) {
  for (const PingMethod& method : kPingMethods) {
    Options round = options;
    round.plan.udp_port = free_udp_port();
    const ChildProcess echo(arguments_of(round, "echo", method));
    ChildProcess ping(arguments_of(round, "ping", method));
    add_printed(ping.output(), results[method.name]);
  }
}

// One method's figures beside those of the bare Cyclone ping with a waitset.
void report_method(const Options& options,
                   std::string_view method,
                   const PingResult& result,
                   const Quantiles& bare) {
  const Quantiles quantiles = quantiles_of(result.round_trips);
  const double median_ratio = quantiles.median_us / bare.median_us;
  const double p99_ratio = quantiles.p99_us / bare.p99_us;
  fmt::print(
      R"({{"bench":"latency","method":"{}","bytes":{},"pause_us":{},"apart":{},{},"lost":{},)"
      R"("median_over_cyclone_waitset":{:.3f},"p99_over_cyclone_waitset":{:.3f}}})"
      "\n",
      method,
      kPingBytes,
      options.pause_us,
      options.apart,
      json_members(quantiles),
      result.lost,
      median_ratio,
      p99_ratio);
  fmt::print(stderr,
             "{:<18} {} {:>6} {:>8.2f} {:>8.2f}\n",
             method,
             table_columns(quantiles),
             result.lost,
             median_ratio,
             p99_ratio);
}

void report(const Options& options, std::map<std::string_view, PingResult>& results) {
  const Quantiles bare = quantiles_of(results["cyclone_waitset"].round_trips);
  fmt::print(stderr,
             "round trip between two processes, {} bytes, {} us pause, {}\n",
             kPingBytes,
             options.pause_us,
             options.apart ? "on a processor each" : "placed by the system");
  fmt::print(
      stderr, "{:<18} {} {:>6} {:>8} {:>8}\n", "", table_head(), "lost", "median x", "p99 x");
  for (const PingMethod& method : kPingMethods) {
    report_method(options, method.name, results[method.name], bare);
  }
}

void compare(const Options& options) {
  std::map<std::string_view, PingResult> results;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    run_round(options, results);
  }
  report(options, results);
}

std::optional<int> parse(int argc, char** argv, Options& options) {
  CLI::App app{
      "Round trips between two processes: bare UDP, bare Cyclone DDS and bus/, side by side.",
      "bench-latency"};
  app.add_option("--profile", options.plan.profile_path, "Cyclone DDS XML file")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--domain", options.plan.domain_id, "DDS domain id, of nobody else")
      ->capture_default_str();
  app.add_option("--count", options.plan.count, "round trips of each way in one round")
      ->capture_default_str();
  app.add_option("--rounds", options.rounds, "how often each way takes its turn")
      ->capture_default_str();
  app.add_option("--pause-us", options.pause_us, "between two round trips; microseconds")
      ->capture_default_str();
  app.add_flag("--apart", options.apart, "the two processes stay on processor 0 and 1");
  app.add_option("--cpu", options.cpu)->group("");
  app.add_option("--role", options.role)->group("");
  app.add_option("--method", options.method)->group("");
  app.add_option("--udp-port", options.plan.udp_port)->group("");
  const std::optional<int> done = process::parse_command_line(app, argc, argv);
  options.plan.pause = std::chrono::microseconds(options.pause_us);
  return done;
}

int run(int argc, char** argv) {
  Options options;
  options.plan.domain_id = 229;
  options.plan.count = 1000;
  if (const std::optional<int> done = parse(argc, argv, options)) {
    return *done;
  }
  if (options.cpu >= 0) {
    stay_on(options.cpu);
  }
  if (options.role == "echo") {
    method_named(options.method).echo(options.plan);
  } else if (options.role == "ping") {
    print(method_named(options.method).ping(options.plan));
  } else {
    compare(options);
  }
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::bench

int main(int argc, char** argv) {
  return teamsight::process::run_program("bench-latency",
                                         [&] { return teamsight::bench::run(argc, argv); });
}
