// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/global_search.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "sim/grains/state/random.hpp"

namespace triax::study {
namespace {

constexpr double kAlike = 1e-3;  // spread of the sums over the least of them

/// The start, and others so that each unknown has one member in each of as many equal parts.
std::vector<Candidate> first_members(const Misfit& misfit, std::size_t members, sim::Random& dice) {
  const Eigen::Index n = misfit.space().size();
  std::vector<Candidate> all(members, {Unknowns(n), 0});
  std::vector<std::size_t> places(members);
  for (Eigen::Index i = 0; i < n; ++i) {
    std::iota(places.begin(), places.end(), 0);
    for (std::size_t k = members; k > 1; --k) std::swap(places[k - 1], places[dice.below(k)]);
    for (std::size_t k = 0; k < members; ++k)
      all[k].x(i) =
          (static_cast<double>(places[k]) + dice.uniform()) / static_cast<double>(members);
  }
  all.front().x = misfit.space().start_point();
  for (Candidate& member : all) member.x = misfit.space().possible_near(member.x);
  return all;
}

class Evolution {
 public:
  Evolution(const Misfit& misfit, std::size_t members, std::uint64_t seed)
      : misfit_(misfit), dice_(seed), all_(first_members(misfit, members, dice_)) {
    misfit_.each(all_.size(), [&](std::size_t k) {
      all_[k].sum = misfit_.sum_of_squares(all_[k].x, std::numeric_limits<double>::infinity());
    });
    sort();
  }

  void next_generation() {
    std::vector<Candidate> trials;
    for (std::size_t k = 0; k < all_.size(); ++k) trials.push_back({trial(k), 0});
    misfit_.each(trials.size(), [&](std::size_t k) {
      trials[k].x = misfit_.space().possible_near(trials[k].x);
      trials[k].sum = misfit_.sum_of_squares(trials[k].x, all_[k].sum);
    });
    for (std::size_t k = 0; k < trials.size(); ++k)
      if (trials[k].sum <= all_[k].sum) all_[k] = trials[k];
    sort();
  }

  bool alike() const { return all_.back().sum - all_.front().sum <= kAlike * all_.front().sum; }
  std::vector<Candidate> take() { return std::move(all_); }

 private:
  void sort() { std::ranges::stable_sort(all_, {}, &Candidate::sum); }

  Unknowns trial(std::size_t k) {
    const Eigen::Index n = misfit_.space().size();
    const std::size_t best = dice_.below(std::max<std::size_t>(2, all_.size() / 5));
    const std::size_t a = dice_.below(all_.size()), b = dice_.below(all_.size());
    const double factor = 0.4 + 0.5 * dice_.uniform();
    const double crossing = dice_.uniform() < 0.5 ? 0.9 : 0.4;
    const auto sure = static_cast<Eigen::Index>(dice_.below(static_cast<std::size_t>(n)));
    Unknowns x = all_[k].x;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (dice_.uniform() > crossing && i != sure) continue;
      x(i) += factor * (all_[best].x(i) - all_[k].x(i) + all_[a].x(i) - all_[b].x(i));
      // Beyond a bound, half way to it from where the member was.
      if (x(i) < 0) x(i) = all_[k].x(i) / 2;
      if (x(i) > 1) x(i) = (1 + all_[k].x(i)) / 2;
    }
    return x;
  }

  const Misfit& misfit_;
  sim::Random dice_;
  std::vector<Candidate> all_;
};

}  // namespace

std::vector<Candidate> global_search(const Misfit& misfit, const GlobalOptions& options,
                                     const std::function<bool(double)>& progress) {
  const auto n = static_cast<std::size_t>(misfit.space().size());
  const std::size_t members = options.members > 0 ? static_cast<std::size_t>(options.members)
                                                  : std::max<std::size_t>(24, 6 * n);
  Evolution evolution(misfit, members, options.seed);
  for (int g = 0; g < options.generations && !evolution.alike(); ++g) {
    if (!progress(static_cast<double>(g + 1) / (options.generations + 1))) break;
    evolution.next_generation();
  }
  return evolution.take();
}

}  // namespace triax::study
