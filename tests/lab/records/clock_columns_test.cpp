// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/clock_columns.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/records/table_reader.hpp"
#include "lab/records/tables/table_recognition.hpp"

using namespace triax::lab;

namespace {
struct Timed {
  std::vector<double> times;
  std::vector<Warning> warnings;
  bool has_time = false;
};
Timed read_times(const std::string& columns, const std::string& text) {
  const auto source = open_memory("m.csv", text);
  const auto dialect = parse_dialect(
      "name = \"clock\"\n[columns]\naxial_strain = \"e\"\ndeviator_stress = \"q\"\n"
      "effective_radial_stress = \"s\"\n" +
          columns,
      "d.toml");
  Timed out;
  Findings findings(out.warnings);
  const TableLayout layout = recognise_table(*source, dialect, findings);
  out.has_time = layout.has(ColumnRole::time);
  TableReader reader(*source, layout, findings);
  Row row;
  while (reader.next(row)) out.times.push_back(row.time_s);
  findings.finish();
  return out;
}
std::string one_column(const std::vector<std::string>& cells,
                       const std::string& heading = "Clock") {
  std::string text = heading + ",e (%),q (kPa),s (kPa)\n";
  for (const auto& cell : cells) text += cell + ",0.1,5.0,100.0\n";
  return text;
}
std::vector<double> times_of_column(const std::vector<std::string>& cells) {
  return read_times("time = \"Clock\"\n", one_column(cells)).times;
}
using Times = std::vector<double>;
}  // namespace

TEST_CASE("find_clocks: a clock needs no unit and is noted with its order", "[records]") {
  const auto read = read_times(
      "time = \"Clock\"\n",
      one_column({"03/09/2026 23:45", "03/10/2026 00:00", "\"03/10/2026 00:15\"", "03/10/2026"}));
  CHECK(read.times == Times{0, 900, 1800, 900});
  REQUIRE(read.warnings.size() == 1);
  CHECK_THAT(read.warnings[0].text, Catch::Contains("'Clock' is a clock") &&
                                        Catch::Contains("month first, because day first would"));
}

TEST_CASE("find_clocks: an order that is assumed is noted as such", "[records]") {
  const auto read =
      read_times("time = \"Clock\"\n", one_column({"03/09/2026 10:00", "03/09/2026 11:00"}));
  CHECK(read.times == Times{0, 3600});
  CHECK_THAT(read.warnings.at(0).text, Catch::Contains("day first or month first") &&
                                           Catch::Contains("day first is assumed") &&
                                           Catch::Contains("date_order"));
}

