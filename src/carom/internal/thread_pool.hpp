#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace carom {

/// Threads that do the parts of a job together. Which thread does which part is left to chance, so
/// a part must write nothing that another part reads or writes.
class ThreadPool {
 public:
  /// `size` threads, the caller's included; ≥ 1. Where no thread can be started there are fewer.
  explicit ThreadPool(std::size_t size);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  std::size_t size() const { return threads_.size() + 1; }

  /// Calls part(0) … part(parts − 1), each once, and returns when all are done.
  void run(std::size_t parts, const std::function<void(std::size_t)>& part);

  /// Divides [0, count) into size() parts and calls action(part, begin, end) for each. The borders
  /// are multiples of 64, so that no two parts write to one line of the cache.
  template <class Action>
  void share(std::size_t count, Action action) {
    const std::size_t parts = size();
    const std::size_t each = (count / parts / 64 + 1) * 64;
    run(parts, [&](std::size_t part) {
      const std::size_t begin = std::min(count, part * each);
      action(part, begin, std::min(count, begin + each));
    });
  }

 private:
  void work();
  void take_parts(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable job_given_;
  std::condition_variable job_done_;
  const std::function<void(std::size_t)>* part_ = nullptr;
  std::size_t parts_ = 0;
  std::size_t next_ = 0;     ///< part to take
  std::size_t running_ = 0;  ///< parts taken and not done
  bool ended_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace carom
