// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/structure.hpp"

#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

StructureResult result_of(const std::string& text) {
  return find_structure(read_sample(*open_memory("m", text)));
}

TableStructure structure_of(const std::string& text) {
  auto result = result_of(text);
  INFO(text << result.reason);
  REQUIRE(result.structure);
  return *result.structure;
}

/// "comma . H1,2 U3 R4-6" of a text.
std::string shape_of(const std::string& text) {
  const auto table = structure_of(text);
  std::string format(1, static_cast<char>(table.decimal));
  if (table.thousands != 0) format += table.thousands;
  return fmt::format("{} {} H{} U{} R{}-{}", separator_name(table.separator), format,
                     fmt::join(table.heading_lines, ","), table.unit_line, table.first_row_line,
                     table.last_row_line);
}

using Texts = std::vector<std::string>;
using LineNumbers = std::vector<std::int64_t>;

}  // namespace

TEST_CASE("Structure: separators and decimal marks") {
  CHECK(shape_of("t,q\n0,1.5\n1,2.5\n") == "comma . H1 U0 R2-0");
  CHECK(shape_of("t;q\n0,0;1,5\n1,0;2,5\n") == "semicolon , H1 U0 R2-0");
  CHECK(shape_of("t;q\n0.0;1.5\n1.0;2.5\n") == "semicolon . H1 U0 R2-0");
  CHECK(shape_of("t\tq\n0,0\t1,5\n1,0\t2,5\n") == "tab , H1 U0 R2-0");
  CHECK(shape_of("t|q\n0.0|1.5\n1.0|2.5\n") == "pipe . H1 U0 R2-0");
  CHECK(shape_of("t q\n0,0 1,5\n1,0 2,5\n") == "blanks , H1 U0 R2-0");
  CHECK(shape_of("Void ratio  q (kPa)\n0.7   1.5\n0.6   2.5\n") == "wide blanks . H1 U0 R2-0");
  CHECK(shape_of("\"t\",\"q\"\n\"0,0\",\"1,5\"\n\"1,0\",\"2,5\"\n") == "comma , H1 U0 R2-0");
  CHECK(shape_of("t;q;c\n0,0;1,5;a, b\n1,0;2,5;c, d\n") == "semicolon , H1 U0 R2-0");
  CHECK(shape_of("\tElapsed time\te1\tq\n0\t0.0\t0.0\t1.5\n1\t1.0\t0.1\t2.5\n") ==
        "tab . H1 U0 R2-0");
}

TEST_CASE("Structure: thousands marks") {
  CHECK(shape_of("t;F\n0.5;1,234.5\n1.5;12.25\n") == "semicolon ., H1 U0 R2-0");
  CHECK(shape_of("t;F\n0,5;1.234,5\n1,5;2.345\n") == "semicolon ,. H1 U0 R2-0");
  CHECK(shape_of("t;F\n0,5;1 234,5\n1,5;2\u00A0345,0\n") == "semicolon ,  H1 U0 R2-0");
  CHECK(shape_of("t;F\n0.5;1'234.5\n1.5;2'345.0\n") == "semicolon .' H1 U0 R2-0");
  CHECK(shape_of("t,F\n0.5,\"1,234.5\"\n1.5,\"2,345.0\"\n") == "comma ., H1 U0 R2-0");
  CHECK(shape_of("t;F\n0.500;1.234\n1.500;2.345\n") == "semicolon . H1 U0 R2-0");
}

