// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <fmt/format.h>
#include <time.h>

#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <string_view>

namespace triax::bench {

/// Whether the words of the output are asked for and no times (`--labels`, tools/pages): work is
/// done once, and what the clock says is printed as #.
inline bool only_labels = false;

/// True where the first argument is --labels, which is then noted and passed over.
inline bool take_labels(int& argc, char**& argv) {
  only_labels = argc > 1 && std::string_view(argv[1]) == "--labels";
  if (only_labels) --argc, ++argv;
  return only_labels;
}

/// A figure that depends on the clock.
inline std::string timed(double value, int digits) {
  return only_labels ? "#" : fmt::format("{:.{}f}", value, digits);
}

/// Seconds of one call of `work`, the least of several repetitions (another process may interfere
/// with any one of them, none can make it faster).
template <class Work>
double least_seconds(int repetitions, Work&& work) {
  double least = std::numeric_limits<double>::infinity();
  if (only_labels) repetitions = 1;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
  }
  return least;
}

/// The same in processor time of this thread: a busy machine does not count.
template <class Work>
double least_thread_seconds(int repetitions, Work&& work) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
  };
  double least = std::numeric_limits<double>::infinity();
  if (only_labels) repetitions = 1;
  for (int i = 0; i < repetitions; ++i) {
    const double start = now();
    work();
    least = std::min(least, now() - start);
  }
  return least;
}

/// Nanoseconds of one solution of a general n × n system by LU with partial pivoting.
template <int n = 6>
double solution_ns() {
  constexpr int kSolutions = 20000;
  Eigen::Matrix<double, n, n> a;
  for (int i = 0; i < n * n; ++i) a(i / n, i % n) = 1.0 / (1 + i % 7) + (i / n == i % n ? 3 : 0);
  Eigen::Matrix<double, n, 1> b = Eigen::Matrix<double, n, 1>::LinSpaced(1, n);
  double sink = 0;
  const double seconds = least_thread_seconds(20, [&] {
    for (int i = 0; i < kSolutions; ++i) {
      a(0, 0) += 1e-9;
      a(0, 1) += 1e-9;
      sink += a.partialPivLu().solve(b)(0);
    }
  });
  volatile double kept = sink;
  static_cast<void>(kept);
  return seconds * 1e9 / kSolutions;
}

}  // namespace triax::bench
