// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/ags_delivery.hpp"

#include <catch2/catch.hpp>

#include "lab/ags/ags_rules.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;

namespace {

AgsTest undrained(const TestResult& result) {
  AgsTest test{.stored = result.stored, .shear = {}};
  test.stored.header.stages = {{.number = 1,
                                .role = lab::StageRole::shear,
                                .drainage = lab::Drainage::closed,
                                .control = lab::AxialControl::displacement}};
  ScanValues start;
  start.state.stage = 1;
  start.state.time_s = 0;
  start.state.strain.axial = 0;
  start.state.q = 0;
  start.state.p_eff = 100e3;
  start.state.effective_stress = {100e3, 100e3};
  start.state.pore_pressure = 300e3;
  start.cell_pressure = 400e3;
  ScanValues failure = start;
  failure.state.time_s = 3600;
  failure.state.strain.axial = 0.02;
  failure.state.q = 60e3;
  failure.state.pore_pressure = 350e3;
  test.shear = {.start = start, .failure = failure, .half_strain = 0.005, .largest_p_eff = 100e3};
  return test;
}

std::string cell(const lab::AgsDocument& document, const char* heading, std::size_t row = 0) {
  const auto* const table = document.find(std::string_view(heading).substr(0, 4));
  REQUIRE(table != nullptr);
  for (std::size_t i = 0; i < table->headings.size(); ++i)
    if (table->headings[i].name == heading) return table->rows.at(row).at(i);
  return "(none)";
}

}  // namespace

TEST_CASE("an undrained test as TREG and TRET, by hand") {
  const auto document = ags_delivery({undrained(src::test::flow_test())}, {}, "2026-11-25");
  CHECK(cell(document, "TRAN_DATE") == "2026-11-25");
  CHECK(cell(document, "TRAN_AGS") == "4.1.1");
  CHECK(cell(document, "TREG_TYPE") == "CIUC");
  CHECK(cell(document, "TRET_CONP") == "100");
  CHECK(cell(document, "TRET_CELL") == "400");
  CHECK(cell(document, "TRET_PWPI") == "300");
  CHECK(cell(document, "TRET_STRR") == "2.0");  // 2 % in an hour
  CHECK(cell(document, "TRET_STRN") == "2.0");
  CHECK(cell(document, "TRET_DEVF") == "60");
  CHECK(cell(document, "TRET_PWPF") == "350");
  CHECK(cell(document, "TRET_CU") == "30");
  CHECK(cell(document, "TRET_EP50") == "0.50");
  CHECK(cell(document, "TRET_E50") == "6.00");    // 30 kPa / 0.005
  CHECK(cell(document, "TRET_STV") == "(none)");  // of drained tests only
  CHECK(cell(document, "TRET_ETAC") == "0.600");
  CHECK(cell(document, "TRET_KIND") == "flow");
  CHECK(cell(document, "DICT_HDNG") == "TRET_ETAC");
  const auto bytes = lab::ags_text(document);
  CHECK(lab::ags_text(lab::read_ags_document(*lab::open_memory("x.ags", bytes))) == bytes);
}

TEST_CASE("ags_delivery: the loss of control has a heading and a remark", "[ags]") {
  auto test = undrained(src::test::flow_test());
  CHECK(cell(ags_delivery({test}, {}, "2026-11-25"), "TRET_ETAL") == "(none)");
  test.stored.summary.collapse.loss_of_control = lab::Instant{340, 34.0, 0.0623, 50e3, 80e3, 380e3};
  const auto document = ags_delivery({test}, {}, "2026-11-25");
  CHECK(cell(document, "TRET_ETAL") == "0.625");
  CHECK(cell(document, "TREG_REM").find("onset of instability at an axial strain of") !=
        std::string::npos);
  CHECK(cell(document, "TREG_REM").find("loss of control at an axial strain of 6.23 %") !=
        std::string::npos);
}

TEST_CASE("a test that was not judged says so and has no stress ratio; a simulated one says so") {
  const auto cut = ags_delivery({undrained(src::test::interrupted_test())}, {}, "2026-11-25");
  CHECK(cell(cut, "TRET_KIND") == "not assessed");
  CHECK(cell(cut, "TRET_ETAC") == "(none)");
  const auto simulated = ags_delivery({undrained(src::test::simulated_test())}, {}, "2026-11-25");
  CHECK(cell(simulated, "TREG_REM").starts_with("SIMULATED, not measured"));
}

TEST_CASE("constant shear has codes of its own, which ABBR explains, and no failure by q") {
  auto test = undrained(src::test::flow_test());
  test.stored.header.stages[0].control = lab::AxialControl::constant_q;
  test.stored.header.stages[0].drainage = lab::Drainage::open;
  const auto document = ags_delivery({test}, {}, "2026-11-25");
  CHECK(cell(document, "TREG_TYPE") == "CSD");
  CHECK(cell(document, "TRET_DEVF") == "(none)");
  CHECK(cell(document, "TREG_DEV").find("no test of the standards") != std::string::npos);
}

