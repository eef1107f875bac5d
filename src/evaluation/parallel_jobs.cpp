// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/parallel_jobs.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace pomdp_crowd_nav {
namespace {

class Queue {
 public:
  explicit Queue(size_t size) : size_(size) {}

  void work(const Job& job) {
    try {
      while (const auto number = next()) deliver(job(*number));
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  void rethrowFailure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::optional<size_t> next() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_ || next_ == size_) return std::nullopt;
    return next_++;
  }

  void deliver(const Delivery& delivery) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (has_failed_delivery_) return;
    has_failed_delivery_ = true;
    delivery();
    has_failed_delivery_ = false;
  }

  size_t size_;
  std::mutex mutex_;
  size_t next_ = 0;
  std::exception_ptr failure_;
  bool has_failed_delivery_ = false;
};

}  // namespace

void runJobs(size_t count, int threads, const Job& job) {
  Queue queue(count);
  std::vector<std::thread> workers;
  for (int i = 0; i < std::max(1, threads); ++i) workers.emplace_back([&] { queue.work(job); });
  for (std::thread& worker : workers) worker.join();
  queue.rethrowFailure();
}

}  // namespace pomdp_crowd_nav
