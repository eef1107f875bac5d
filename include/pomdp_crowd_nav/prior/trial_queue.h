// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pomdp_crowd_nav {

// The trial cells of a march, earliest first: a binary heap. Trials of equal time come in an order
// that is the same everywhere.
class TrialQueue {
 public:
  struct Trial {
    float time = 0.0F;  // [s], not negative
    int cell = 0;
  };

  bool isEmpty() const { return heap_.empty(); }

  void push(const Trial& trial) {
    heap_.emplace_back();
    rise(heap_.size() - 1, {rankOf(trial.time), trial.cell});
  }

  // Takes the earliest out of a queue that is not empty. The hole it leaves sinks to the bottom
  // without a look at the last trial, which belongs there or little above, and without a branch
  // that a processor could not foretell (Wegener, Theoretical Computer Science 118, 1993).
  Trial pop() {
    const Entry earliest = heap_.front();
    const Entry last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) rise(sink(), last);
    return {timeOf(earliest.rank), earliest.cell};
  }

 private:
  struct Entry {
    std::int32_t rank = 0;
    std::int32_t cell = 0;
  };

  // Bits of numbers that are not negative order as the numbers do, and integers compare faster.
  static std::int32_t rankOf(float time) {
    std::int32_t rank = 0;
    std::memcpy(&rank, &time, sizeof rank);
    return rank;
  }
  static float timeOf(std::int32_t rank) {
    float time = 0.0F;
    std::memcpy(&time, &rank, sizeof time);
    return time;
  }

  // Moves the hole on top to a place without children.
  std::size_t sink() {
    Entry* const heap = heap_.data();
    const std::size_t count = heap_.size();
    std::size_t hole = 0;
    for (std::size_t right = 2; right < count; right = 2 * hole + 2) {
      const std::size_t child = right - (heap[right].rank > heap[right - 1].rank ? 1 : 0);
      heap[hole] = heap[child];
      hole = child;
    }
    const std::size_t left = 2 * hole + 1;
    if (left >= count) return hole;
    heap[hole] = heap[left];
    return left;
  }

  // Puts an entry into a hole, or above it.
  void rise(std::size_t hole, const Entry& entry) {
    while (hole > 0 && heap_[(hole - 1) / 2].rank > entry.rank) {
      heap_[hole] = heap_[(hole - 1) / 2];
      hole = (hole - 1) / 2;
    }
    heap_[hole] = entry;
  }

  std::vector<Entry> heap_;
};

}  // namespace pomdp_crowd_nav
