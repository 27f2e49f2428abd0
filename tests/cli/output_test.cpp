// SPDX-License-Identifier: GPL-3.0-or-later
// Where results go when the way is blocked, and results that are awkward to print.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/running.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kRecord =
    "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n"
    "0.2,9,103\n";

/// A workplace whose database holds one tiny test.
struct Replayed : Workplace {
  Replayed() {
    write(*this / "tiny.csv", kRecord);
    REQUIRE(triax("replay tiny.csv").status == 0);
  }
  /// The status of a shell line in which $triax is the program and pipes tell of failures.
  int shell(const std::string& line) const {
    const std::string script =
        "cd '" + (*this / "").string() + "' && triax=" TRIAX_PROGRAM "; set -o pipefail; " + line;
    write(*this / "script.sh", script);
    const int status = std::system(("bash '" + (*this / "script.sh").string() + "'").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

}  // namespace

TEST_CASE("output that cannot be written is status 1 and one line, never a signal") {
  const Replayed here;
  for (const std::string command :
       {"report", "report --format json", "report --format pdf --output -", "query tests",
        "query tests --format csv", "query tests --format json", "query --list", "--help",
        "--version", "replay --help"}) {
    INFO(command);
    CHECK(here.shell("$triax " + command + " >/dev/full 2>err") == 1);
    CHECK(content(here / "err").rfind("triax: standard output cannot be written: ", 0) == 0);
    CHECK(here.shell("$triax " + command + " >/dev/full 2>/dev/full") == 1);
    CHECK(here.shell("$triax " + command + " >&- 2>&-") == 1);
  }
  CHECK(here.shell("$triax report 99 2>&-") == 2);
}

TEST_CASE("a reader that stops reading ends a long query quietly") {
  const Replayed here;
  const std::string many =
      "$triax query 'WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT "
      "200000) SELECT * FROM n' --format ";
  for (const std::string format : {"text", "csv", "json"}) {
    CHECK(here.shell(many + format + " 2>err | head -n 1 >/dev/null") == 0);
    CHECK(content(here / "err").empty());
  }
}

TEST_CASE("what is written is announced, and whether it replaces something") {
  const Replayed here;
  const Outcome html = here.triax("report --format html");
  CHECK(html.out.empty());
  CHECK(html.err == "triax: wrote triax_report.html\n");
  CHECK(here.triax("report --format html").err == "triax: replaced triax_report.html\n");
  CHECK(here.triax("report --output r.json").err == "triax: wrote r.json\n");
  CHECK(json::parse(content(here / "r.json"))["test"]["name"] == "tiny");
  CHECK(here.triax("report --format json --output /dev/null").err.empty());
  CHECK(content(here / "triax_report.html").rfind("<!DOCTYPE html>", 0) == 0);
  CHECK(here.triax("report --format json --output -").out ==
        here.triax("report --format json").out);
}

TEST_CASE("tables take the width of the terminal and break no word") {
  const Replayed here;
  const std::string query =
      "$triax query \"SELECT 1 AS n, 'seven words of a rather long remark, and seven words of a "
      "rather long remark, and seven more of them' AS remark\" >out";
  const auto longest = [&] {
    std::istringstream lines(content(here / "out"));
    std::size_t width = 0;
    for (std::string line; std::getline(lines, line);) width = std::max(width, line.size());
    return width;
  };
  CHECK(here.shell("unset COLUMNS; " + query) == 0);
  CHECK(longest() <= 100);
  CHECK(longest() > 90);
  CHECK(here.shell("COLUMNS=80 " + query) == 0);
  CHECK(longest() <= 80);
  CHECK(here.shell("COLUMNS=20 " + query) == 0);
  CHECK(longest() > 70);  // 80 is the narrowest
  CHECK(here.shell("COLUMNS=200 " + query) == 0);
  CHECK(longest() == 103);  // the whole remark on one line
  CHECK(content(here / "out").find('\x1b') == std::string::npos);
}

TEST_CASE("query results keep every column, quote what needs it, and hold no NaN") {
  const Replayed here;
  const std::string awkward =
      "query \"SELECT 1 AS a, 2 AS a, 'x,\\\"y' AS 'c,d', NULL AS n, 9e999 AS big, 0.1 AS t\"";
  CHECK(here.triax(awkward + " --format csv").out ==
        "a,a,\"c,d\",n,big,t\r\n1,2,\"x,\"\"y\",,,0.1\r\n");
  const json rows = json::parse(here.triax(awkward + " --format json").out);
  REQUIRE(rows.size() == 1);
  CHECK(rows[0] ==
        json{{"a", 1}, {"a_2", 2}, {"c,d", "x,\"y"}, {"n", nullptr}, {"big", nullptr}, {"t", 0.1}});
  CHECK(here.triax("query \"SELECT 1 AS a WHERE 0\" --format json").out == "[]\n");
  CHECK(here.triax("query \"SELECT 'φ' AS s, 1 AS n UNION ALL SELECT 'abc', 10\"").out ==
        "s     n\n---  --\nφ     1\nabc  10\n");
  CHECK(json::parse(here.triax("query --list --format json").out).size() > 5);
}

TEST_CASE("a table longer than what is held back for its widths goes on in the same columns") {
  const Replayed here;
  const std::string out =
      here.triax(
              "query \"WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT "
              "2500) SELECT i, 'x' AS x FROM n\"")
          .out;
  CHECK(std::count(out.begin(), out.end(), '\n') == 2502);
  CHECK(out.find("\n1000  x\n1001  x\n") != std::string::npos);
  CHECK(out.find("\n   1  x\n") != std::string::npos);
}

TEST_CASE("a seed is a whole number that a seed can be") {
  const Workplace here;
  const std::string simulate = "simulate " + source("samples/programmes/icu_6.toml") + " --seed ";
  for (const std::string seed :
       {"-1", "1.5", "7x", "9223372036854775808", "18446744073709551616", "''"}) {
    const Outcome outcome = here.triax(simulate + seed);
    INFO(seed << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("--seed") != std::string::npos);
  }
  CHECK_FALSE(here.has("triax.db"));
  const json test = json::parse(here.triax(simulate + "9223372036854775807 --json").out)["test"];
  CHECK(test["seed"].get<std::uint64_t>() == 9223372036854775807ULL);
  CHECK(here.triax("query \"SELECT seed FROM tests\" --format csv").out ==
        "seed\r\n9223372036854775807\r\n");
}

TEST_CASE("several records give an array in their order, one gives an object") {
  const Workplace here;
  write(here / "one.csv", kRecord);
  write(here / "two.csv", kRecord);
  const json both = json::parse(here.triax("replay two.csv one.csv --json").out);
  REQUIRE(both.size() == 2);
  CHECK(both[0]["test"]["name"] == "two");
  CHECK(both[1]["test"]["name"] == "one");
  CHECK(json::parse(here.triax("report one --format json").out)["test"]["name"] == "one");
  const Outcome missing = here.triax("replay one.csv gone.csv --db other.db");
  CHECK(missing.status == 2);
  CHECK(here.triax("tests list --db other.db").out.find("one") != std::string::npos);
}

TEST_CASE("no output goes over what the command reads or keeps") {
  const Replayed here;
  write(here / "p.toml", content(source("samples/programmes/icu_6.toml")));
  const std::string programme = content(here / "p.toml"), database = content(here / "triax.db");
  std::filesystem::create_symlink("triax.db", here / "link.db");
  for (const char* command :
       {"simulate p.toml --record p.toml", "simulate p.toml --record ./triax.db",
        "simulate p.toml --record new.db --db new.db", "simulate p.toml --db p.toml",
        "report --output triax.db", "report --output link.db", "report --output triax.db-wal",
        "report --db link.db --output triax.db-shm", "replay tiny.csv --db tiny.csv",
        "simulate p.toml --record ."}) {
    const Outcome outcome = here.triax(command);
    INFO(command << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  CHECK(content(here / "p.toml") == programme);
  CHECK(content(here / "triax.db") == database);
  CHECK(content(here / "tiny.csv") == kRecord);
  CHECK_FALSE(here.has("new.db"));
}

TEST_CASE("reports go through pipes, devices and links, which stay what they are") {
  const Replayed here;
  const std::string report = here.triax("report").out;
  CHECK(here.shell("mkfifo pipe; cat pipe >got & $triax report --output pipe >told && wait") == 0);
  CHECK(content(here / "got") == report);
  CHECK(std::filesystem::is_fifo(here / "pipe"));
  CHECK(here.shell("$triax report --output /dev/null >told") == 0);
  CHECK(here.shell("$triax report --output /dev/stdout | cat >got") == 0);
  CHECK(content(here / "got").rfind(report, 0) == 0);
  CHECK(here.shell("ln -s real.txt link.txt; $triax report --output link.txt >told") == 0);
  CHECK(content(here / "real.txt") == report);
  CHECK(std::filesystem::is_symlink(here / "link.txt"));
}

TEST_CASE("a simulation that is ended from outside leaves its record whole or not at all") {
  for (const int signal : {SIGTERM, SIGINT, SIGKILL}) {
    const Workplace here;
    const Running test(here, "simulate " + source("samples/programmes/icu_6.toml") +
                                 " --speed 400 --record x.csv --db a.db");
    REQUIRE(test.reaches("a.db", "scans", 100));
    // Asked to end it ends in order; killed it leaves nothing.
    const bool asked = signal != SIGKILL;
    CHECK(test.end_by(signal) == (asked ? 1 : -1));
    CHECK(here.has("x.csv") == asked);
    if (asked) CHECK(here.triax("replay x.csv --db replayed.db").status == 0);
    std::filesystem::remove(here / "x.csv");
    for (const auto& entry : std::filesystem::directory_iterator(here / ""))
      CHECK(entry.path().filename().string().rfind("x.csv", 0) != 0);
  }
}

TEST_CASE("a record that cannot be written costs neither the test nor its report") {
  const Workplace here;
  std::filesystem::create_directory(here / "gone");
  const Running test(here, "simulate " + source("samples/programmes/icu_6.toml") +
                               " --speed 4000 --record gone/x.csv --db a.db --json");
  REQUIRE(test.reaches("a.db", "scans", 100));
  std::filesystem::remove(here / "gone");
  CHECK(test.end_by(0) == 1);
  CHECK(test.err().find("gone/x.csv: cannot be written: ") != std::string::npos);
  CHECK(test.err().find("; the test itself is stored") != std::string::npos);
  CHECK(nlohmann::json::parse(test.out())["test"]["status"] == "complete");
}

TEST_CASE("names cannot command the terminal") {
  const Workplace here;
  write(here / "esc.csv", "# [test]\n# name = \"a\\u001B[31mb\\nc\\u009Bd\\u007Fe\"\n" + kRecord);
  const Outcome replayed = here.triax("replay esc.csv");
  REQUIRE(replayed.status == 0);
  // The table of all columns wraps the name.
  const std::string wrapped = here.triax("query tests").out;
  for (const std::string& text : {replayed.out, here.triax("report").out, wrapped,
                                  here.triax("query \"SELECT test FROM tests\"").out}) {
    CHECK(text.find(text == wrapped ? "[31mb" : "a [31mb c d e") != std::string::npos);
    for (const char c : text)
      REQUIRE((c == '\n' || (static_cast<unsigned char>(c) >= ' ' && c != 127)));
    CHECK(text.find("\xc2\x9b") == std::string::npos);
  }
  CHECK(json::parse(here.triax("report --format json").out)["test"]["name"] ==
        "a\x1b[31mb\nc\xc2\x9b"
        "d\x7f"
        "e");
  CHECK(here.triax("report $'x\\e[31m'").err.find('\x1b') == std::string::npos);
}

TEST_CASE("every table and view that the help names has the column test_id") {
  const Replayed here;
  for (const std::string view :
       {"tests", "readings", "states", "second_order_work", "collapses", "collapse_points"}) {
    INFO(view);
    CHECK(here.triax("query \"SELECT test_id, test FROM " + view + "\"").status == 0);
  }
  CHECK(here.triax("query \"SELECT test_id, test FROM tests\" --format csv").out ==
        "test_id,test\r\n1,tiny\r\n");
}

TEST_CASE("CSV of a query holds neither commands for terminals nor formulas for spreadsheets") {
  const Replayed here;
  const Outcome csv = here.triax(
      "query \"SELECT '=1+2' AS a, '+x' AS b, '-5.5' AS c, -5.5 AS d, '@y' AS e, 'u' || char(27) "
      "|| "
      "'[31m' AS f, '-z' AS '=g', 'h' AS h\" --format csv");
  CHECK(csv.out == "a,b,c,d,e,f,'=g,h\r\n'=1+2,'+x,-5.5,-5.5,'@y,u [31m,'-z,h\r\n");
  const std::string awkward =
      "query \"SELECT '-nan(1)' AS a, '-inf' AS b, char(10) || '=1' AS c, '  @y' AS d, ' -5' AS e, "
      "x'9b33316d' AS f\" ";
  CHECK(here.triax(awkward + "--format csv").out ==
        "a,b,c,d,e,f\r\n'-nan(1),'-inf,\"'\n=1\",'  @y,' -5,�31m\r\n");
  CHECK(here.triax(awkward).out.find('\x9b' + std::string("31m")) == std::string::npos);
}

TEST_CASE("names of figures are the same in a Turkish locale, where the small I has no dot") {
  const Replayed here;
  REQUIRE(here.triax("tests rename 1 ICU").status == 0);
  if (here.shell("mkdir locales && localedef -i tr_TR -f UTF-8 locales/tr_TR.UTF-8 2>.err") != 0) {
    WARN("skipped: there is no definition of the Turkish locale");
    return;
  }
  REQUIRE(here.shell("LOCPATH=$PWD/locales LC_ALL=tr_TR.UTF-8 $triax report --figures turkish "
                     ">.out 2>.err && $triax report --figures plain >.out 2>.err") == 0);
  CHECK(here.shell("diff <(ls turkish) <(ls plain) >.out") == 0);
  CHECK(here.shell("ls plain | grep -q ^icu_") == 0);
}

TEST_CASE("JSON of a query is whole or not there") {
  const Replayed here;
  // The second row fails: abs() of the smallest integer overflows.
  const std::string sql =
      "query \"SELECT abs(x) AS n FROM (SELECT 1 AS x UNION ALL SELECT "
      "-9223372036854775807 - 1)\" --format ";
  const Outcome failed = here.triax(sql + "json");
  CHECK(failed.status != 0);
  CHECK(failed.out.empty());
  CHECK(failed.err.find("overflow") != std::string::npos);
}

TEST_CASE("a limit on the size of files is an error in words, not a death") {
  const Replayed here;
  const std::string command = "cd '" + (here / "").string() +
                              "' && ulimit -f 8 && " TRIAX_PROGRAM
                              " replay tiny.csv --db limited.db >.out 2>.err </dev/null";
  const int status = std::system(command.c_str());
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
  CHECK(content(here / ".err").find("triax: limited.db") != std::string::npos);
}
