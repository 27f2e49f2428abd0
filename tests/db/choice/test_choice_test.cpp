// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/choice/test_choice.hpp"

#include <catch2/catch.hpp>

#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using testing::TemporaryFolder;

namespace {

void record(const std::string& path, const std::string& name, const std::string& material,
            double p_eff_pa) {
  db::Recorder recorder(path);
  const lab::SessionListener listener = recorder.listener();
  lab::RecordHeader header = testing::raw_header(name);
  header.specimen.material = material;
  listener.started(header);
  testing::send_scans(listener, 0, 10);
  lab::TestSummary summary;
  summary.consolidation.p_eff_pa = p_eff_pa;
  recorder.finish(summary);
}

}  // namespace

TEST_CASE("Tests are chosen by a condition, and grouped by a column or an expression") {
  const TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  record(path, "a", "S28", 100e3);
  record(path, "b", "RF", 200e3);
  record(path, "c", "S28", 300e3);
  CHECK(db::choose_tests(path, "", "").size() == 3);
  const auto sand = db::choose_tests(path, "material = 'S28'", "p0_eff_kPa > 150");
  REQUIRE(sand.size() == 2);
  CHECK(sand[0].id == 1);
  CHECK(sand[0].group == "0");
  CHECK(sand[1].id == 3);
  CHECK(sand[1].group == "1");
  CHECK(db::choose_tests(path, "test = 'b'", "material")[0].group == "RF");
  CHECK_THROWS_AS(db::choose_tests(path, "colour = 'red'", ""), lab::BadInput);
}
