// SPDX-License-Identifier: GPL-3.0-or-later
// triax element and triax materials: what they print, and how they end.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kIcuPath = source("samples/paths/icu_100.toml");
const std::string kBeyond = source("samples/paths/load_beyond_limit.toml");

const std::string kSmallPath = R"([path]
name = "small"
material = "sanisand/S28-general"
[start]
p_eff_kPa = 100.0
void_ratio = 1.0
[[segments]]
name = "compression"
drainage = "drained"
rows = 5
conditions = ["axial_strain = 0.01", "radial_stress_kPa = 0"]
)";

std::string with(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

bool holds_number(const json& object, const std::string& key) {
  return object.contains(key) && object[key].is_number();
}

}  // namespace

TEST_CASE("the two samples print what tests/cli/golden holds") {
  const Workplace here;
  for (const std::string name : {"icu_100", "load_beyond_limit"}) {
    const Outcome outcome = here.triax("element " + source("samples/paths/" + name + ".toml"));
    CHECK(outcome.status == (name == "icu_100" ? 0 : 1));
    CHECK(outcome.out == content("tests/cli/golden/element_" + name + ".txt"));
    CHECK(outcome.err == content("tests/cli/golden/element_" + name + ".err"));
  }
}

TEST_CASE("undrained compression as JSON: peak, events, rows") {
  const Workplace here;
  const Outcome outcome = here.triax("element " + kIcuPath + " --set void_ratio=1.086 --json");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const json d = json::parse(outcome.out);
  CHECK(d["outcome"] == "accepted");
  CHECK(d["limiting_variable"].is_null());
  CHECK(d["message"].is_null());
  CHECK(d["path"]["origin"] == "simulated");
  for (const char* key : {"name", "law", "source", "range"}) CHECK(d["material"][key].is_string());
  for (const char* key : {"axial_strain", "q_kPa", "p_eff_kPa", "eta"})
    CHECK(holds_number(d["peak"], key));
  CHECK(d["start"]["p_eff_kPa"] == 100.0);
  CHECK(d["rows"].size() == 201);
  CHECK(d["rows"][200]["axial_strain"].get<double>() == Approx(0.1));
  REQUIRE(d["events"].size() == 2);
  std::set<std::string> kinds;
  for (const auto& event : d["events"]) {
    kinds.insert(event["kind"].get<std::string>());
    CHECK(event["at"]["q_kPa"].get<double>() == Approx(d["peak"]["q_kPa"].get<double>()));
  }
  CHECK(kinds == std::set<std::string>{"peak", "second_order_work"});
  CHECK(outcome.out.find(": nan") == std::string::npos);
  // Another void ratio is another result.
  const json denser =
      json::parse(here.triax("element " + kIcuPath + " --set void_ratio=0.9 --json").out);
  CHECK(denser["peak"]["q_kPa"].get<double>() > d["peak"]["q_kPa"].get<double>());
}

TEST_CASE("a load beyond the limit: status 1, the limiting variable, and the failure as a file") {
  const Workplace here;
  const Outcome outcome =
      here.triax("element " + kBeyond + " --json --save-failure step.toml --output rows.csv");
  CHECK(outcome.status == 1);
  CHECK(outcome.err.rfind("triax: wrote step.toml and rows.csv\ntriax: control of q_kPa is lost",
                          0) == 0);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 2);
  const json d = json::parse(outcome.out);
  CHECK(d["outcome"] == "lost_control");
  CHECK(d["limiting_variable"] == "q_kPa");
  CHECK(d["last"]["eta"].get<double>() < 1);
  CHECK(d["events"].back()["kind"] == "control_limit");
  const std::string csv = content(here / "rows.csv");
  CHECK(csv.find("origin = \"simulated\"") != std::string::npos);
  CHECK(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) == d["rows"].size() + 5);

  const Outcome again = here.triax("element step.toml --json");
  CHECK(again.status == 1);
  const json e = json::parse(again.out);
  CHECK(e["limiting_variable"] == "q_kPa");
  CHECK(e["last"]["q_kPa"].get<double>() == Approx(d["last"]["q_kPa"].get<double>()).epsilon(1e-9));

  CHECK(here.triax("element " + kIcuPath + " --save-failure none.toml").status == 0);
  CHECK_FALSE(here.has("none.toml"));
  CHECK(here.triax("element " + kBeyond + " --save-failure no/where.toml").status == 2);
}

