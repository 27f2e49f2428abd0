// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says of itself: golden help texts, and man pages and completion that know every
// option.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;

namespace {

const char* const kCommands[] = {"simulate",  "replay",    "report", "query",  "tests",
                                 "element",   "materials", "probe",  "domain", "grains",
                                 "serve",     "run",       "record", "rig",    "open",
                                 "calibrate", "soil",      "export", "about"};

std::set<std::string> long_options(const std::string& text) {
  std::set<std::string> options;
  const std::regex pattern("--[a-z][a-zA-Z-]*");
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i)
    options.insert(i->str());
  return options;
}

std::string without_backslashes(std::string text) {
  std::erase(text, '\\');
  return text;
}

}  // namespace

TEST_CASE("help is what tests/cli/golden holds (tests/cli/refresh_golden.sh renews it)") {
  const Workplace here;
  CHECK(here.triax("--help").out == content("tests/cli/golden/help.txt"));
  for (const std::string command : kCommands) {
    const Outcome help = here.triax(command + " --help");
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK(help.out == content("tests/cli/golden/help_" + command + ".txt"));
  }
  CHECK(here.triax("query --list").out == content("tests/cli/golden/query_list.txt"));
}

TEST_CASE("every option of --help stands in the man page and in all completions") {
  const Workplace here;
  REQUIRE(here.triax("--write-manual manual").status == 0);
  const std::string bash = content(here / "manual/triax.bash");
  const std::string zsh = content(here / "manual/_triax");
  const std::string fish = content(here / "manual/triax.fish");
  for (const std::string command : kCommands) {
    const std::string page =
        without_backslashes(content(here / ("manual/triax-" + command + ".1")));
    const std::string help = here.triax(command + " --help").out;
    for (const std::string& option : long_options(help.substr(0, help.find("Examples:")))) {
      INFO(command << " " << option);
      CHECK(page.find(option) != std::string::npos);
      CHECK(bash.find(option) != std::string::npos);
      CHECK(zsh.find("'" + option + "[") != std::string::npos);
      CHECK(fish.find("-l " + option.substr(2)) != std::string::npos);
    }
    for (const char* section :
         {".SH SYNOPSIS", ".SH OPTIONS", ".SH EXIT STATUS", ".SH DIAGNOSTICS", ".SH EXAMPLES"})
      CHECK(page.find(section) != std::string::npos);
  }
}

TEST_CASE("triax run, record: help and man page list their exit statuses", "[cli][wire]") {
  const Workplace here;
  REQUIRE(here.triax("--write-manual manual").status == 0);
  for (const std::string command : {"run", "record"}) {
    const std::string page = content(here / ("manual/triax-" + command + ".1"));
    const std::string help = here.triax(command + " --help").out;
    for (const std::string status : {"3", "4"}) {
      CHECK(page.find(".TP\n" + status + "\n") != std::string::npos);
      CHECK(help.find("\n  " + status + "  ") != std::string::npos);
    }
  }
}

TEST_CASE("shells and groff accept what is written for them") {
  const Workplace here;
  REQUIRE(here.triax("--write-manual manual").status == 0);
  CHECK(std::system(("bash -n '" + (here / "manual/triax.bash").string() + "'").c_str()) == 0);
  if (std::system("command -v groff >/dev/null") != 0) {
    WARN("groff is not here: skipped");
    return;
  }
  for (const std::string command : kCommands) {
    const auto page = (here / ("manual/triax-" + command + ".1")).string();
    REQUIRE(std::system(
                ("groff -man -ww -Tutf8 '" + page + "' 2>'" + page + ".err' >/dev/null").c_str()) ==
            0);
    CHECK(content(page + ".err").empty());
  }
}

TEST_CASE("a wrong command line is told in our words, with the nearest right one") {
  struct Wrong {
    const char *arguments, *says;
  };
  const Workplace here;
  for (const Wrong& wrong :
       {Wrong{"", "missing command; must be one of: simulate, replay"},
        Wrong{"simluate p.toml", "unknown command 'simluate'; did you mean 'simulate'?"},
        Wrong{"simulate", "missing PROGRAMME.toml ("},
        Wrong{"simulate p.toml --sede 3", "unknown option --sede; did you mean --seed?"},
        Wrong{"simulate p.toml --seed", "--seed: expected one value, --seed N"},
        Wrong{"simulate p.toml q.toml", "unexpected argument 'q.toml'"},
        Wrong{"simulate p.toml --jobs 0", "--jobs: '0' is out of range; expected 1 to 1024"},
        Wrong{"serve r.toml --speed 0.001",
              "--speed: '0.001' is out of range; expected 0.01 to 10000"},
        Wrong{"simulate p.toml --jobs x", "--jobs: 'x' is not valid; expected --jobs N"},
        Wrong{"report --format docx",
              "--format: 'docx' is not valid; must be one of: text, json, html, pdf"},
        Wrong{"report --format pfd", "did you mean 'pdf'?"},
        Wrong{"report --format pdf --json", "--json: excludes --format pdf"},
        Wrong{"rig chek rig.toml", "ACTION: 'chek' is not valid; must be one of: check"},
        Wrong{"tests shwo 3", "ACTION: 'shwo' is not valid; did you mean 'show'?"},
        Wrong{"probe --norm-kPa x", "--norm-kPa: 'x' is not valid; expected --norm-kPa KPA"}}) {
    const Outcome outcome = here.triax(wrong.arguments);
    INFO(wrong.arguments << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(wrong.says) != std::string::npos);
    CHECK(outcome.err.find("--help") != std::string::npos);
  }
}

