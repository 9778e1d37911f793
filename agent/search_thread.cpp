// agent/search_thread.cpp: see search_thread.hpp.
#include "agent/search_thread.hpp"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

namespace teamsight::agent {

struct SearchThread::Impl {
  explicit Impl(const FieldModel& field)
      : search(field),
        event(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
        thread([this] { run(); }) {}

  ~Impl() {
    {
      const std::scoped_lock lock(mutex);
      stopping = true;
    }
    wake.notify_all();
    thread.join();
    ::close(event);
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void run() noexcept {
    std::unique_lock lock(mutex);
    while (true) {
      wake.wait(lock, [this] { return stopping || request.has_value(); });
      if (stopping) return;
      const vision::SearchRequest taken = std::move(*request);
      request.reset();
      lock.unlock();
      vision::SearchAnswer found = search.answer(taken);
      lock.lock();
      answer = std::move(found);
      const std::uint64_t one = 1;
      // A full counter is readable anyway.
      [[maybe_unused]] const auto written = ::write(event, &one, sizeof one);
    }
  }

  vision::BackgroundSearch search;
  int event;
  std::mutex mutex;
  std::condition_variable wake;
  std::optional<vision::SearchRequest> request;
  std::optional<vision::SearchAnswer> answer;
  bool stopping{false};
  std::thread thread;  // last: it uses all of the above
};

SearchThread::SearchThread(const FieldModel& field) : impl_(std::make_unique<Impl>(field)) {}

SearchThread::~SearchThread() = default;

void SearchThread::ask(vision::SearchRequest request) {
  {
    const std::scoped_lock lock(impl_->mutex);
    impl_->request = std::move(request);
  }
  impl_->wake.notify_all();
}

int SearchThread::event_fd() const noexcept {
  return impl_->event;
}

std::optional<vision::SearchAnswer> SearchThread::take() {
  std::uint64_t count = 0;
  [[maybe_unused]] const auto read = ::read(impl_->event, &count, sizeof count);
  const std::scoped_lock lock(impl_->mutex);
  return std::exchange(impl_->answer, std::nullopt);
}

}  // namespace teamsight::agent