TEST_CASE("bad paths and settings are one line and status 2, and nothing is printed") {
  struct Bad {
    std::string text, arguments, says;
  };
  const Bad all[] = {
      {"", "", "[path] is missing"},
      {"\x01\x02\xff", "", "invalid TOML"},
      {with(kSmallPath, "p_eff_kPa = 100.0", ""), "", "effective stress is missing"},
      {with(kSmallPath, "axial_strain", "axial_strian"), "", "did you mean 'axial_strain'?"},
      {with(kSmallPath, "radial_stress_kPa", "radial_stress_MPa"), "", "column 1"},
      {with(kSmallPath, "radial_stress_kPa = 0", "axial_strain = 0"), "", "axial_strain"},
      {with(kSmallPath, "radial_stress_kPa = 0", "2 axial_strain = 0.02"), "", "2 axial_strain"},
      {with(kSmallPath, "= 0.01", "= 1e99"), "",
       "the total 1e+99 is out of range (a strain of 2, a stress of 100000 kPa)"},
      {with(kSmallPath, "void_ratio = 1.0", "void_ratio = 19"), "", "out of range for"},
      {with(kSmallPath, "rows = 5", "table = \"gone.csv\""), "", "give either table or conditions"},
      {with(kSmallPath, "sanisand/", "sandy/"), "", "unknown material"},
      {kSmallPath, "--set void_ratio", "expected KEY=VALUE"},
      {kSmallPath, "--set viod_ratio=1", "did you mean 'void_ratio'?"},
      {kSmallPath, "--set poisson_ratio=2", "poisson_ratio"},
      {kSmallPath, "--set material=none/x", "unknown material"},
      {kSmallPath, "--output p.toml", "p.toml"},
      {kSmallPath, "--save-failure x.csv --output x.csv", "x.csv"},
  };
  for (const Bad& bad : all) {
    const Workplace here;
    write(here / "p.toml", bad.text);
    const Outcome outcome = here.triax("element p.toml " + bad.arguments);
    INFO(bad.says << "\n" << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.err.find(bad.says) != std::string::npos);
    CHECK_FALSE(here.has("x.csv"));
  }
  const Workplace here;
  CHECK(here.triax("element gone.toml").status == 2);
  CHECK(here.triax("element .").status == 2);
}

