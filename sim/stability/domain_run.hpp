// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Columns of a bifurcation domain on several threads. A column depends on nothing but the law and
// the grid, so the result is the same to the bit for every number of threads.
#include <functional>
#include <vector>

#include "sim/stability/domain.hpp"

namespace triax::sim {

/// What one thread works with. Every thread has a material of its own, since a law need not bear to
/// be asked by two at once: a UMAT lives in one worker process, with one exchange for its calls.
struct DomainWorker {
  Material material;
  DomainCriteria criteria;
};
using DomainWorkerFactory = std::function<DomainWorker()>;

struct DomainRunOptions {
  int threads = 0;  ///< 0: as many as the machine has cores; never more than columns
  /// Called in the caller's thread with the share done, 0 to 1. False ends the run early.
  std::function<bool(double)> progress;
};

/// The columns named, in their order. `factory` is called in the caller's thread, once a thread. An
/// exception of a column is thrown here once all threads have ended; a run that progress ended
/// gives no columns.
std::vector<DomainColumn> run_domain(const DomainGrid& grid, const std::vector<int>& columns,
                                     const DomainWorkerFactory& factory,
                                     const DomainRunOptions& options = {});

/// The columns of piece `index` of `count` (index from 1): index − 1, index − 1 + count, ... so
/// that all pieces have about the same work. Throws std::invalid_argument for a piece there is not.
std::vector<int> columns_of_piece(const DomainGrid& grid, int index, int count);

}  // namespace triax::sim
