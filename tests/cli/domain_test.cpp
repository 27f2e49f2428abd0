// triax domain: the same whatever the number of threads or pieces, and what it refuses.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kSmall =
    "domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 20:200:7 --q-kPa -120:240:19 "
    "--directions 36 ";

}  // namespace

TEST_CASE("the sample domain prints what tests/cli/golden holds") {
  const Workplace here;
  const Outcome outcome = here.triax(
      "domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 20:200:7 --q-kPa -120:240:19");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out == content("tests/cli/golden/domain_inl2.txt"));
}

TEST_CASE("domain as JSON: origin, material, boundaries in their order, states") {
  const Workplace here;
  const Outcome outcome = here.triax(kSmall + "--json");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const json d = json::parse(outcome.out);
  CHECK(d["origin"] == "simulated");
  CHECK(d["material"]["name"] == "inl2/S28-general");
  CHECK(d["states"].size() == 7 * 19);
  for (const auto& boundary : d["boundaries"]) {
    const double sign = boundary["side"] == "extension" ? -1 : 1;
    const double first = sign * boundary["first_unstable"]["eta"].get<double>();
    CHECK(first > 0);
    CHECK(sign * boundary["isotropic_unloading"]["eta"].get<double>() > first);
    CHECK(sign * boundary["determinant"]["eta"].get<double>() == Approx(first).epsilon(1e-6));
  }
  // Where constitutive.md has INL2's first cone between η of 0.55 and 0.60.
  const json at_70 = json::parse(
      here.triax("domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 70:71:2 --q-kPa "
                 "0:60:31 --json")
          .out);
  const double eta = at_70["boundaries"][0]["first_unstable"]["eta"];
  CHECK(eta > 0.55);
  CHECK(eta < 0.60);
}

TEST_CASE("neither threads nor pieces show in a byte of what is written") {
  const Workplace here;
  CHECK(here.triax(kSmall + "--threads 1 --output whole").status == 0);
  CHECK(here.triax(kSmall + "--threads 3 --output threads").status == 0);
  for (const std::string piece : {"1", "2", "3"}) {
    const Outcome outcome =
        here.triax(kSmall + "--piece " + piece + "/3 --output piece" + piece + ".json");
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
  }
  const Outcome merged =
      here.triax("domain --merge piece3.json piece1.json piece2.json --output m");
  CHECK(merged.status == 0);
  CHECK(merged.out == here.triax(kSmall).out);
  const auto file = [&](const char* prefix, const char* ending) {
    return content(here / std::string(prefix).append(ending));
  };
  for (const char* ending : {".csv", "_boundaries.csv", ".json", ".svg", ".png", ".pdf"}) {
    INFO(ending);
    CHECK_FALSE(file("whole", ending).empty());
    CHECK((file("threads", ending) == file("whole", ending)));
    CHECK((file("m", ending) == file("whole", ending)));
  }
  // --merge --json prints the same document as a file holds.
  CHECK((here.triax("domain --merge piece1.json piece2.json piece3.json --json").out ==
         content(here / "whole.json")));
}

TEST_CASE("pieces that do not belong together are one line and status 2") {
  const Workplace here;
  for (const std::string piece : {"1", "2"})
    CHECK(here.triax(kSmall + "--piece " + piece + "/2 --output " + piece + ".json").status == 0);
  CHECK(here.triax(kSmall + "--set hardening_factor=2.5 --piece 2/2 --output other.json").status ==
        0);
  write(here / "cut.json", content(here / "2.json").substr(0, 3000));
  write(here / "foreign.json", "{\"type\": \"FeatureCollection\"}");
  struct Bad {
    const char *arguments, *says;
  };
  for (const Bad& bad :
       {Bad{"--merge 1.json", "piece 2 of 2 is missing"},
        Bad{"--merge 1.json 2.json 1.json", "1.json: is piece 1 of 2 as 1.json is"},
        Bad{"--merge 1.json other.json", "other.json: is a piece of another domain: material name"},
        Bad{"--merge 1.json cut.json", "cut.json: is no whole JSON document"},
        Bad{"--merge 1.json foreign.json", "foreign.json: is no piece of a domain"},
        Bad{"--merge 1.json gone.json", "gone.json: cannot be read"},
        Bad{"--merge 1.json 2.json --void-ratio 1", "--void-ratio and --merge"},
        Bad{"--merge m.json --output m", "would be overwritten"}}) {
    const Outcome outcome = here.triax(std::string("domain ") + bad.arguments);
    INFO(bad.says << "\n" << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.err.find(bad.says) != std::string::npos);
  }
}

TEST_CASE("settings that make no domain are one line and status 2, and nothing is written") {
  struct Bad {
    std::string arguments, says;
  };
  const std::string inl2 = "--material inl2/S28-general ", sand = inl2 + "--void-ratio 1 ";
  for (const Bad& bad :
       {Bad{"", "--material LAW/SET is missing"},
        Bad{"--material inl2/S29", "no material 'inl2/S29'; known:"},
        Bad{inl2, "--void-ratio E is missing"},
        Bad{inl2 + "--void-ratio 99", "--void-ratio 99"},
        Bad{sand + "--p-kPa 10", "FROM:TO:COUNT is wanted"},
        Bad{sand + "--p-kPa 10:x:3", "FROM:TO:COUNT is wanted"},
        Bad{sand + "--p-kPa 10:nan:3", "FROM:TO:COUNT is wanted"},
        Bad{sand + "--p-kPa 300:10:3", "must rise"},
        Bad{sand + "--p-kPa 0:10:3", "p' from 0"},
        Bad{sand + "--q-kPa 5:5:3", "must rise"},
        Bad{sand + "--q-kPa 0:100:99999", "states"},
        Bad{sand + "--directions 4", "4 directions"},
        Bad{sand + "--threads 0", "--threads"},
        Bad{sand + "--plane oblique", "--plane"},
        Bad{sand + "--piece 3/2 --output x", "I/N"},
        Bad{sand + "--piece 1 --output x", "I/N"},
        Bad{sand + "--piece 1/2", "--piece needs --output"},
        Bad{sand + "--p-kPa 10:20:2 --piece 1/3 --output x", "only 2 columns"},
        Bad{sand + "--set hardening=1", "has no parameter"},
        Bad{"--material norsand/S28-MT-drained --void-ratio 1 --plane plane-strain",
            "has no form for it"}}) {
    const Workplace here;
    const Outcome outcome = here.triax("domain " + bad.arguments);
    INFO(bad.arguments << "\n" << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(bad.says) != std::string::npos);
    CHECK_FALSE(here.has("x"));
  }
}

#ifdef TRIAX_UMAT_FIXTURE
TEST_CASE("a UMAT has a domain too, in a worker process for every thread") {
  const Workplace here;
  write(here / "cone.toml", "law = \"umat\"\n[sets.cone]\numat = \"" TRIAX_UMAT_FIXTURE
                            "\"\nstate_variables = 12\nvoid_ratio_index = 1\nproperties = [20e3, "
                            "12e3, 1.2, 0.3, 5, 0]\n");
  const std::string cone =
      "domain --materials cone.toml --material umat/cone --void-ratio 0.8 --p-kPa 80:120:3 "
      "--q-kPa 0:60:3 --directions 8 --json --threads ";
  const Outcome one = here.triax(cone + "1");
  INFO(one.err);
  REQUIRE(one.status == 0);
  CHECK((here.triax(cone + "3").out == one.out));
  for (const auto& state : json::parse(one.out)["states"]) CHECK(state["kind"] == "stable");
}
#endif