TEST_CASE("find_clocks: the dialect gives the order of the date", "[records]") {
  const std::string columns = "time = { names = \"Clock\", date_order = \"month first\" }\n";
  const auto text = one_column({"03/09/2026 10:00", "04/09/2026 10:00"});
  CHECK(read_times(columns, text).times == Times{0, 31 * 86'400.0});
  CHECK_THROWS_WITH(read_times(columns, one_column({"2026-03-10 10:00"})),
                    Catch::Contains("'2026-03-10 10:00'") && Catch::Contains("month first"));
  CHECK_THROWS_WITH(read_times("time = { names = \"Clock\", date_order = \"american\" }\n", text),
                    Catch::Contains("must be one of: year first, day first, month first"));
  CHECK_THROWS_WITH(read_times("stage = { names = \"x\", date_order = \"day first\" }\n", text),
                    Catch::Contains("unknown key"));
}

TEST_CASE("find_clocks: a cell that does not fit is an error with its line", "[records]") {
  CHECK_THROWS_WITH(times_of_column({"13/03/2026 10:00", "14/03/2026 10:00", "03/15/2026 10:00"}),
                    Catch::Contains("m.csv:4: column 'Clock' has '03/15/2026 10:00'") &&
                        Catch::Contains("day first"));
  CHECK_THROWS_WITH(times_of_column({"10:00", "10:01", "12.5"}), Catch::Contains("m.csv:4: "));
  CHECK_THROWS_WITH(times_of_column({"0", "1", "10:01"}), Catch::Contains("has no unit"));
  CHECK_THROWS_WITH(times_of_column({"10:00", "10:01", "Clock"}), Catch::Contains("second table"));
}

TEST_CASE("find_clocks: a clock without a value is a missing time", "[records]") {
  const auto times = times_of_column({"10:00:00", "NAN", "", "10:00:03"});
  CHECK(times[0] == 0);
  CHECK(std::isnan(times[1]));
  CHECK(std::isnan(times[2]));
  CHECK(times[3] == 3);
}

TEST_CASE("find_clocks: a date and a time of day are combined", "[records]") {
  const std::string columns = "date = \"Date\"\ntime_of_day = \"Time\"\n";
  const std::string headings = "Date,Time,e (%),q (kPa),s (kPa)\n";
  const auto read = read_times(columns, headings +
                                            "03/09/2026,23:59:00,0.1,5,100\n"
                                            "03/10/2026,00:01:00,0.2,5,100\n"
                                            ",00:02:00,0.3,5,100\n"
                                            "\"03/11/2026\",00:00:30,0.4,5,100\n");
  CHECK(read.has_time);
  CHECK(read.times == Times{0, 120, 180, 86'490});
  CHECK(read.warnings.size() == 2);
  const auto counts =
      read_times(columns, headings + "46090,0.999,0.1,5,100\n46091,0.001,0.2,5,100\n");
  CHECK(counts.times.at(1) == Approx(172.8));
  const auto alone = read_times("date = \"Date\"\n", headings +
                                                         "2026-03-09 10:00,x,0.1,5,100\n"
                                                         "2026-03-10,x,0.2,5,100\n");
  CHECK(alone.times == Times{0, 14 * 3600.0});
  CHECK_THROWS_WITH(read_times(columns, headings + "soon,10:00,0.1,5,100\n"),
                    Catch::Contains("'Date' has 'soon', which is not a date"));
}

TEST_CASE("find_clocks: a time in numbers needs no date", "[records]") {
  const auto read = read_times(
      "date = \"Date\"\ntime = { names = \"Time\", unit = \"min\" }\n",
      "Date,Time,e (%),q (kPa),s (kPa)\n03/09/2026,0,0.1,5,100\n03/09/2026,1.5,0.2,5,1\n");
  CHECK(read.times == Times{0, 90});
  CHECK(read.warnings.empty());
}

TEST_CASE("find_clocks: a row beyond the first ones decides", "[records]") {
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < 3 * kClockRows; ++i)
    cells.push_back(fmt::format("{:02}/03/2026 {:02}:{:02}", 3 + i / 1440, i / 60 % 24, i % 60));
  const auto read = read_times("time = \"Clock\"\n", one_column(cells));
  CHECK(read.times.back() == 60.0 * static_cast<double>(cells.size() - 1));
  CHECK_THAT(read.warnings.at(0).text, Catch::Contains("day first, because"));
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i] = fmt::format("{}:{:02}:{:02}", i / 60, i % 60, 0);
  CHECK(times_of_column(cells).back() == 60.0 * static_cast<double>(cells.size() - 1));
}

TEST_CASE("find_clocks: dates with points leave the decimal mark open", "[records]") {
  const auto read = read_times("time = \"Clock\"\n",
                               "Clock;e (%);q (kPa);s (kPa)\n"
                               "09.03.2026 10:00;0,1;5,5;100,0\n09.03.2026 10:01;0,2;5,5;100\n");
  CHECK(read.times == Times{0, 60});
}

TEST_CASE("find_clocks: a time of the stage counts on its own", "[records]") {
  const auto source =
      open_memory("m.csv",
                  "t,stage,e (%),q (kPa),s (kPa)\n0:00:00,1,0,5,100\n26:00:00,1,1,5,100\n"
                  "0:00:30,2,2,5,100\n");
  const auto dialect = parse_dialect(
      "name = \"x\"\n[columns]\nstage_time = \"t\"\nstage = \"stage\"\naxial_strain = \"e\"\n"
      "deviator_stress = \"q\"\neffective_radial_stress = \"s\"\n",
      "d.toml");
  std::vector<Warning> warnings;
  Findings findings(warnings);
  const TableLayout layout = recognise_table(*source, dialect, findings);
  TableReader reader(*source, layout, findings);
  Row row;
  Times times;
  while (reader.next(row)) times.push_back(row.stage_time_s);
  CHECK(times == Times{0, 93'600, 30});
}

TEST_CASE("find_clocks: words of overload are missing and counted", "[records]") {
  const auto read = read_times("",
                               "e (%),q (kPa),s (kPa)\n0.1,5,100\n0.2,OVLD,100\n"
                               "0.3,*****,100\n0.4,#WERT!,100\n0.5,1.#QNAN,100\n0.6,6,100\n");
  REQUIRE(read.warnings.size() == 1);
  CHECK_THAT(read.warnings[0].text, Catch::Contains("'q (kPa)' has no value ('OVLD')") &&
                                        Catch::Contains("3 more, the last in line 6"));
}

TEST_CASE("find_clocks: text below the rows is no cell of a date", "[records]") {
  const auto read = read_times(
      "date = { column = 1, date_order = \"year first\" }\ntime_of_day = { column = 2 }\n",
      "Date,Time,e (%),q (kPa),s (kPa)\n2023-11-08,09:30:00,0,5,100\n,09:31:00,0.1,6,100\n"
      ",09:32:00,0.2,7,100\n\nFailure: max. stress,,,,\nOperator: RT,Checked: AM,,,\n");
  CHECK(read.times == Times{0, 60, 120});
}
