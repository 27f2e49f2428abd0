// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/lammps_script.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "tests/sim/grains/packings.hpp"

using namespace triax;

TEST_CASE("every variable, compute and fix of the script for LAMMPS is defined before it is used") {
  const sim::GrainState state = sim::test::lattice(3);
  for (const auto kind : {sim::GrainPathKind::isotropic, sim::GrainPathKind::drained,
                          sim::GrainPathKind::strain_path}) {
    sim::GrainPath path;
    path.kind = kind;
    path.stress_rate_pa_per_s = 1e5;
    const std::string script =
        lab::lammps_script(state, path, lab::size_bins(state, 3), {"t", "a.data", "a.csv", 3});
    // The text of all lines before, without what a line defines itself.
    for (const auto& [mark, command] : {std::pair<std::string, std::string>{"v_", "variable "},
                                        {"c_", "compute "},
                                        {"f_", "fix "}})
      for (std::size_t at = 0; (at = script.find(mark, at)) != std::string::npos; ++at) {
        if (at > 0 && (std::isalnum(static_cast<unsigned char>(script[at - 1])) != 0)) continue;
        std::size_t end = at + 2;
        while (std::isalnum(static_cast<unsigned char>(script[end])) != 0) ++end;
        const std::string name = script.substr(at + 2, end - at - 2);
        INFO(command << name);
        const std::size_t defined = script.find('\n' + command + name + ' ');
        REQUIRE(defined != std::string::npos);
        // A servo and what it is read with refer to each other.
        if (mark != "f_") CHECK(defined < at);
      }
  }
}