TEST_CASE("options that were renamed still go by their old names") {
  const Workplace here;
  const std::string state = "probe --material inl2/S28-general --void-ratio 1.086 ";
  CHECK(here.triax(state + "--p 70 --eta 0.5").out ==
        here.triax(state + "--p-kPa 70 --eta 0.5").out);
  CHECK(here.triax(state + "--p 70 --q=35").out == here.triax(state + "--p-kPa 70 --q-kPa 35").out);
  CHECK(here.triax("domain --threads 0").err.find("--jobs: '0' is out of range") !=
        std::string::npos);
}

TEST_CASE("completion offers materials, queries and the tests of a database, and never complains") {
  const Workplace here;
  CHECK(here.triax("--complete materials").out.find("inl2/S28-general\n") != std::string::npos);
  CHECK(here.triax("--complete queries").out.find("collapse_points\n") != std::string::npos);
  const Outcome none = here.triax("--complete tests none.db");
  CHECK(none.status == 0);
  CHECK(none.out.empty());
  CHECK(none.err.empty());
  write(here / "CSU 26.csv",
        "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n");
  REQUIRE(here.triax("replay 'CSU 26.csv' --db a.db").status == 0);
  CHECK(here.triax("--complete tests a.db").out == "CSU_26\n");
  CHECK(here.triax("--complete ids a.db").out == "1\n");
  REQUIRE(here.triax("--write-manual manual").status == 0);
  const std::string completion =
      "cd '" + (here / "").string() + "' && bash -c 'source manual/triax.bash; COMP_WORDS=(" +
      TRIAX_PROGRAM " report --db a.db CS); COMP_CWORD=4; _triax; echo $COMPREPLY' >got";
  CHECK(std::system(completion.c_str()) == 0);
  CHECK(content(here / "got") == "CSU_26\n");
}

TEST_CASE("bash completion: keeps words with hyphens whole and evaluates no name", "[cli]") {
  const Workplace here;
  REQUIRE(here.triax("--write-manual manual").status == 0);
  write(here / "csd-58.csv",
        "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n");
  REQUIRE(here.triax("replay csd-58.csv --db a.db").status == 0);
  REQUIRE(here.triax("tests rename 1 'csd-58$(>evaluated)' --db a.db").status == 0);
  const auto completed = [&](const std::string& words, int index) {
    const std::string script = "source manual/triax.bash; COMP_WORDS=(" TRIAX_PROGRAM " " + words +
                               "); COMP_CWORD=" + std::to_string(index) +
                               "; _triax; printf '%s\\n' \"${COMPREPLY[@]}\"";
    write(here / "complete.bash", script);
    REQUIRE(std::system(("cd '" + (here / "").string() + "' && bash complete.bash >got").c_str()) ==
            0);
    return content(here / "got");
  };
  CHECK(completed("report --db a.db csd-5", 4) == "csd-58$(>evaluated)\n");
  CHECK_FALSE(std::filesystem::exists(here / "evaluated"));
  CHECK(completed("run --dry-r", 2) == "\n");
  CHECK(completed("domain --void-r", 2) == "--void-ratio\n");
  CHECK(completed("domain --plane plane-", 3) == "plane-strain\n");
  CHECK(completed("domain --plane = plane-", 4) == "plane-strain\n");
  CHECK(completed("probe --plane 3", 3) == "3d\n");
  CHECK(completed("soil --criterion =", 3) == "peak-q\npeak-ratio\nstrain\ncritical-state\n");
}

TEST_CASE("help: shows placeholders and defaults, no types of the option parser", "[cli]") {
  const Workplace here;
  for (const std::string command : kCommands) {
    const std::string help = here.triax(command + " --help").out;
    INFO(command);
    for (const char* parser_text : {"FLOAT", "INT", "POSITIVE", "Excludes", "=triax.db", "{"})
      CHECK(help.substr(0, help.find("Examples:")).find(parser_text) == std::string::npos);
  }
}

TEST_CASE("wrong usage is one line and status 2") {
  const Workplace here;
  for (const char* arguments :
       {"", "fly", "replay", "simulate", "report --format docx", "query --format x",
        "replay a.csv --speed fast", "replay a.csv --speed -1", "replay a.csv --membrane thick",
        "simulate a.toml --seed minus"}) {
    const Outcome outcome = here.triax(arguments);
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    const std::string last =
        outcome.err.substr(outcome.err.rfind('\n', outcome.err.size() - 2) + 1);
    CHECK(last.rfind("triax: ", 0) == 0);
  }
  CHECK(here.triax("--version").out == "triax " TRIAX_VERSION "\n");
}
