// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sweep/sweep_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "lab/rig/simulated/without_guard.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

void take_findings(SweepMember& member, const lab::TestSummary& summary) {
  const lab::Collapse& collapse = summary.collapse;
  member.judged = collapse.judged;
  member.kind = collapse.kind;
  if (collapse.detected() && collapse.onset) {
    member.time_s = collapse.onset->time_s;
    member.eta = collapse.onset->eta();
  }
  if (!summary.truth) return;
  member.truly_lost = summary.truth->lost_sustainability;
  member.true_time_s = summary.truth->time_s;
  member.true_eta = true_instant(*summary.truth).eta();
}

/// Tests are taken from one counter, results have places of their own.
class SweepRun {
 public:
  SweepRun(const SweepJob& job, const std::function<bool()>& stop)
      : job_(job), stop_(stop), members_(static_cast<std::size_t>(job.sweep.size())) {
    for (std::size_t i = 0; i < members_.size(); ++i)
      members_[i].place = static_cast<std::int64_t>(i) + 1;
  }

  void work() {
    for (auto i = next_++; i < members_.size() && !stop_(); i = next_++) {
      SweepMember& member = members_[i];
      try {
        run(member);
      } catch (const std::exception& error) {
        member.failure = error.what();
        ++failed_;
      }
      turns_.over(member.place);
      ++done_;
    }
    const std::lock_guard lock(mutex_);
    ++ended_;
    end_.notify_one();
  }

  void wait(std::size_t threads, const std::function<void(const SweepCounts&)>& show) {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    while (!end_.wait_for(lock, 100ms, [&] { return ended_ == threads; }))
      show({.done = done_, .failed = failed_});
  }

  /// Waits no longer for tests that nobody will start.
  void give_up() { next_ = members_.size(); }

  std::vector<SweepMember> take() { return std::move(members_); }

 private:
  void run(SweepMember& member) {
    lab::Programme programme = lab::read_programme(
        job_.text, job_.file, edits_of_member(job_.edits, job_.sweep, member.place));
    programme.changes = job_.edits;
    programme.name += fmt::format(" [{}]", job_.sweep.label(member.place));
    lab::VirtualRig rig(programme);
    db::Patience patience = job_.patience;
    patience.stop = stop_;
    db::Recorder recorder(job_.db, std::move(patience));
    recorder.belongs_to({job_.name, member.place, job_.sweep.values(member.place)}, turns_);
    try {
      const lab::TestSummary summary =
          lab::run_session(rig,
                           {.reduction = {},
                            .speed = job_.speed,
                            .stop = stop_,
                            .without_guard = lab::without_guard(programme, {}, stop_)},
                           {recorder.listener()});
      if (stop_()) return recorder.discard();
      member.id = recorder.finish(summary);
      take_findings(member, summary);
    } catch (const lab::BadInput&) {
      recorder.discard();
      throw;
    }
  }

  const SweepJob& job_;
  const std::function<bool()>& stop_;
  std::vector<SweepMember> members_;
  db::Turns turns_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::int64_t> done_ = 0, failed_ = 0;
  std::mutex mutex_;
  std::condition_variable end_;
  std::size_t ended_ = 0;
};

}  // namespace

std::vector<lab::TomlEdit> edits_of_member(const std::vector<lab::TomlEdit>& all,
                                           const lab::Sweep& sweep, std::int64_t place) {
  std::vector<lab::TomlEdit> edits = all;
  for (lab::TomlEdit& edit : sweep.edits(place)) {
    if (std::ranges::count(all, edit.key, &lab::TomlEdit::key) > 0)
      throw lab::BadInput(
          fmt::format("--set {}: --sweep gives this key its values; leave out one", edit.key));
    edits.push_back(std::move(edit));
  }
  return edits;
}

std::vector<SweepMember> run_sweep(const SweepJob& job, const std::function<bool()>& stop,
                                   const std::function<void(const SweepCounts&)>& show) {
  SweepRun run(job, stop);
  const auto wanted = static_cast<std::size_t>(std::max(job.jobs, 1));
  const auto threads = std::min(wanted, static_cast<std::size_t>(job.sweep.size()));
  {
    std::vector<std::jthread> workers;
    try {
      for (std::size_t i = 0; i < threads; ++i) workers.emplace_back([&run] { run.work(); });
      run.wait(threads, show);
    } catch (...) {
      run.give_up();
      throw;
    }
  }
  return run.take();
}

}  // namespace triax::study
