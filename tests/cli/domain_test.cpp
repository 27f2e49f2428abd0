// SPDX-License-Identifier: GPL-3.0-or-later
// triax domain: the same whatever the number of threads or pieces, and what it refuses.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kSmallDomain =
    "domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 20:200/7 --q-kPa -120:240/19 "
    "--directions 36 ";

#ifdef TRIAX_UMAT_FIXTURE
/// A parameter file of this library; `misbehaviour` as umat_fixture.f90 numbers it.
std::string cone(const std::string& library, int misbehaviour = 0) {
  std::ostringstream text;
  text << "law = \"umat\"\n[sets.cone]\numat = \"" << library
       << "\"\nstate_variables = 12\nvoid_ratio_index = 1\nproperties = [20e3, 12e3, 1.2, 0.3, 5, "
       << misbehaviour << "]\n";
  return text.str();
}
#endif

}  // namespace

TEST_CASE("the sample domain prints what tests/cli/golden holds") {
  const Workplace here;
  const Outcome outcome = here.triax(
      "domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 20:200/7 --q-kPa -120:240/19");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out == content("tests/cli/golden/domain_inl2.txt"));
}

TEST_CASE("domain as JSON: origin, material, boundaries in their order, states") {
  const Workplace here;
  const Outcome outcome = here.triax(kSmallDomain + "--json");
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
      here.triax("domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 70:71/2 --q-kPa "
                 "0:60/31 --json")
          .out);
  const double eta = at_70["boundaries"][0]["first_unstable"]["eta"];
  CHECK(eta > 0.55);
  CHECK(eta < 0.60);
}

TEST_CASE("neither threads nor pieces show in a byte of what is written") {
  const Workplace here;
  CHECK(here.triax(kSmallDomain + "--jobs 1 --output whole").status == 0);
  CHECK(here.triax(kSmallDomain + "--jobs 3 --output threads").status == 0);
  for (const std::string piece : {"1", "2", "3"}) {
    const Outcome outcome =
        here.triax(kSmallDomain + "--piece " + piece + "/3 --output piece" + piece + ".json");
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
  }
  const Outcome merged =
      here.triax("domain --merge piece3.json piece1.json piece2.json --output m");
  CHECK(merged.status == 0);
  CHECK(merged.out == here.triax(kSmallDomain).out);
  const auto file = [&](const char* folder, const char* ending) {
    return content(here / (std::string(folder) + "/domain" + ending));
  };
  for (const char* ending : {".csv", "_boundaries.csv", ".json", ".svg", ".png", ".pdf"}) {
    INFO(ending);
    CHECK_FALSE(file("whole", ending).empty());
    CHECK((file("threads", ending) == file("whole", ending)));
    CHECK((file("m", ending) == file("whole", ending)));
  }
  // --merge --json prints the same document as a file holds.
  CHECK((here.triax("domain --merge piece1.json piece2.json piece3.json --json").out ==
         content(here / "whole/domain.json")));
}