TEST_CASE("Structure: heading lines and units") {
  CHECK(shape_of("t,q,u\ns,kPa,kPa\n0,1,2\n1,2,3\n") == "comma . H1 U2 R3-0");
  CHECK(shape_of("t,q,u\n[s],[kPa],[kPa]\n\n0,1,2\n1,2,3\n") == "comma . H1 U2 R4-0");
  CHECK(shape_of("Time,,Stress,\nt,e,q,u\ns,%,kPa,kPa\n0,1,2,3\n1,2,3,4\n") ==
        "comma . H1,2 U3 R4-0");
  CHECK(shape_of("t,q,u\ns,kPa,kPa\nAvg,Smp,Avg\n0,1,2\n1,2,3\n") == "comma . H1 U2 R4-0");
  CHECK(shape_of("Test,UU\nt,d,P\n[h],[mm],[kN]\n0,1,2\n1,2,3\n") == "comma . H2 U3 R4-0");
  CHECK(shape_of("Time,Deformation,Load\nt,d [mm],F [kN]\n0,1,2\n1,2,3\n") ==
        "comma . H1,2 U0 R3-0");
  CHECK(shape_of("t,q,u,p\n1,2,3,4\n0.5,1.5,2.5,3\n1,2,3.5,4\n") == "comma . H1 U0 R3-0");
  CHECK(shape_of("t  q  u\n-----  -----  -----\n0.5  1.5  2.5\n1  2  3.5\n") ==
        "wide blanks . H1 U0 R3-0");
  CHECK(shape_of("eps,100,200,300\n0.1,1.5,2.5,3.5\n0.2,2,3.5,4.5\n") == "comma . H1 U0 R2-0");
  CHECK(shape_of("sigma1;sigma3;3\n0.1;1.5;2.5\n0.2;2;3.5\n") == "semicolon . H1 U0 R2-0");
  CHECK(shape_of("Void ratio   q   p\n0.7\t1.5\t2.5\n0.6\t1.6\t2.7\n") ==
        "wide blanks . H1 U0 R2-0");
  const auto table = structure_of("Time,,Stress,\nt,e,q,u\ns,%,kPa,kPa\n0,1,2,3\n1,2,3,4\n");
  CHECK(table.headings == Texts{"Time t", "Time e", "Stress q", "Stress u"});
  CHECK(table.units == Texts{"s", "%", "kPa", "kPa"});
}

TEST_CASE("Structure: a table without headings has the reason") {
  const auto result = result_of("0.0,0.1,100\n1.0,0.2,101\n");
  REQUIRE(result.structure);
  CHECK(result.reason == "3 columns of numbers and no heading");
  CHECK(result.structure->heading_lines.empty());
  CHECK(result.structure->first_row_line == 1);
  CHECK(result.structure->headings == Texts(3));
}

TEST_CASE("Structure: what is no table has a reason") {
  CHECK(result_of("").reason == "the file is empty");
  CHECK(result_of("\n \n,,\n").reason == "the file is empty");
  CHECK(result_of("Dear all,\nplease find the readings below.\n").reason == "only text");
  CHECK(result_of("q\n1.5\n2.5\n3.5\n").reason == "one column");
  CHECK(result_of("Client;Muster\nHole;B3\nDepth;12,5\n").reason == "only text");
  CHECK_FALSE(result_of("a\n").structure);
}

TEST_CASE("Structure: preambles are no headings") {
  CHECK(shape_of("Client;Muster\nHeight (mm);140,0\n\nt;q\n0,0;1,5\n1,0;2,5\n") ==
        "semicolon , H4 U0 R5-0");
  CHECK(shape_of("H (mm),140,,D (mm),70,,Hole,3\nt,q,u,p,e\n0,1,2,3,4\n1,2,3,4,5\n") ==
        "comma . H2 U0 R3-0");
  CHECK(shape_of("Logger: 4-ch,Serial 0417,Interval 15 s\nt,q,u\n0,1,2\n1,2,3\n") ==
        "comma . H2 U0 R3-0");
  CHECK(shape_of("Test,UU,,,\nt,q,u,p,e\n0,1,2,3,4\n1,2,3,4,5\n") == "comma . H2 U0 R3-0");
  const auto table = structure_of("Client;Muster\nt;q\n0,0;1,5\n1,0;2,5\n");
  CHECK(table.preamble == Texts{"Client;Muster"});
}

TEST_CASE("Structure: comment marks") {
  for (const std::string mark : {"#", "%", "//", "*", "**", "!"}) {
    const auto table =
        structure_of(mark + " test 7\n" + mark + " t,q\n0,1.5\n1,2.5\n" + mark + " pause\n2,3.5\n");
    INFO(mark);
    CHECK(table.comment == mark);
    CHECK(table.heading_lines == LineNumbers{2});
    CHECK(table.headings == Texts{"t", "q"});
    CHECK(table.repeated_heading_lines.empty());
  }
  CHECK(structure_of("; test\nt\tq\n0\t1.5\n1\t2.5\n").comment == ";");
  CHECK(structure_of("e1 q\n% kPa\n0 1.5\n1 2.5\n").unit_line == 2);
}

