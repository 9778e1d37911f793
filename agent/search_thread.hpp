// agent/search_thread.hpp: searches the whole field on a thread of its own.
#pragma once

#include <memory>
#include <optional>

#include "geometry/field_model.hpp"
#include "vision/localisation/localisation.hpp"

namespace teamsight::agent {

/// A background for vision::BackgroundSearch: no frame ever waits for it.
class SearchThread {
 public:
  explicit SearchThread(const FieldModel& field);

  /// Waits for a search that is under way: some 25 ms.
  ~SearchThread();
  SearchThread(const SearchThread&) = delete;
  SearchThread& operator=(const SearchThread&) = delete;

  /// Starts a search; one that nobody began yet is replaced.
  void ask(vision::SearchRequest request);

  /// Readable when there is an answer; cleared by `take`.
  [[nodiscard]] int event_fd() const noexcept;

  /// The answer; nothing if there is none.
  [[nodiscard]] std::optional<vision::SearchAnswer> take();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::agent
