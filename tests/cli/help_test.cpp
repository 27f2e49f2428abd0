// What the program says of itself: golden help texts, and man pages and completion that know every
// option.
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;

namespace {

const char* const kCommands[] = {"simulate",  "replay", "report", "query", "element",
                                 "materials", "probe",  "domain", "grains"};

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