TEST_CASE("every sample path ends as it says") {
  const Workplace here;
  for (const char* name :
       {"csd_100", "cyclic", "drained_100", "from_table", "simple_shear", "strain_path_R"}) {
    const Outcome outcome =
        here.triax("element " + source(std::string("samples/paths/") + name + ".toml") + " --json");
    INFO(name << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(json::parse(outcome.out)["outcome"] == "accepted");
  }
}

TEST_CASE("materials: laws with their sets, a set with its parameters") {
  const Workplace here;
  const json laws = json::parse(here.triax("materials --json").out);
  bool found = false;
  for (const auto& law : laws)
    for (const auto& set : law["sets"]) {
      const std::string name = set["name"];
      CHECK(name.rfind(law["name"].get<std::string>() + "/", 0) == 0);
      found = found || name == "sanisand/S28-general";
      const json one = json::parse(here.triax("materials " + name + " --json").out);
      for (const auto& parameter : one["parameters"]) {
        INFO(name << " " << parameter["key"]);
        CHECK_FALSE(parameter["meaning"].get<std::string>().empty());
        CHECK(parameter.contains("value"));
      }
    }
  CHECK(found);
  const std::string text = here.triax("materials sanisand/S28-general").out;
  for (const char* part : {"hardening_factor", "h0", "1.224", "above 0", "kPa", "range", "source"})
    CHECK(text.find(part) != std::string::npos);
  CHECK(here.triax("materials").out.find("sanisand/Toyoura-DM04") != std::string::npos);
  CHECK(here.triax("materials sanisand").out.find("1.224") == std::string::npos);
  CHECK(json::parse(here.triax("materials sanisand --json").out)["name"] == "sanisand");

  const Outcome unknown = here.triax("materials sanisand/S28-genral");
  CHECK(unknown.status == 2);
  CHECK(unknown.err.find("did you mean 'sanisand/S28-general'?") != std::string::npos);
  write(here / "mine.toml", "law = \"sanisand\"\n[sets.a]\n");
  CHECK(here.triax("materials --materials mine.toml").status == 2);
  CHECK(here.triax("materials --materials " + source("lab/materials/sanisand.toml") +
                   " sanisand/Toyoura-DM04")
            .status == 0);
}

TEST_CASE("a folder of incrementalDriver is run like a path") {
  const Workplace here;
  const std::string folder = source("samples/incremental_driver");
  const Outcome outcome = here.triax("element " + folder + " --json");
  CHECK(outcome.status == 0);
  const json d = json::parse(outcome.out);
  CHECK(d["outcome"] == "accepted");
  CHECK(d["path"]["name"] == "undrained, loaded and unloaded, then sheared");
  CHECK(d["rows"].back()["p_eff_kPa"].get<double>() == Approx(150).epsilon(1e-6));
  CHECK(here.triax("element " + folder + "/test.inp --set void_ratio=0.9").status == 0);

  const Outcome unknown =
      here.triax("element " + folder + " --set umat=libno_such_law.so --set void_ratio=0.8");
  CHECK(unknown.status == 2);
  CHECK(unknown.out.empty());
  CHECK(unknown.err.find("libno_such_law.so") != std::string::npos);
  CHECK(here.triax("element " + folder + " --set void_ratio=-1").status == 2);
  CHECK(here.triax("element " + folder + " --save-failure f.toml").status == 2);
}

#ifdef TRIAX_UMAT_FIXTURE
TEST_CASE("a crash of a UMAT is an error of the run, not of triax") {
  const Workplace here;
  const auto material = [&](int misbehaviour) {
    write(here / "cone.toml", "law = \"umat\"\n[sets.cone]\numat = \"" TRIAX_UMAT_FIXTURE
                              "\"\nstate_variables = 12\nvoid_ratio_index = 1\nproperties = [20e3, "
                              "12e3, 1.2, 0.3, 5, " +
                                  std::to_string(misbehaviour) + "]\n");
    write(here / "path.toml", with(with(kSmallPath, "sanisand/S28-general", "umat/cone"),
                                   "material =", "material_file = \"cone.toml\"\nmaterial ="));
    return here.triax("element path.toml --json");
  };
  const Outcome sound = material(0);
  CHECK(sound.status == 0);
  CHECK(json::parse(sound.out)["rows"].back()["q_kPa"].get<double>() ==
        Approx(3 * (1.2 * 100 + 5) / 1.8).epsilon(1e-6));
  const Outcome crash = material(1);
  CHECK(crash.status == 1);
  CHECK(crash.err.find("SIGSEGV") != std::string::npos);
  CHECK(json::parse(crash.out)["outcome"] == "failed");
  const Outcome chatter = material(13);
  CHECK(chatter.status == 0);
  CHECK(json::parse(chatter.out)["outcome"] == "accepted");
}
#endif

TEST_CASE("norsand is refused for constant q with falling p' before a row of it is made") {
  const Workplace here;
  const std::string csd = "element " + source("samples/paths/csd_100.toml") + " --json ";
  const auto refused = [&](const std::string& set, const std::string& segment) {
    const Outcome outcome = here.triax(csd + "--set material=" + set);
    CHECK(outcome.status == 1);
    const json d = json::parse(outcome.out);
    CHECK(d["outcome"] == "failed");
    CHECK(d["last"]["segment"] == segment);
    CHECK(d["last"]["progress"] == 0);
    return d["message"].get<std::string>();
  };
  // A set for undrained loading goes no step of the drained shear, and says which one would.
  CHECK(refused("norsand/S28-MT", "shear").find("S28-MT-drained") != std::string::npos);
  CHECK(refused("norsand/S28-MT-drained", "unloading at constant q").find("no instability line") !=
        std::string::npos);
}
