// fusion/inline_list.hpp: a list of bounded length that lives inside its owner, without allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "geometry/expect.hpp"

namespace teamsight::fusion {

/// Up to `N` values in order; copying copies the values there are, nothing is shared or allocated.
template <class T, std::size_t N>
class InlineList {
 public:
  static constexpr std::size_t kCapacity = N;

  InlineList() = default;
  ~InlineList() = default;

  InlineList(const InlineList& other) : size_(other.size_) {
    std::copy(other.begin(), other.end(), begin());
  }

  InlineList& operator=(const InlineList& other) {
    size_ = other.size_;
    if (this != &other) std::copy(other.begin(), other.end(), begin());
    return *this;
  }

  // There is nothing to be taken away: moving copies the values there are.
  InlineList(InlineList&& other) noexcept : size_(other.size_) {
    std::copy(other.begin(), other.end(), begin());
  }

  InlineList& operator=(InlineList&& other) noexcept {
    return *this = static_cast<const InlineList&>(other);
  }

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] bool empty() const { return size_ == 0; }

  [[nodiscard]] bool is_full() const { return size_ == N; }

  /// @pre not full
  void push_back(const T& value) {
    TEAMSIGHT_EXPECT(!is_full());
    values_[size_] = value;
    ++size_;
  }

  /// Removes one value and keeps the order of the others. @pre index < size()
  void erase(std::size_t index) {
    TEAMSIGHT_EXPECT(index < size_);
    for (std::size_t i = index + 1; i < size_; ++i) values_[i - 1] = values_[i];
    --size_;
  }

  [[nodiscard]] T& operator[](std::size_t index) { return values_[index]; }

  [[nodiscard]] const T& operator[](std::size_t index) const { return values_[index]; }

  [[nodiscard]] T* begin() { return values_.data(); }

  [[nodiscard]] T* end() { return values_.data() + size_; }

  [[nodiscard]] const T* begin() const { return values_.data(); }

  [[nodiscard]] const T* end() const { return values_.data() + size_; }

 private:
  std::array<T, N> values_{};
  std::size_t size_{0};
};

}  // namespace teamsight::fusion
