#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace carom {

// Calls work(i) once for each i = 0 .. count - 1, on `threads` threads (0: one per core), and waits for all.
// If calls throw, the exception of the smallest i is rethrown at the end.
template <class Work>
void parallel_for(int count, int threads, const Work& work) {
  if (threads <= 0) threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  threads = std::min(threads, count);
  std::atomic<int> next = 0;
  std::vector<std::exception_ptr> errors(static_cast<std::size_t>(std::max(count, 0)));
  const auto take_work = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        errors[static_cast<std::size_t>(i)] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> crew;
    for (int i = 1; i < threads; ++i) crew.emplace_back(take_work);
    take_work();
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace carom