TEST_CASE("pieces that do not belong together are one line and status 2") {
  const Workplace here;
  for (const std::string piece : {"1", "2"})
    CHECK(here.triax(kSmallDomain + "--piece " + piece + "/2 --output " + piece + ".json").status ==
          0);
  CHECK(here.triax(kSmallDomain + "--set hardening_factor=2.5 --piece 2/2 --output other.json")
            .status == 0);
  write(here / "cut.json", content(here / "2.json").substr(0, 3000));
  write(here / "foreign.json", "{\"type\": \"FeatureCollection\"}");
  std::string digit = content(here / "2.json");
  std::smatch least;
  REQUIRE(std::regex_search(digit, least, std::regex("\"w2_normalised_least\": ?-?[0-9]\\.")));
  char& changed = digit[static_cast<std::size_t>(least.position() + least.length())];
  changed = changed == '1' ? '2' : '1';
  write(here / "digit.json", digit);
  struct Bad {
    const char *arguments, *says;
  };
  for (const Bad& bad :
       {Bad{"--merge 1.json", "piece 2 of 2 is missing"},
        Bad{"--merge 1.json 2.json 1.json", "1.json: is piece 1 of 2, like 1.json"},
        Bad{"--merge 1.json other.json", "other.json: is a piece of another domain: material name"},
        Bad{"--merge 1.json cut.json", "cut.json: is not a complete JSON document"},
        Bad{"--merge 1.json foreign.json", "foreign.json: is not a piece of a domain"},
        Bad{"--merge 1.json gone.json", "gone.json: file does not exist"},
        Bad{"--merge 1.json digit.json", "digit.json: was changed since it was written"},
        Bad{"--merge 1.json 2.json --void-ratio 1", "--void-ratio cannot be used with --merge"},
        Bad{"--merge 1.json 2.json --plane plane-strain", "--plane cannot be used with --merge"},
        Bad{"--merge 1.json 2.json --set hardening_factor=2", "--set cannot be used with --merge"},
        Bad{"--merge 1.json 2.json --directions 8", "--directions cannot be used with --merge"},
        Bad{"--merge 1.json 2.json --materials 1.json", "--materials cannot be used with --merge"},
        Bad{"--merge 1.json 2.json --localisation", "--localisation cannot be used with --merge"},
        Bad{"--merge 1.json 2.json --jobs 2", "--jobs cannot be used with --merge"},
        Bad{"--merge 1.json 2.json --piece 1/2", "--piece cannot be used with --merge"},
        Bad{"--merge m/domain.json --output m", "would be overwritten"}}) {
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
       {Bad{"", "missing --material LAW/SET"},
        Bad{"--material inl2/S29",
            "unknown material 'inl2/S29'; must be one of: elastic/linear, elastic/Hostun-loose, "
            "mohr_coulomb/"},
        Bad{"--material inl2/S28-genral",
            "unknown material 'inl2/S28-genral'; did you mean 'inl2/S28-general'?"},
        Bad{inl2, "missing --void-ratio E"},
        Bad{inl2 + "--void-ratio 99", "--void-ratio 99"},
        Bad{sand + "--p-kPa 10", "expected FROM:TO:STEP or FROM:TO/COUNT"},
        Bad{sand + "--p-kPa 10:x:3", "expected FROM:TO:STEP or FROM:TO/COUNT"},
        Bad{sand + "--p-kPa 10:nan/3", "expected FROM:TO:STEP or FROM:TO/COUNT"},
        Bad{sand + "--p-kPa 20:200:7", "for 7 values write 20:200/7"},
        Bad{sand + "--p-kPa 300:10/3", "must increase"},
        Bad{sand + "--p-kPa 0:10/3", "p' from 0"},
        Bad{sand + "--q-kPa 5:5/3", "must increase"},
        Bad{sand + "--q-kPa 0:100/99999", "states"},
        Bad{sand + "--directions 4", "4 directions"},
        Bad{sand + "--jobs 0", "--jobs"},
        Bad{sand + "--plane oblique", "--plane"},
        Bad{sand + "--piece 3/2 --output x", "I/N"},
        Bad{sand + "--piece 1 --output x", "I/N"},
        Bad{sand + "--piece 1/2", "--piece needs --output"},
        Bad{sand + "--piece 1/2 --output x --json", "--piece excludes --json"},
        Bad{"--material norsand/S28-MT --void-ratio 1 --localisation",
            "--localisation needs the full tensor"},
        Bad{sand + "--p-kPa 10:20/2 --piece 1/3 --output x", "only 2 columns"},
        Bad{sand + "--set hardening=1", "unknown parameter"},
        Bad{"--material norsand/S28-MT-drained --void-ratio 1 --plane plane-strain",
            "norsand/S28-MT-drained is not formulated for it: the law and its parameters"}}) {
    const Workplace here;
    const Outcome outcome = here.triax("domain " + bad.arguments);
    INFO(bad.arguments << "\n" << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(bad.says) != std::string::npos);
    CHECK_FALSE(here.has("x"));
  }
}

TEST_CASE("what is read is not overwritten, by a domain or by a piece of one") {
  const Workplace here;
  const std::string set = content("lab/materials/elastic.toml");
  REQUIRE_FALSE(set.empty());
  const std::string small =
      " --material elastic/Hostun-loose --void-ratio 1 --p-kPa 50:100/2 --q-kPa 0:50/3 "
      "--directions 8 ";
  for (const std::string arguments :
       {"--materials y/domain.json --output y", "--materials w.toml --piece 1/2 --output w.toml",
        "--materials z/domain_cones_pq.csv --output ./z/"}) {
    for (const char* folder : {"y", "z"}) std::filesystem::create_directories(here / folder);
    for (const char* file : {"y/domain.json", "w.toml", "z/domain_cones_pq.csv"})
      write(here / file, set);
    const Outcome outcome = here.triax("domain" + small + arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("would be overwritten") != std::string::npos);
    for (const char* file : {"y/domain.json", "w.toml", "z/domain_cones_pq.csv"})
      CHECK(content(here / file) == set);
    CHECK_FALSE(here.has("y/domain.csv"));
  }
}

