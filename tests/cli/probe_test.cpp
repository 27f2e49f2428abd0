// SPDX-License-Identifier: GPL-3.0-or-later
// triax probe: what it prints and writes, and how it ends.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kLoose = "probe --material inl2/S28-general --void-ratio 1.086 ";
const std::string kPath = source("samples/paths/icu_100.toml");

/// `told`: all that standard error holds.
json document(const Workplace& here, const std::string& arguments, const std::string& told = "") {
  const Outcome outcome = here.triax(arguments + " --json");
  INFO(arguments << "\n" << outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err == told);
  CHECK(outcome.out.find(": nan") == std::string::npos);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("tables of states, of directions and along a path are those of tests/cli/golden") {
  const Workplace here;
  CHECK(here.triax(kLoose + "--p-kPa 70 --eta 0.5,0.6,0.7").out ==
        content("tests/cli/golden/probe_etas.txt"));
  CHECK(here.triax(kLoose + "--p-kPa 70 --eta 0.6 --probes").out ==
        content("tests/cli/golden/probe_directions.txt"));
  CHECK(here.triax("probe --path " + kPath + " --every 25").out ==
        content("tests/cli/golden/probe_path.txt"));
}

TEST_CASE("the cones of INL2 at p' = 70 kPa, e = 1.086 are the printed ones on half a degree") {
  const Workplace here;
  const json d = document(here, kLoose + "--p-kPa 70 --eta 0.55,0.60,0.70,0.80 --step 0.5");
  REQUIRE(d["states"].size() == 4);
  CHECK(d["states"][0]["cones"].empty());
  CHECK(d["first_unstable_state"]["eta"].get<double>() == Approx(0.6));
  const double printed[][2] = {{0, 0}, {215, 237.5}, {208, 248.5}, {205.5, 255.5}};
  for (std::size_t i = 1; i < 4; ++i) {
    const json& state = d["states"][i];
    REQUIRE(state["cones"].size() == 1);
    double first = 1000, last = 0;
    for (const auto& probe : state["probes"]) {
      const double alpha = probe["alpha_deg"];
      const bool on_grid = std::abs(2 * alpha - std::round(2 * alpha)) < 1e-9;
      if (!on_grid || probe["w2_normalised"].get<double>() >= 0) continue;
      first = std::min(first, alpha);
      last = std::max(last, alpha);
    }
    CHECK(first == Approx(printed[i][0]));
    CHECK(last == Approx(printed[i][1]));
    CHECK(state["cones"][0]["from_deg"].get<double>() <= first);
    CHECK(state["cones"][0]["to_deg"].get<double>() >= last);
    CHECK(state["isotropic_unloading"]["in_cone"] == true);
  }
}

TEST_CASE("the document of one state has the keys of the contract") {
  const Workplace here;
  const json d = document(here, kLoose + "--p-kPa 70 --eta 0.60");
  CHECK(d["origin"] == "simulated");
  for (const char* key : {"name", "law", "source", "range"}) CHECK(d["material"][key].is_string());
  for (const char* key :
       {"p_eff_kPa", "q_kPa", "eta", "void_ratio", "axial_stress_kPa", "radial_stress_kPa"})
    CHECK(d["state"][key].is_number());
  CHECK(d["probing"] == json::parse(R"({"kind": "stress", "plane": "axisymmetric", "norm_kPa": 1.0,
    "norm_strain": null, "step_deg": 10.0, "finite": false, "norms": "full"})"));
  for (const char* key :
       {"from_deg", "to_deg", "opening_deg", "strongest_deg", "w2_normalised_least"})
    CHECK(d["cones"][0][key].is_number());
  for (const char* key : {"alpha_deg", "w2_normalised"}) CHECK(d["least"][key].is_number());
  const json& probe = d["probes"][0];
  for (const char* key : {"alpha_deg", "w2_normalised", "w2_Pa"}) CHECK(probe[key].is_number());
  CHECK(probe["stress"]["axial_kPa"].is_number());
  CHECK(probe["stress"]["radial_kPa"].is_number());
  CHECK(probe["strain"]["axial"].is_number());
  CHECK(probe["answered"] == true);
  CHECK(d["isotropic_unloading"]["alpha_deg"].get<double>() == Approx(215.26).margin(0.005));
  CHECK(d["warnings"].empty());
  CHECK(d["own_increment"].is_null());
}

TEST_CASE("a test's own increment at collapse is isotropic unloading, at the edge of the cone") {
  const Workplace here;
  REQUIRE(here.triax("simulate " + source("samples/programmes/icu_6.toml")).status == 0);
  const std::string probe = "probe --test 1 --material inl2/S28-general ";
  const json d = document(here, probe + "--at collapse");
  const json& own = d["own_increment"];
  CHECK(d["state"]["test"]["name"] == "ICU 6");
  CHECK(d["state"]["test"]["origin"] == "simulated");
  CHECK(own["alpha_deg"].get<double>() == Approx(215.26).margin(2));
  CHECK(own["w2_normalised_measured"].get<double>() == Approx(0).margin(0.05));
  CHECK(own["nearest_edge_deg"].get<double>() < 1.5);  // the specimen's own law
  CHECK(own["in_cone"].is_boolean());
  CHECK(own["cone"] == 0);
  const std::string text = here.triax(probe).out;
  CHECK(text.find("ICU 6 (number 1, simulated) at collapse, reading ") != std::string::npos);
  CHECK(text.find("the cone ") != std::string::npos);
  // Nearer to the edge than its standard error.
  CHECK(own["certain"] == false);
  CHECK(text.find("on the edge of the cone") != std::string::npos);
  const json space = document(here, probe + "--plane 3d --step 15");
  CHECK(space["own_increment"]["alpha_deg"] == own["alpha_deg"]);
  CHECK(space["own_increment"]["w2_normalised_law"].get<double>() ==
        Approx(own["w2_normalised_law"].get<double>()).margin(1e-9));
  char law[32];
  std::snprintf(law, sizeof law, "of the law %.3f", own["w2_normalised_law"].get<double>());
  CHECK(here.triax(probe + "--plane 3d --step 15").out.find(law) != std::string::npos);

  for (const auto& [arguments, says] : std::vector<std::pair<std::string, std::string>>{
           {"--at 99999999", "must be 0 to"},
           {"--at there", "collapse, peak, end or the number of a reading"},
           {"--at end --db none.db", "database does not exist"}}) {
    const Outcome outcome = here.triax(probe + arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(says) != std::string::npos);
  }
  CHECK(here.triax("probe --test 7 --material inl2/S28-general").status == 2);
}

TEST_CASE("what makes no sense is one line and status 2, and nothing is written") {
  const std::pair<std::string, std::string> all[] = {
      {"", "no state is given"},
      {"--p-kPa 70", "--eta or --q-kPa"},
      {"--p-kPa 0 --eta 0.5", "--p-kPa 0"},
      {"--p-kPa 70 --eta 1.5", "out of range for inl2/S28-general: the stress ratio"},
      {"--p-kPa 70 --eta 3", "out of range for"},
      {"--p-kPa 70 --eta 0.6 --step 0", "--step 0"},
      {"--p-kPa 70 --eta 0.6 --norm-kPa=-1", "--norm-kPa -1"},
      {"--p-kPa 70 --eta 0.6 --q-kPa 5", "exclude each other"},
      {"--p-kPa 70 --eta 0.6 --path p.toml", "more than one kind of state"},
      {"--p-kPa 70 --eta 0.6 --plane sphere", "--plane"},
      {"--stress-kPa 100,80,60", "is not axisymmetric"},
      {"--p-kPa 70 --eta 0.6 --set poisson_ratio=2", "poisson_ratio"},
      {"--p-kPa 70 --eta 0.6 --void-ratio 99", ""},
      {"--path gone.toml", "gone.toml"},
      {"--p-kPa 70 --eta 0.6,,0.7", "0.6,,0.7"},
      {"--p-kPa 70 --eta 0.6 --axial-strain 0.1", "--axial-strain"},
      {"--p-kPa 70 --eta 0.6 --conditions 'q_kPa = 1'", "two conditions"},
  };
  for (const auto& [arguments, says] : all) {
    const Workplace here;
    const Outcome outcome = here.triax(kLoose + arguments + " --output x --json");
    INFO(arguments << "\n" << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK_FALSE(here.has("x"));
  }
  const Workplace here;
  CHECK(here.triax("probe --p-kPa 70 --eta 0.6 --void-ratio 1").err.find("--material") !=
        std::string::npos);
  CHECK(here.triax("probe --material inl2/S28-general --p-kPa 70 --eta 0.6")
            .err.find("--void-ratio") != std::string::npos);
}

TEST_CASE("--output writes the document, the table and every figure with its data") {
  const Workplace here;
  const std::string arguments = kLoose + "--p-kPa 70 --eta 0.6 ";
  REQUIRE(here.triax(arguments + "--output x").status == 0);
  CHECK(content(here / "x/probe.json") == here.triax(arguments + "--json").out);
  CHECK(content(here / "x/probe.csv").find("origin = \"simulated\"") != std::string::npos);
  for (const char* figure :
       {"circular", "polar", "work", "envelope", "control", "cones_pq", "cones_rendulic"})
    for (const char* ending : {".svg", ".png", ".pdf", ".csv", ".json"}) {
      INFO(figure << ending);
      CHECK(content(here / (std::string("x/probe_") + figure + ending)).size() > 100);
    }
  CHECK(here.triax(arguments + "--output new/deep").status == 0);  // folders are made
  CHECK(content(here / "new/deep/probe.json") == content(here / "x/probe.json"));
  write(here / "probe.json", content(kPath));
  CHECK(here.triax("probe --path probe.json --output .").status == 2);  // it would be replaced
  CHECK(content(here / "probe.json") == content(kPath));
}

TEST_CASE("control is part of the document, and of the text where it is asked for") {
  const Workplace here;
  const json d = document(here, kLoose + "--p-kPa 70 --eta 0.60 --R 0.5,1,2");
  const json& control = d["control"];
  REQUIRE(control["scan"].size() == 3);
  CHECK(control["scan"][0]["controllable"] == false);
  CHECK(control["scan"][2]["controllable"] == true);
  CHECK(control["lost"][0]["from_R"].get<double>() < 0.5);
  CHECK(control["lost"][0]["to_R"].get<double>() > 1);
  CHECK(control["roots"].size() == 2);
  CHECK(control["named"].size() > 3);
  const std::string plain = here.triax(kLoose + "--p-kPa 70 --eta 0.60").out;
  const std::string long_text = here.triax(kLoose + "--p-kPa 70 --eta 0.60 --control").out;
  CHECK(plain.find("drained, ") == std::string::npos);
  CHECK(long_text.find("undrained, ") != std::string::npos);
}

TEST_CASE("proportional strain paths: peaks as JSON, files, and what they do not take") {
  const Workplace here;
  const std::string paths = kLoose + "--p-kPa 100 --strain-paths 0.8,1.0 --axial-strain 0.02";
  const json d = document(
      here, paths + " --output f",
      "triax: wrote f/probe.svg, f/probe.png, f/probe.pdf, f/probe.csv and f/probe.json\n");
  REQUIRE(d["strain_paths"].size() == 2);
  CHECK(d["strain_paths"][1]["R"] == 1.0);
  CHECK(d["strain_paths"][1]["peak"]["q_kPa"].get<double>() == Approx(44.62).margin(0.05));
  for (const char* ending : {".svg", ".png", ".pdf", ".csv", ".json"})
    CHECK(content(here / (std::string("f/probe") + ending)).size() > 100);
  for (const std::string bad : {"--strain-paths 0.8", "--p-kPa 100 --strain-paths 0",
                                "--p-kPa 100 --strain-paths 1 --eta 0.5",
                                "--p-kPa 100 --strain-paths 1 --plane plane-strain",
                                "--p-kPa 100 --strain-paths 1 --axial-strain 7"}) {
    const Outcome outcome = here.triax(kLoose + bad);
    INFO(bad << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

TEST_CASE("the norms of normalised work are told: in the plane in plane strain, else full") {
  const Workplace here;
  const std::string plane = kLoose + "--p-kPa 70 --eta 0.4 --plane ";
  CHECK(document(here, plane + "plane-strain")["probing"]["norms"] == "plane");
  CHECK(document(here, plane + "3d --step 15")["probing"]["norms"] == "full");
  CHECK(here.triax(plane + "plane-strain").out.find("norms in the plane") != std::string::npos);
}

TEST_CASE("all directions of space: the document, and files") {
  const Workplace here;
  const json d = document(
      here, kLoose + "--p-kPa 70 --eta 0.6 --plane 3d --output s",
      "triax: wrote s/probe.json, s/probe.csv, s/probe.svg, s/probe.png and s/probe.pdf\n");
  CHECK(d["probing"]["plane"] == "3d");
  CHECK(d["unstable_regions"] == 1);
  CHECK(d["probes"].size() == 18 * 36);
  for (const char* ending : {".svg", ".png", ".pdf", ".csv", ".json"})
    CHECK(content(here / (std::string("s/probe") + ending)).size() > 100);
  CHECK(here.triax(kLoose + "--p-kPa 70 --eta 0.6 --plane 3d --finite").status == 2);
}

TEST_CASE("the examples of the help run") {
  const Workplace here;
  for (const std::string arguments :
       {"probe --material sanisand/S28-general --stress-kPa 110,80,50 --void-ratio 1.0 "
        "--plane plane-strain --probes",
        "probe --material hypoplastic/S28-MT --p-kPa 70 --eta 0.6 --void-ratio 1.0 --finite "
        "--norm-kPa 0.5"}) {
    const Outcome outcome = here.triax(arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
  }
}

TEST_CASE("along a path the first unstable state lies between rows, and the last row is there") {
  const Workplace here;
  const json one = document(here, "probe --path " + kPath + " --every 25");
  const json other = document(here, "probe --path " + kPath + " --every 40");
  for (const char* key : {"p_eff_kPa", "q_kPa", "eta", "axial_strain", "alpha_deg"})
    CHECK(one["first_unstable_state"][key].get<double>() ==
          Approx(other["first_unstable_state"][key].get<double>()).epsilon(1e-6));
  CHECK(one["states"].back()["state"]["axial_strain"] ==
        other["states"].back()["state"]["axial_strain"]);
}

TEST_CASE(
    "conditions in the words of path files have an index, and a limiting variable where control is "
    "lost") {
  const Workplace here;
  const std::string asked =
      " --conditions 'q_kPa = 1, axial_strain + 2*radial_strain = 0' "
      "--conditions 'axial_strain = 0.01, axial_strain + 2*radial_strain = 0'";
  const json d = document(here, kLoose + "--p-kPa 70 --eta 0.65" + asked);
  const json& conditions = d["control"]["conditions"];
  REQUIRE(conditions.size() == 2);
  CHECK(conditions[0]["controllable"] == false);
  CHECK(conditions[0]["limiting_variable"] == "q_kPa");
  CHECK(conditions[0]["index"].is_null());
  CHECK(conditions[1]["controllable"] == true);
  CHECK(conditions[1]["index"].get<double>() > 0);
  CHECK(here.triax(kLoose + "--p-kPa 70 --eta 0.65" + asked).out.find("q_kPa cannot be held") !=
        std::string::npos);
}

#ifdef TRIAX_UMAT_FIXTURE
TEST_CASE("a UMAT that crashes answers nothing: its words, no lost control, and status 1") {
  const Workplace here;
  const auto probe = [&](const char* misbehaviour) {
    std::string set =
        "law = \"umat\"\n[sets.cone]\numat = \"" TRIAX_UMAT_FIXTURE
        "\"\nstate_variables = 12\nvoid_ratio_index = 1\nproperties = [20e3, 12e3, 1.2, 0.3, 5, ";
    set += misbehaviour;
    set += "]\n";
    write(here / "cone.toml", set);
    return here.triax(
        "probe --materials cone.toml --material umat/cone --void-ratio 0.8 --p-kPa 100 --eta 0.3 "
        "--step 30 --json");
  };
  const Outcome sound = probe("0");
  CHECK(sound.status == 0);
  CHECK(json::parse(sound.out)["refusal"].is_null());
  const Outcome crash = probe("1");
  INFO(crash.err);
  CHECK(crash.status == 1);
  CHECK(crash.err.find("SIGSEGV") != std::string::npos);
  const json d = json::parse(crash.out);
  CHECK(d["control"]["lost"].empty());
  CHECK(d["refused_directions"] == d["unanswered_directions"]);
  CHECK(d["refusal"].get<std::string>().find("SIGSEGV") != std::string::npos);
  CHECK_FALSE(d["warnings"].empty());
}
#endif

TEST_CASE("a sphere of directions too fine to be held is refused before it is begun") {
  const Workplace here;
  const std::string sphere =
      "probe --plane 3d --material inl2/S28-general --p-kPa 70 --eta 0.6 --void-ratio 1.086 "
      "--step ";
  for (const char* step : {"0.01", "0.25"}) {
    const Outcome refused = here.triax(sphere + step);
    CHECK(refused.status == 2);
    CHECK(refused.err.find("from 0.5 to 45") != std::string::npos);
  }
  CHECK(here.triax(sphere + "30").status == 0);
}
