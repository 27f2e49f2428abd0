// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_specimen.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_files.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "sim/grains/engine/calming.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "tests/lab/grains/grain_files.hpp"

using namespace triax;
using namespace triax::lab;
using namespace triax::lab::test;

namespace {

std::string programme_text(const std::string& specimen) {
  return "[test]\nname = \"t\"\ntype = \"ICU\"\nscan_interval_s = 1.0\n[specimen]\n" + specimen +
         "height_mm = 140.0\ndiameter_mm = 70.0\n[rig]\nback_pressure_kPa = 300.0\n[[stages]]\n"
         "name = \"s\"\nrole = \"shear\"\ndrainage = \"closed\"\naxial = \"displacement\"\n"
         "axial_rate_mm_per_min = 1.0\nend = [{quantity = \"axial_strain_pct\", above = 1.0}]\n";
}

std::string message_of(const std::string& specimen, const std::string& file) {
  try {
    read_programme(programme_text(specimen), file);
  } catch (const BadInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a programme takes void ratio, stress and name of its specimen from the grains") {
  const GrainFolder folder;
  folder.make("small.grains", 0.35, 100);
  const Programme p =
      read_programme(programme_text("grains = \"small.grains\"\nlimit_friction_angle_deg = 24.0\n"),
                     folder / "p.toml");
  CHECK(p.material.name == "100 spheres, small.grains");
  CHECK(p.initial_effective_stress_pa == Approx(1e5).epsilon(0.01));
  CHECK(p.void_ratio > 0.6);
  CHECK(p.void_ratio < 1.2);
  CHECK(p.material.material.tensor == nullptr);
  CHECK_FALSE(p.material.material.no_tensor.empty());
  CHECK(*p.limit_friction_angle_rad == Approx(sim::radians(24)));
  REQUIRE(p.files.size() == 2);
  CHECK(p.files[1] == folder / "small.grains");
}

TEST_CASE("what stands in the grains is not given again, and a file that is none is refused") {
  const GrainFolder folder;
  folder.make("small.grains", 0.35, 100);
  std::ofstream(folder / "no.grains") << "no grains at all";
  const std::string file = folder / "p.toml";
  for (const char* key : {"material = \"a\"", "void_ratio = 0.7",
                          "initial_effective_stress_kPa = 100.0", "material_file = \"m.toml\""})
    CHECK(message_of(std::string("grains = \"small.grains\"\n") + key + "\n", file)
              .find("not allowed with grains") != std::string::npos);
  CHECK(message_of("grains = \"no.grains\"\n", file).find("no.grains") != std::string::npos);
  CHECK(message_of("grains = \"absent.grains\"\n", file).find("absent.grains") !=
        std::string::npos);
  CHECK(message_of("inertial_number = 1e-4\n", file).find("material") != std::string::npos);
}

TEST_CASE("grains that are not at rest or not under an isotropic stress are refused by name") {
  const GrainFolder folder;
  auto state = load_state(folder.make("small.grains", 0.35, 100));
  CHECK(state.grains.size() == 100);
  sim::Grains grains(state);
  grains.drive(sim::triaxial_drives(sim::stress_drive(1.3e5), sim::stress_drive(1e5)));
  sim::settle(grains, {.unbalanced = 2e-3, .stress_error_pa = 1e3});
  folder.write("uneven.grains", grains.state());
  const std::string message = message_of("grains = \"uneven.grains\"\n", folder / "p.toml");
  CHECK(message.find("uneven.grains") != std::string::npos);
  CHECK(message.find("not isotropic") != std::string::npos);
}