TEST_CASE("targets that cannot be written are found before anything is computed or written") {
  const Workplace here;
  for (const char* taken : {"x/domain.pdf", "x/probe.pdf"})
    std::filesystem::create_directories(here / taken);
  write(here / "file", "");
  // So large that computing it would not end within a test.
  const std::string large =
      " --material inl2/S28-general --void-ratio 1.086 --p-kPa 10:800/1000 --q-kPa 0:900/4000 ";
  const std::string state = " --material inl2/S28-general --void-ratio 1.086 --p-kPa 70 --eta 0.5 ";
  for (const auto& [name, rest] : {std::pair<std::string, std::string>{"domain", large},
                                   std::pair<std::string, std::string>{"probe", state}}) {
    const Outcome folder = here.triax(name + rest + "--output x");
    INFO(folder.err);
    CHECK(folder.status == 2);
    CHECK(folder.err.find("x/" + name + ".pdf is a folder") != std::string::npos);
    CHECK_FALSE(here.has("x/" + name + ".csv"));
    CHECK_FALSE(here.has("x/" + name + ".json"));
    for (const char* within : {"file", "file/deep/down"}) {
      const Outcome no_folder = here.triax(name + rest + "--output " + within);
      INFO(no_folder.err);
      CHECK(no_folder.status == 2);
      CHECK(no_folder.err.find("is a file; expected a folder") != std::string::npos);
    }
  }
}

TEST_CASE("a domain of which the law answers no state is no result") {
  const Workplace here;
  const Outcome outcome = here.triax(
      "domain --material inl2/S28-general --void-ratio 5 --p-kPa 100:200/2 --q-kPa 0:200/5 "
      "--directions 8 --output x");
  CHECK(outcome.status == 1);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find("gives no result at any state of the grid") != std::string::npos);
  CHECK(outcome.err.find("the void ratio is 5") != std::string::npos);
  CHECK_FALSE(here.has("x"));
}

TEST_CASE(
    "pieces in plane strain with localisation are the run in one go; cones of tests are not "
    "for them") {
  const Workplace here;
  const std::string small =
      "domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 50:150/3 --q-kPa 0:120/7 "
      "--directions 16 --plane plane-strain --localisation ";
  CHECK(here.triax(small + "--output whole").status == 0);
  for (const std::string piece : {"1", "2"})
    CHECK(here.triax(small + "--piece " + piece + "/2 --output " + piece + ".json").status == 0);
  const Outcome merged = here.triax("domain --merge 1.json 2.json --output m");
  CHECK(merged.status == 0);
  CHECK(merged.out.find("η localisation") != std::string::npos);
  CHECK(merged.out.find("plane strain") != std::string::npos);
  for (const char* ending : {".csv", "_boundaries.csv", ".json"})
    CHECK((content(here / (std::string("m/domain") + ending)) ==
           content(here / (std::string("whole/domain") + ending))));
  REQUIRE(here.triax("simulate " + source("samples/programmes/icu_6.toml")).status == 0);
  const Outcome test = here.triax("domain --merge 1.json 2.json --test 1 --output t");
  CHECK(test.status == 2);
  CHECK(test.err.find("the pieces of --merge are of plane-strain") != std::string::npos);
  CHECK_FALSE(here.has("t"));
}

TEST_CASE("a run that is killed on the way leaves nothing") {
  const Workplace here;
  const std::string large =
      " domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 10:800/400 --q-kPa "
      "0:900/1000 ";
  for (const std::string last : {"--output x", "--piece 1/2 --output x.json"}) {
    const std::string command = "cd '" + (here / ".").string() + "' && { " TRIAX_PROGRAM + large +
                                last + " >/dev/null 2>&1 & sleep 1; kill -9 $!; wait $!; }";
    const int status = std::system(command.c_str());
    CHECK(WEXITSTATUS(status) == 128 + 9);
    CHECK(std::filesystem::is_empty(here / "."));
  }
}