TEST_CASE("Structure: repeated headings, interruptions and text after the rows") {
  const auto table = structure_of(
      "t;q\ns;kPa\n0,0;1,5\n1,0;2,5\nt;q\ns;kPa\n2,0;3,5\n\npause\n3,0;4,5\n\nMax;4,5\nsigned: "
      "A\n");
  CHECK(table.heading_lines == LineNumbers{1});
  CHECK(table.first_row_line == 3);
  CHECK(table.repeated_heading_lines == LineNumbers{5, 6, 9});
  CHECK(table.last_row_line == 10);
  std::string stages = "stage;t;q\n";
  for (int i = 0; i < 10; ++i) stages += fmt::format("shear;{};{}\n", i, i + 1);
  CHECK(shape_of(stages + "Max;9;10\nMin;0;1\n") == "semicolon . H1 U0 R2-11");
}

TEST_CASE("Structure: cells without a value do not end the table") {
  CHECK(shape_of("t,q,u\n0,NaN,2\n1,,3\n2,OVRFLO,3\n3,-999.25,\n4,5\n") == "comma . H1 U0 R2-0");
  CHECK(shape_of("t,q,u,p\n0,1,2,3\n1,2,3,4\n2,broken,3,4\n3,4,5,6\n") == "comma . H1 U0 R2-0");
  CHECK(shape_of("t,q,u\n0,,\n1,2,3\n2,3,4\n") == "comma . H1 U0 R2-0");
  CHECK(structure_of("t,q,\n0,1,\n1,2,\n").column_count == 2);
  CHECK(structure_of("t,q,note\n0,1,\n1,2,\n").column_count == 3);
  CHECK(structure_of("INDEX, TIME, Q,\r\n0, 10:00:00, 1.5,\r\n1, 10:00:01, 2.5,\r\n").headings ==
        Texts{"INDEX", "TIME", "Q"});
}

TEST_CASE("Structure: a first row in which most values are missing is a row") {
  // The second and third columns start later; the remark is written in a few rows.
  std::string text = "strain,q,p,note\n0.0000,,,ok\n0.0068,165.1,,\n0.0136,200.0,,ok\n";
  for (int i = 3; i < 18; ++i)
    text += fmt::format("{:.4f},{:.1f},{:.1f},{}\n", 0.0068 * i, 200.0 + i, 550.0 + i,
                        i % 2 == 0 ? "log" : "");
  CHECK(shape_of(text) == "comma . H1 U0 R2-0");
  CHECK(shape_of("18,,,\n" + text) == "comma . H2 U0 R3-0");
  text.replace(text.find("0.0000,,"), 8, ",100.0,");
  CHECK(shape_of(text) == "comma . H1 U0 R2-0");
}

TEST_CASE("Structure: a first row with one value between blanks is a row") {
  std::string text = "strain (%)  vertical stress (kPa)  radial stress (kPa)\n";
  for (int i = 0; i < 12; ++i)
    text += fmt::format("{:>10}  {:>21.2f}  {:>19}\n", i < 2 ? "" : fmt::format("{:.2f}", 0.7 * i),
                        100.0 + 30 * i, i < 1 ? "" : fmt::format("{:.1f}", 100.0 + 0.1 * (i % 3)));
  CHECK(structure_of(text).first_row_line == 2);
}

TEST_CASE("Structure: a line of a summary with the name of a stage is no row") {
  std::string text = "Stage\tt\tq\n";
  for (int i = 0; i < 10; ++i) text += fmt::format("Saturation\t{}\t0.0\n", 100 * i);
  for (int i = 10; i < 30; ++i) text += fmt::format("Failure\t{}\t{:.1f}\n", 100 * i, 2.5 * i);
  text += "Max\t2900\t72.5\nMean\t1450\t30.1\nFailure\t2900\t72.5\n";
  CHECK(shape_of(text) == "tab . H1 U0 R2-31");
}

TEST_CASE("Structure: clocks and texts are columns") {
  CHECK(shape_of("Date Time\tq\n2026-03-09 23:59:50\t1\n2026-03-10 00:00:00\t2\n") ==
        "tab . H1 U0 R2-0");
  CHECK(shape_of("2026-03-09 23:59:50\t1\n2026-03-10 00:00:00\t2\n") == "tab . H U0 R1-0");
  CHECK(shape_of("t\tAction\tChanged\tq\n0\tStart\tTrue\t1.5\n1\tWait\t\t2.5\n2\tWait\t\t2.7\n") ==
        "tab . H1 U0 R2-0");
}

