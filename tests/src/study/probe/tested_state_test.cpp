// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/tested_state.hpp"

#include <catch2/catch.hpp>

#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "sim/stability/probe.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax;

namespace {

/// A test of 1500 readings in the database: peak of q at reading 600.
class StoredPath {
 public:
  explicit StoredPath(double void_ratio = 1.05, lab::CollapseKind kind = lab::CollapseKind::flow,
                      bool onset = true) {
    db::Recorder recorder(file());
    const lab::SessionListener listener = recorder.listener();
    lab::RecordHeader header = lab::testing::undrained_header();
    header.name = "ICU 6";
    listener.started(header);
    lab::testing::SyntheticPath path;
    for (int i = 0; i < 1500; ++i) {
      lab::State state = path.state(i);
      state.void_ratio = void_ratio;
      if (i == 7) state.effective_stress = {lab::kMissing, lab::kMissing};
      lab::Reading reading;
      reading.number = i;
      reading.time_s = state.time_s;
      listener.scanned(reading, state);
    }
    // Without any point of second-order work a test would not be judged.
    listener.second_order_work({600, 600, {0, 0, 0, 0}, 0.02, 7});
    lab::TestSummary summary;
    summary.peak = lab::Instant{.reading = 600};
    summary.collapse.kind = kind;
    if (onset) summary.collapse.onset = lab::Instant{.reading = 601};
    recorder.finish(summary);
  }
  std::string file() const { return folder_.file("t.db"); }
  study::TestedState at(const std::string& where, std::optional<double> e = {}) const {
    return study::tested_state(db::Store(file()), "1", where, e);
  }
  std::string refusal(const std::string& where) const {
    try {
      at(where);
    } catch (const lab::BadInput& error) {
      return error.what();
    }
    return {};
  }

 private:
  testing::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("collapse, peak, end and the number of a reading are found") {
  const StoredPath stored;
  CHECK(stored.at("collapse").state.reading == 601);
  CHECK(stored.at("peak").state.reading == 600);
  CHECK(stored.at("end").state.reading == 1499);
  const auto early = stored.at("100");
  CHECK(early.state.reading == 100);
  const lab::State there = lab::testing::SyntheticPath().state(100);
  CHECK(early.state.effective_stress.axial == there.effective_stress.axial);
  CHECK(early.state.effective_stress.radial == there.effective_stress.radial);
  CHECK(early.state.void_ratio == 1.05);
  CHECK(early.id == 1);
  CHECK(early.name == "ICU 6");
  CHECK(early.warnings.empty());
}

TEST_CASE("at the peak of q the test's own increment is isotropic unloading") {
  const auto tested = StoredPath().at("peak");
  REQUIRE(tested.increment);
  CHECK(tested.increment->angle == Approx(sim::kIsotropicUnloading).margin(5e-3));
}

TEST_CASE("a void ratio given replaces that of the test; without either it is asked for") {
  CHECK(StoredPath().at("peak", 0.9).state.void_ratio == 0.9);
  const StoredPath unknown(lab::kMissing);
  CHECK(unknown.at("peak", 0.9).state.void_ratio == 0.9);
  CHECK(unknown.refusal("peak").find("--void-ratio E") != std::string::npos);
}

TEST_CASE("the onset of a failure is taken, and said; without any --at asks for another") {
  const auto failed = StoredPath(1.05, lab::CollapseKind::none).at("collapse");
  CHECK(failed.state.reading == 601);
  REQUIRE(failed.warnings.size() == 1);
  CHECK(failed.warnings[0].find("failed with the drainage open, without collapse") !=
        std::string::npos);
  const StoredPath sound(1.05, lab::CollapseKind::none, false);
  CHECK(sound.refusal("collapse").find("has no collapse; use --at peak") != std::string::npos);
}

TEST_CASE("readings that are not there, have no stress, or are no reading are bad input") {
  const StoredPath stored;
  CHECK(stored.refusal("1500").find("must be 0 to 1499") != std::string::npos);
  CHECK(stored.refusal("7").find("has no effective stresses") != std::string::npos);
  for (const char* bad : {"-1", "1.5", "here", "12x", "99999999999999999999"})
    CHECK(stored.refusal(bad).find("collapse, peak, end or the number") != std::string::npos);
}
