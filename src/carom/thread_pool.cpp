#include "carom/internal/thread_pool.hpp"

#include <system_error>

namespace carom {

ThreadPool::ThreadPool(std::size_t size) {
#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
  while (threads_.size() + 1 < size) {
    try {
      threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      return;  // so many threads there can be, no more
    }
  }
#else
  static_cast<void>(size);
#endif
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  job_given_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(std::size_t parts, const std::function<void(std::size_t)>& part) {
  std::unique_lock lock(mutex_);
  part_ = &part;
  parts_ = parts;
  next_ = 0;
  job_given_.notify_all();
  take_parts(lock);
  job_done_.wait(lock, [this] { return running_ == 0; });
  part_ = nullptr;
}

void ThreadPool::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    job_given_.wait(lock, [this] { return ended_ || (part_ != nullptr && next_ < parts_); });
    if (ended_) return;
    take_parts(lock);
    if (running_ == 0) job_done_.notify_one();
  }
}

void ThreadPool::take_parts(std::unique_lock<std::mutex>& lock) {
  while (next_ < parts_) {
    const std::size_t mine = next_++;
    ++running_;
    const auto& part = *part_;
    lock.unlock();
    part(mine);
    lock.lock();
    --running_;
  }
}

}  // namespace carom
