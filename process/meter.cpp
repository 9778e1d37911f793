// process/meter.cpp: see process/meter.hpp.
#include "process/meter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

#include <unistd.h>

namespace teamsight::process {
namespace {

constexpr std::size_t kMaxCounters = 18;
constexpr std::size_t kMaxCounterName = 39;

Duration read_clock(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Second number of /proc/self/statm, in pages; 0 if it cannot be read.
std::uint32_t resident_kb() {
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  std::array<char, 128> text{};
  const char* line = std::fgets(text.data(), static_cast<int>(text.size()), file);
  std::fclose(file);
  if (line == nullptr) return 0;
  char* rest = nullptr;
  std::strtoul(line, &rest, 10);
  const auto pages = std::strtoul(rest, nullptr, 10);
  return static_cast<std::uint32_t>(pages * static_cast<unsigned long>(sysconf(_SC_PAGESIZE)) /
                                    1024UL);
}

double quantile_ms(std::vector<Duration>& steps, double quantile) {
  if (steps.empty()) return 0.0;
  const auto last = static_cast<double>(steps.size() - 1);
  const auto rank = static_cast<std::size_t>(std::lround(quantile * last));
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(rank), steps.end());
  return 1e3 * to_seconds(steps[rank]);
}

}  // namespace

ProcessMeter::ProcessMeter(std::string process, RobotId robot, std::uint32_t boot)
    : process_(std::move(process)),
      id_{robot, boot, 0} {}

void ProcessMeter::add_step(Duration duration) {
  steps_[step_count_ % steps_.size()] = duration;
  ++step_count_;
}

void ProcessMeter::count(std::string_view name, std::uint64_t by) {
  const auto found = counters_.find(name);
  if (found != counters_.end()) {
    found->second += by;
  } else {
    counters_.emplace(name, by);
  }
}

void ProcessMeter::set(std::string_view name, std::uint64_t value) {
  const auto found = counters_.find(name);
  if (found != counters_.end()) {
    found->second = value;
  } else {
    counters_.emplace(name, value);
  }
}

void ProcessMeter::show(std::string_view name, std::uint64_t value) {
  shown_.insert_or_assign(std::string(name), value);
}

void ProcessMeter::set(std::string_view topic, const bus::ReadCounters& counters) {
  const std::string prefix(topic);
  set(prefix + ".accepted", counters.accepted);
  set(prefix + ".lost", counters.lost);
  for (std::size_t i = 0; i < bus::kRejectReasons; ++i) {
    if (counters.rejected[i] == 0) continue;
    const auto reason = static_cast<bus::Reject>(i);
    set(prefix + ".rejected." + std::string(bus::to_string(reason)), counters.rejected[i]);
  }
}

void ProcessMeter::set(std::string_view topic, const bus::WriteCounters& counters) {
  const std::string prefix(topic);
  set(prefix + ".written", counters.written);
  set(prefix + ".invalid", counters.invalid);
  set(prefix + ".failed", counters.failed);
}

bus::Diagnostics ProcessMeter::report(HostTime now) {
  bus::Diagnostics diagnostics;
  ++id_.sequence;
  diagnostics.process = process_;
  diagnostics.id = id_;
  diagnostics.stamp = stamp_of(now);
  const std::size_t kept = std::min(step_count_, steps_.size());
  std::vector<Duration> steps(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(kept));
  diagnostics.step_ms_p50 = quantile_ms(steps, 0.50);
  diagnostics.step_ms_p95 = quantile_ms(steps, 0.95);
  step_count_ = 0;
  const Duration cpu = read_clock(CLOCK_PROCESS_CPUTIME_ID);
  if (reported_ != HostTime{} && now > reported_) {
    diagnostics.cpu_load = to_seconds(cpu - cpu_at_report_) / to_seconds(now - reported_);
  }
  reported_ = now;
  cpu_at_report_ = cpu;
  diagnostics.resident_kb = resident_kb();
  for (const auto& [name, value] : shown_) {
    diagnostics.counters.push_back({name.substr(0, kMaxCounterName), value});
  }
  const auto shown = static_cast<std::ptrdiff_t>(shown_.size());
  for (const auto& [name, value] : counters_) {
    if (value != 0) diagnostics.counters.push_back({name.substr(0, kMaxCounterName), value});
  }
  std::stable_sort(diagnostics.counters.begin() + shown,
                   diagnostics.counters.end(),
                   [](const auto& a, const auto& b) { return a.value > b.value; });
  if (diagnostics.counters.size() > kMaxCounters) diagnostics.counters.resize(kMaxCounters);
  return diagnostics;
}

StepTimer::StepTimer(ProcessMeter& meter) : meter_(&meter), start_(read_clock(CLOCK_MONOTONIC)) {}

StepTimer::~StepTimer() {
  meter_->add_step(read_clock(CLOCK_MONOTONIC) - start_);
}

}  // namespace teamsight::process