TEST_CASE("Structure: tables side by side") {
  const auto table =
      structure_of("Specimen 1,,,Specimen 2,\neps,q,,eps,q\n0,1,,0,2\n1,2,,1,4\n2,3,,,\n");
  REQUIRE(table.blocks.size() == 2);
  CHECK(table.blocks[1].first_cell == 3);
  CHECK(table.blocks[0].cell_count == 2);
  CHECK(table.blocks[1].title == "Specimen 2");
  CHECK(table.headings == Texts{"eps", "q", "", "eps", "q"});
  CHECK(structure_of("e,q,e,q,e,q\n0,1,0,2,0,3\n1,2,1,4,1,6\n").blocks.size() == 3);
  CHECK(structure_of("t,,q,p\n0,,1,2\n1,,2,4\n").blocks.empty());
  CHECK(structure_of("t,q,t\n0,1,2\n1,2,4\n").blocks.empty());
}

TEST_CASE("Structure: headers of loggers") {
  CHECK(shape_of("\"TOA5\",\"TX2\",\"CR6\",\"1204\"\n\"TIMESTAMP\",\"RECORD\",\"Load_Avg\"\n"
                 "\"TS\",\"RN\",\"kN\"\n\"\",\"\",\"Avg\"\n\"2026-03-09 23:59:50\",0,\"NAN\"\n"
                 "\"2026-03-10 00:00:00\",1,0.04\n") == "comma . H2 U3 R5-0");
  std::string labview =
      "LabVIEW Measurement\t\nSeparator\tTab\nDecimal_Separator\t,\nDate\t2026/03/09\n"
      "***End_of_Header***\t\nChannels\t2\t\t\nSamples\t1\t1\t\nDate\t2026/03/09\t2026/03/09\t\n"
      "***End_of_Header***\t\t\t\nX_Value\tLoad (N)\tStroke (mm)\tComment\n";
  for (int i = 0; i < 10; ++i) labview += fmt::format("{},0\t1,2\t0,1\t\n", i);
  CHECK(shape_of(labview) == "tab , H10 U0 R11-0");
  CHECK(
      shape_of("[Eingaben]\nProbenhoehe=140,0\nMasse=12,3\n[Daten]\nDatum/Zeit;Weg[mm];Kraft[kN]\n"
               "09.03.2026 10:00:00;0,0;0,1\n09.03.2026 10:00:10;0,1;0,2\n") ==
      "semicolon , H5 U0 R6-0");
}

TEST_CASE("Structure: names listed line by line") {
  const auto table = structure_of(
      "Columns\n1: Time [s]\n2: Load [kN]\n3: Stroke [mm]\n\n0.0 0.1 0.2\n1.0 0.3 0.4\n");
  CHECK(table.heading_lines == LineNumbers{2, 3, 4});
  CHECK(table.headings == Texts{"Time [s]", "Load [kN]", "Stroke [mm]"});
  CHECK(table.preamble == Texts{"Columns"});
}

TEST_CASE("Structure: the rows at both ends of a long file") {
  std::string text = "t,q\n";
  for (int i = 0; i < 5000; ++i) text += fmt::format("{},{}\n", i, 0.5 * i);
  CHECK(shape_of(text) == "comma . H1 U0 R2-0");
  CHECK(shape_of(text + "\nend of test\n") == "comma . H1 U0 R2-5001");
}

TEST_CASE("Structure: hostile text is answered in time") {
  const auto start = std::chrono::steady_clock::now();
  const std::string line(900'000, ',');
  std::string quotes = "t,q\n0,1\n1,2\n";
  for (int i = 0; i < 900; ++i) quotes += "\"" + std::string(900, 'x') + ",\n";
  for (const std::string& text :
       {line + "\n" + line + "\n", std::string(900'000, '"'), std::string(900'000, '1') + "\n",
        quotes, std::string(900'000, ' ') + "1 2\n", std::string(1000, '#') + "\n",
        std::string(500'000, '-') + "\n", "\xFF\xFE,\x80\n\x80,1\n" + quotes}) {
    const auto result = result_of(text);
    CHECK((result.structure || !result.reason.empty()));
  }
  std::string wide;
  for (int row = 0; row < 50; ++row) {
    for (int column = 0; column < 5000; ++column) wide += "1,";
    wide += "1\n";
  }
  CHECK(result_of(wide).structure);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}
