// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/rig_check.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lab/wire/served_bench.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;

namespace {

Programme noisy() {
  return read_programme(
      programme_text("\n[[stages]]\nname = \"rest\"\nrole = \"shear\"\ndrainage = \"open\"\naxial "
                     "= \"free\"\nend = [{quantity = \"time_min\", above = 1.0}]\n",
                     "back_pressure_kPa = 300.0\n[rig.transducers.cell_pressure]\n"
                     "range_kPa = 1000.0\nnoise_kPa = 0.5\n"),
      "p.toml");
}

const InstrumentCheck& named(const std::vector<InstrumentCheck>& all, const std::string& name) {
  for (const auto& one : all)
    if (one.name == name) return one;
  throw std::runtime_error(name);
}

}  // namespace

TEST_CASE("a rig that is well says who is there, what each channel reads and how noisy it is") {
  const ServedBench bench(noisy(), rig_text(), {});
  const auto checks = check_rig(bench.client, 2);
  CHECK(all_well(checks));
  const InstrumentCheck& scanner = named(checks, "scanner");
  CHECK(scanner.identity == "triax,34970A,simulated,1");
  CHECK(scanner.answer_s > 0);
  REQUIRE(scanner.channels.size() == 4);
  CHECK(scanner.channels[2].value == Approx(400).margin(3));
  CHECK(scanner.channels[2].noise > 0.1);
  CHECK(scanner.channels[2].noise < 2);
  CHECK(scanner.channels[3].value == Approx(300));
}

TEST_CASE("what is wrong with a rig is said in words") {
  const ServedBench bench(noisy(), rig_text(), {});
  RigFile rig = bench.client;
  LineLoop loop;
  ControlLine control(loop, *rig.plant->control);
  tell(control, "LINE:FAULT \"back\",REFUSE");
  tell(control, "LINE:PRET \"frame\",ON");
  rig.instruments[0].channels[0].calibration.date.clear();
  rig.instruments[0].channels[2].calibration.range = {0, 390};
  rig.instruments[0].channels[3].calibration.gain = 1e6;
  const auto checks = check_rig(rig, 1);
  CHECK_FALSE(all_well(checks));
  CHECK_THAT(named(checks, "back").trouble, Contains("refused"));
  CHECK_THAT(named(checks, "frame").trouble, Contains("somebody,else"));
  CHECK(named(checks, "cell").trouble.empty());
  const auto& channels = named(checks, "scanner").channels;
  CHECK_THAT(channels[0].trouble, Contains("no calibration date"));
  CHECK(channels[1].trouble.empty());
  CHECK_THAT(channels[2].trouble, Contains("outside the calibrated range"));
  CHECK_THAT(channels[3].trouble, Contains("impossible in a triaxial apparatus"));
}
