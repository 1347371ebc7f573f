#include "carom/rollouts.hpp"

#include <algorithm>
#include <atomic>

#include "carom/internal/thread_pool.hpp"

namespace carom {

Rollouts::Rollouts(int threads)
    : thread_pool_(std::make_unique<ThreadPool>(
          static_cast<std::size_t>(std::clamp(threads, 1, max_threads)))) {}

Rollouts::~Rollouts() = default;

void Rollouts::run(const World& start, std::size_t count, PlaySome play_some, void* job) {
  const std::size_t threads = thread_pool_->size();
  worlds_.resize(threads, start);
  // Some at a time, so that no thread often waits for another, and none is long alone at the end.
  const std::size_t some = std::clamp<std::size_t>(count / (threads * 16), 1, 16);
  std::atomic<std::size_t> next = 0;
  thread_pool_->run(threads, [&](std::size_t part) {
    for (std::size_t begin; (begin = next.fetch_add(some)) < count;)
      play_some(job, worlds_[part], begin, std::min(begin + some, count));
  });
}

}  // namespace carom
