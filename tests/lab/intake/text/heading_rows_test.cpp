// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/heading_rows.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {
HeadingRows headings_of(const std::string& text, Separator separator = Separator::comma) {
  const auto sample = read_sample(*open_memory("m", text));
  return find_heading_rows(sample, fit_rows(sample, separator));
}
using Indices = std::vector<std::size_t>;
}  // namespace

TEST_CASE("Heading rows: units have a form") {
  for (const char* unit : {"kPa", "KPA", "[mm]", "(kg/cm²)", "%", "mm³", "mm^3", "cu in", "0.01 mm",
                           "psig", "[-]", "мин", "кПа", "N/div", "lbf/in2"})
    CHECK(has_unit_form(unit));
  for (const char* name :
       {"q/p'", "Date/Time", "e1 [%]", "Load", "-", "", "sigma3", "Temps", "(s1-s3)"}) {
    INFO(name);
    CHECK_FALSE(has_unit_form(name));
  }
}

TEST_CASE("Heading rows: names, units and statistics") {
  const auto found = headings_of("H,1\nt,q,u\ns,kPa,kPa\nSmp,Avg,Avg\n0,1,2\n1,2,3\n");
  CHECK(found.lines == Indices{1});
  CHECK(found.unit_line == 2U);
  CHECK(found.top == 1);
  CHECK(found.units == std::vector<std::string>{"s", "kPa", "kPa"});
  CHECK(found.coverage == 1);
}

TEST_CASE("Heading rows: an index column needs no name") {
  const auto found = headings_of(",t,q,u\n0,1.5,2,3\n1,2.5,3,4\n");
  CHECK(found.lines == Indices{0});
  CHECK(found.coverage == 0.75);
}

TEST_CASE("Heading rows: names of groups are above names") {
  CHECK(headings_of("Time,,Stress,\nt,e1,q,u\n0,1,2,3\n1,2,3,4\n").lines == Indices{0, 1});
  CHECK(headings_of("Hole,B3,,Client,Muster\nt,e1,q,u,p\n0,1,2,3,4\n1,2,3,4,5\n").lines ==
        Indices{1});
  CHECK(headings_of("Time  Stress \nt e1 q u\n0 1 2 3\n1 2 3 4\n", Separator::blanks).lines ==
        Indices{0, 1});
}

TEST_CASE("Heading rows: none above numbers") {
  CHECK(headings_of("0,1,2\n1,2,3\n").lines.empty());
  CHECK(headings_of("a remark\n0,1,2\n1,2,3\n").lines.empty());
}

TEST_CASE("Heading rows: a line above the table that names units has those of the columns") {
  const std::string header =
      "Channels,3\n{}\nX_Dimension,Time,Time,Time\nX0,0,0,0\n***End_of_Header***\n"
      "X_Value,Load cell,LVDT,PWP,Comment\n0.0,0.9,0.001,300.1,start\n15.0,0.3,0.005,300.4,\n"
      "30.0,0.2,0.011,300.5,\n";
  const auto with = [&](const char* line) {
    std::string text = header;
    return text.replace(text.find("{}"), 2, line);
  };
  const auto found = headings_of(with("Y_Unit_Label,N,mm,kPa"));
  CHECK(found.lines == Indices{5});
  CHECK(found.unit_line == 1U);
  CHECK(found.units == std::vector<std::string>{"", "N", "mm", "kPa", ""});
  for (const char* other : {"Y_Unit_Label,Newton meter,mm,kPa", "Operator,N,mm,kPa", "Unit,kN"})
    CHECK_FALSE(headings_of(with(other)).unit_line);
}
