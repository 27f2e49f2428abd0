// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/record_replay.hpp"

#include <filesystem>
#include <utility>

#include "lab/rig/otherwise.hpp"
#include "src/output/notice.hpp"
#include "src/output/progress_bar.hpp"
#include "src/study/triaxial/test_run.hpp"
#include "src/triaxial/shown_on.hpp"

namespace triax::src {

lab::RecordOptions ReplayRequest::options_for(const std::string& path,
                                              const TestOfFile& test) const {
  lab::RecordOptions options = test.options(record);
  options.job = job.values_for(path);
  return options;
}

study::FindTests ReplayRequest::tests_in(const std::string& path) const {
  return [path, options = options_for(path)](lab::Extent extent) {
    return lab::tests_in(path, options, extent);
  };
}

std::unique_ptr<lab::RecordedRig> open_to_replay(const ReplayRequest& request,
                                                 const std::string& path, const TestOfFile& test) {
  auto rig = lab::open_record(path, request.options_for(path, test));
  const lab::Reduction can_be_reduced(rig->header(), request.reduction);
  return rig;
}

std::int64_t replay_record(const ReplayRequest& request, const std::string& path,
                           lab::RecordedRig& rig, std::string& db, const Interruption& interruption,
                           const TestOfFile& test) {
  ProgressBar bar(std::filesystem::path(path).filename().string());
  const lab::RecordOptions options = request.options_for(path, test);
  // Thrown through the session: what was read stays, marked as interrupted.
  const auto stop = [&interruption]() -> bool {
    if (interruption.requested()) throw Stopped();
    return false;
  };
  const auto otherwise = [&] {
    return lab::judge_otherwise(rig.header(), request.reduction, [&](const lab::Guess::Said& said) {
      lab::RecordOptions other = options;
      other.sets.emplace_back(said.key, said.value);
      return lab::open_record(path, other);
    });
  };
  return study::run_test(rig,
                         {.reduction = request.reduction,
                          .speed = request.speed,
                          .stop = stop,
                          .otherwise = otherwise,
                          .earlier = request.earlier},
                         db, {shown_on(bar)}, {.say = notify, .stop = [&interruption] {
                                                 return interruption.requested();
                                               }});
}

}  // namespace triax::src
