// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/collapse_increments.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "db/recording/recorder.hpp"
#include "src/study/probe/tested_state.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax;

namespace {

/// One test of 1500 readings in a database: peak of q at reading 600, where collapse is said to set
/// in.
class StoredPath {
 public:
  explicit StoredPath(lab::CollapseKind kind, std::int64_t onset = 600,
                      lab::AxialControl control = lab::AxialControl::displacement) {
    db::Recorder recorder(file());
    const lab::SessionListener listener = recorder.listener();
    lab::RecordHeader header = lab::testing::undrained_header();
    header.name = "ICU 6";
    header.programme = "ICU";
    for (auto& stage : header.stages) stage.control = control;
    listener.started(header);
    lab::testing::SyntheticPath path;
    for (int i = 0; i < 1500; ++i) {
      const lab::State state = path.state(i);
      lab::Reading reading;
      reading.number = i;
      reading.time_s = state.time_s;
      listener.scanned(reading, state);
    }
    listener.second_order_work({600, 600, {0, 0, 0, 0}, 0.02, 7});
    lab::TestSummary summary;
    summary.collapse.kind = kind;
    summary.collapse.onset = lab::Instant{.reading = onset, .q_pa = 60e3, .p_eff_pa = 100e3};
    recorder.finish(summary);
  }
  std::vector<study::CollapseIncrement> increments() const {
    return study::collapse_increments(db::Store(file()), {1});
  }
  std::string file() const { return folder_.file("t.db"); }

 private:
  testing::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("where undrained q has its peak the increment is isotropic unloading") {
  const auto increments = StoredPath(lab::CollapseKind::flow).increments();
  REQUIRE(increments.size() == 1);
  CHECK(increments[0].test == "ICU 6");
  CHECK(increments[0].programme == "ICU");
  CHECK(increments[0].p_pa == 100e3);
  CHECK(increments[0].q_pa == 60e3);
  CHECK(increments[0].dp < 0);
  CHECK(std::fabs(increments[0].dq) < 0.02 * std::fabs(increments[0].dp));
}

TEST_CASE("probe --test and the figures know one increment at collapse, with its error") {
  const StoredPath stored(lab::CollapseKind::flow, 400, lab::AxialControl::constant_q);
  const auto drawn = stored.increments();
  REQUIRE(drawn.size() == 1);
  const auto tested = study::tested_state(db::Store(stored.file()), "1", "collapse", 1.0);
  REQUIRE(tested.increment);
  CHECK(tested.increment->rate.p == drawn[0].dp);
  CHECK(tested.increment->rate.q == drawn[0].dq);
  CHECK(tested.increment->angle_error > 0);
  CHECK(tested.increment->angle_error < 0.2);
}

TEST_CASE("a test that did not collapse has no increment at collapse") {
  CHECK(StoredPath(lab::CollapseKind::none).increments().empty());
}

TEST_CASE("where no window of readings reaches there is no increment") {
  CHECK(StoredPath(lab::CollapseKind::flow, 1000000).increments().empty());
}

TEST_CASE(
    "at held q the increment is the way between two means before the onset, not what follows") {
  lab::testing::SyntheticPath path;
  const auto increments =
      StoredPath(lab::CollapseKind::flow, 400, lab::AxialControl::constant_q).increments();
  REQUIRE(increments.size() == 1);
  // Spans of 20 readings: the middles lie at 390.5 and 370.5.
  const double dp = (path.state(390).p_eff + path.state(391).p_eff) / 2 -
                    (path.state(370).p_eff + path.state(371).p_eff) / 2;
  const double dq =
      (path.state(390).q + path.state(391).q) / 2 - (path.state(370).q + path.state(371).q) / 2;
  CHECK(increments[0].dp == Approx(dp).epsilon(0.2));
  CHECK(increments[0].dq == Approx(dq).epsilon(0.2));
}
