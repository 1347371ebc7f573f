#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/vectors.hpp"

namespace carom {

/// Indices that are found; its memory stays when it is cleared.
class IndexList {
 public:
  void clear() { count_ = 0; }
  const std::uint32_t* begin() const { return items_.data(); }
  const std::uint32_t* end() const { return items_.data() + count_; }
  std::size_t size() const { return count_; }

  void append(std::uint32_t i) {
    make_room(1);
    items_[count_++] = i;
  }
  /// Room for `more` to come by append4, which writes four and keeps those whose lane is 0.
  void make_room(std::size_t more) {
    if (items_.size() < count_ + more + 8) items_.resize(2 * (count_ + more + 8));
  }
  void append4(const std::uint32_t* four, Int4 leave_out) {
    std::uint32_t* items = items_.data();
    for (int lane = 0; lane < 4; ++lane) {
      items[count_] = four[lane];
      count_ += static_cast<std::size_t>(1 + leave_out[lane]);
    }
  }
  /// Ascending, each once. Short lists are the rule.
  void sort() {
    std::uint32_t* items = items_.data();
    if (count_ > 24) {
      std::sort(items, items + count_);
      count_ = static_cast<std::size_t>(std::unique(items, items + count_) - items);
      return;
    }
    std::size_t sorted = 0;
    for (std::size_t from = 0; from < count_; ++from) {
      const std::uint32_t item = items[from];
      std::size_t to = sorted;
      while (to > 0 && items[to - 1] > item) --to;
      if (to > 0 && items[to - 1] == item) continue;
      for (std::size_t k = sorted; k > to; --k) items[k] = items[k - 1];
      items[to] = item;
      ++sorted;
    }
    count_ = sorted;
  }

 private:
  std::vector<std::uint32_t> items_;
  std::size_t count_ = 0;
};

}  // namespace carom
