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

/// What threads that share the pieces of one work have to agree upon.
struct SharedWork {
  SharedWork(const std::function<void(std::size_t)>& each,
             const std::function<void(std::size_t)>& progress,
             std::size_t pieces)
      : work(each),
        told(progress),
        count(pieces) {}

  const std::function<void(std::size_t)>& work;
  const std::function<void(std::size_t)>& told;
  std::size_t count;
  std::atomic<std::size_t> next{0};
  std::mutex mutex;  // of what follows, and of `told`
  std::size_t done{0};
  std::exception_ptr failure;
};

/// Does pieces until none is left; one that fails is the last.
inline void take_part(SharedWork& shared) {
  for (std::size_t i = shared.next++; i < shared.count; i = shared.next++) {
    try {
      shared.work(i);
      const std::lock_guard lock(shared.mutex);
      shared.told(++shared.done);
    } catch (...) {
      const std::lock_guard lock(shared.mutex);
      if (!shared.failure) shared.failure = std::current_exception();
      shared.next = shared.count;
    }
  }
}

/// Does `work(0)` to `work(count - 1)`, each once, on so many threads, in no certain order.
///
/// @param told  with how many are done, one call at a time
/// @throws what the first piece that failed threw; pieces that nobody began are left out then
inline void run_on_threads(std::size_t count,
                           std::size_t threads,
                           const std::function<void(std::size_t)>& work,
                           const std::function<void(std::size_t)>& told) {
  SharedWork shared(work, told, count);
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 1; i < threads; ++i) workers.emplace_back([&] { take_part(shared); });
    take_part(shared);
  }
  if (shared.failure) std::rethrow_exception(shared.failure);
}

}  // namespace teamsight::tools