TEST_CASE("a test without consolidation goes out as TRIG and TRIT") {
  auto test = undrained(src::test::flow_test());
  test.stored.header.programme = "UU";
  const auto document = ags_delivery({test}, {}, "2026-11-25");
  CHECK(document.find("TREG") == nullptr);
  CHECK(cell(document, "TRIG_TYPE") == "UU");
  CHECK(cell(document, "TRIT_DEVF") == "60");
  CHECK(cell(document, "TRIT_STRN") == "2.0");
  CHECK(cell(document, "TRIT_CU") == "30");
}

TEST_CASE("the remark of a test without consolidation has no word of collapse") {
  auto test = undrained(src::test::flow_test());
  test.stored.header.programme = "UU";
  test.stored.summary.collapse.judged_until_reason = "too few readings";
  CHECK(cell(ags_delivery({test}, {}, "2026-11-25"), "TRIG_REM") == "(none)");
  test.stored.header.origin = lab::Origin::simulated;
  CHECK(cell(ags_delivery({test}, {}, "2026-11-25"), "TRIG_REM") == "SIMULATED, not measured");
}

TEST_CASE("a cyclic test goes out with one row a cycle") {
  auto test = undrained(src::test::flow_test());
  test.stored.summary.cyclic = lab::CyclicLoading{.cycles = 2};
  test.stored.summary.cyclic->liquefied = lab::CycleInstant{.instant = {}, .cycle = 2};
  for (const std::int64_t number : {1, 2}) {
    CycleValues cycle{.cycle = number, .q_low = -40e3, .q_high = 40e3};
    cycle.strain_high = 0.01 * static_cast<double>(number);
    cycle.u_low = 300e3;
    cycle.u_high = 390e3;
    cycle.last = *test.shear.start;
    cycle.last.state.pore_pressure = 395e3;
    test.shear.cycles.push_back(cycle);
  }
  const auto document = ags_delivery({test}, {}, "2026-11-25");
  CHECK(cell(document, "CTRG_TYPE") == "CIUC");
  CHECK(cell(document, "CTRC_TYPE") == "ISOTROPIC");
  CHECK(document.find("CTRP")->rows.size() == 2);
  CHECK(cell(document, "CTRP_CYCF", 0) == "");
  CHECK(cell(document, "CTRP_CYCF", 1) == "2");
  CHECK(cell(document, "CTRP_QMAX") == "40.0");
  CHECK(cell(document, "CTRP_CSS") == "20.0");
  CHECK(cell(document, "CTRP_PWPM") == "90.0");
  CHECK(cell(document, "CTRP_EAMX", 1) == "2.000");
  CHECK(cell(document, "CTRD_EBPR") == "95.0");
}

TEST_CASE("the client's references stand as they were given, or nothing is written") {
  auto test = undrained(src::test::flow_test());
  test.stored.header.notes = {{"Borehole", "BH 7/a"}, {"Depth", "4,5"}, {"Sample Name", "  22[1]"}};
  const auto of_notes = ags_delivery({test}, {}, "2026-11-25");
  CHECK(cell(of_notes, "LOCA_ID") == "BH 7/a");
  auto said = std::vector{ags_said("SAMP_REF", "A \"7\", b"), ags_said("SAMP_TYPE", "U"),
                          ags_said("TREG_LAB", "Our lab"),
                          ags_said("another test/SAMP_ID", "not for this one")};
  const auto document = ags_delivery({test}, said, "2026-11-25");
  for (const char* const group : {"SAMP", "TREG", "TRET"}) {
    const auto* const table = document.find(group);
    CHECK(table->headings[2].name == "SAMP_REF");
    CHECK(table->rows[0][1] == "4.50");
    CHECK(table->rows[0][2] == "A \"7\", b");
    CHECK(table->rows[0][4] == "");
  }
  CHECK(cell(document, "TREG_LAB") == "Our lab");
  CHECK_THROWS_AS(ags_delivery({test}, {ags_said("SAMP_REF", "Ä1")}, "2026-11-25"), lab::BadInput);
  CHECK_THROWS_AS(ags_delivery({test}, {ags_said("SAMP_TOP", "deep")}, "2026-11-25"),
                  lab::BadInput);
  CHECK_THROWS_WITH(ags_said("SAMP_REFF", "1"), Catch::Contains("did you mean 'SAMP_REF'"));
}

TEST_CASE("two tests of one name keep apart, and a location stands once") {
  const auto test = undrained(src::test::flow_test());
  auto second = test;
  second.stored.id = test.stored.id + 1;
  const auto document = ags_delivery({test, second}, {ags_said("LOCA_ID", "BH1")}, "2026-11-25");
  CHECK(document.find("LOCA")->rows.size() == 1);
  CHECK(document.find("TREG")->rows.size() == 2);
}
