// tools/many_threads.hpp: independent pieces of long work on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace teamsight::tools {

/// Does `work(0)` to `work(count - 1)`, each once, on so many threads, in no certain order.
///
/// @param told  with how many are done, one call at a time
/// @throws what the first piece that failed threw; pieces that nobody began are left out then
inline void run_on_threads(std::size_t count,
                           std::size_t threads,
                           const std::function<void(std::size_t)>& work,
                           const std::function<void(std::size_t)>& told) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::size_t done = 0;
  std::exception_ptr failure;
  const auto go_on = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
        const std::lock_guard lock(mutex);
        told(++done);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 1; i < threads; ++i) workers.emplace_back(go_on);
    go_on();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace teamsight::tools