#ifdef TRIAX_UMAT_FIXTURE
TEST_CASE("a UMAT has a domain too, in a worker process for every thread") {
  const Workplace here;
  write(here / "cone.toml", cone(TRIAX_UMAT_FIXTURE));
  const std::string domain =
      "domain --materials cone.toml --material umat/cone --void-ratio 0.8 --p-kPa 80:120/3 "
      "--q-kPa 0:60/3 --directions 8 --json --jobs ";
  const Outcome one = here.triax(domain + "1");
  INFO(one.err);
  REQUIRE(one.status == 0);
  CHECK((here.triax(domain + "3").out == one.out));
  const json document = json::parse(one.out);
  for (const auto& state : document["states"]) CHECK(state["kind"] == "stable");
}

TEST_CASE("a UMAT that misbehaves everywhere is status 1 with its words, and nothing is written") {
  // A null pointer, STOP, a stress and a state that are no numbers.
  for (const int misbehaviour : {1, 2, 4, 10}) {
    const Workplace here;
    write(here / "cone.toml", cone(TRIAX_UMAT_FIXTURE, misbehaviour));
    const Outcome outcome = here.triax(
        "domain --materials cone.toml --material umat/cone --void-ratio 0.8 --p-kPa 80:120/2 "
        "--q-kPa 0:60/2 --directions 8 --output x");
    INFO(misbehaviour << ": " << outcome.err);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.err.find("gives no result at any state of the grid") != std::string::npos);
    CHECK_FALSE(here.has("x"));
  }
}

TEST_CASE("a UMAT that crashes at some states of a domain, or in a test, is told with status 1") {
  const Workplace here;
  write(here / "cone.toml", cone(TRIAX_UMAT_FIXTURE, 48));
  const Outcome domain = here.triax(
      "domain --materials cone.toml --material umat/cone --void-ratio 0.8 --p-kPa 80:120/3 "
      "--q-kPa 0:60/3 --directions 72 --jobs 1");
  INFO(domain.err);
  CHECK(domain.status == 1);
  CHECK(domain.out.find("stable") != std::string::npos);
  CHECK(domain.err.find("SIGSEGV") != std::string::npos);

  std::string programme = content(source("samples/programmes/icu_6.toml"));
  const std::string material = "material = \"inl2/S28-general\"";
  programme.replace(programme.find(material), material.size(),
                    "material = \"umat/cone\"\nmaterial_file = \"cone.toml\"");
  write(here / "icu.toml", programme);
  const Outcome sweep = here.triax("simulate icu.toml --sweep seed=1,2");
  INFO(sweep.err);
  CHECK(sweep.status == 1);
  CHECK(sweep.out.find("2 tests") != std::string::npos);
  CHECK(sweep.err.find("SIGSEGV") != std::string::npos);
  CHECK(sweep.err.find("UMAT calls failed") != std::string::npos);
}

TEST_CASE("pieces of UMAT libraries that differ do not merge") {
  const Workplace here;
  write(here / "cone.toml", cone("own.so"));
  const auto piece = [&](const char* index) {
    return here.triax(std::string("domain --materials cone.toml --material umat/cone --void-ratio "
                                  "0.8 --p-kPa 80:120/2 --q-kPa 0:60/2 --directions 8 --piece ") +
                      index + "/2 --output " + index + ".json");
  };
  std::filesystem::copy_file(TRIAX_UMAT_FIXTURE, here / "own.so");
  CHECK(piece("1").status == 0);
  // Bytes behind its end do not change what a library does; its digest they do.
  write(here / "own.so", content(here / "own.so") + "x");
  CHECK(piece("2").status == 0);
  const Outcome merged = here.triax("domain --merge 1.json 2.json");
  CHECK(merged.status == 2);
  CHECK(merged.err.find("material files") != std::string::npos);
  CHECK(piece("1").status == 0);
  CHECK(here.triax("domain --merge 1.json 2.json").status == 0);
  // No column for a criterion that a law without tangents has not.
  CHECK(here.triax("domain --merge 1.json 2.json").out.find("determinant") == std::string::npos);
  // The library is not overwritten either.
  CHECK(here.triax("domain --materials cone.toml --material umat/cone --void-ratio 0.8 --piece 1/1 "
                   "--output own.so")
            .status == 2);
}
#endif
