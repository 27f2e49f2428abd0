// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/table.hpp"

#include <catch2/catch.hpp>

using namespace triax::src;

TEST_CASE("widths are those of a terminal, not of bytes") {
  CHECK(display_width("φ_mob (°)") == 9);
  CHECK(display_width("p′₀") == 3);
  CHECK(display_width("") == 0);
}

TEST_CASE("columns line up, numbers at the right") {
  const Table table{{{"η"}, {"q (kPa)", Align::right}}, {{"a", "1.5"}, {"long one", "100.25"}}};
  CHECK(to_text(table) ==
        "η         q (kPa)\n"
        "--------  -------\n"
        "a             1.5\n"
        "long one   100.25\n");
}

TEST_CASE("control characters become blanks, letters above ASCII stay") {
  CHECK(on_one_line("a\n\x1b[31m\x7f\xc2\x9bz φ\xc2\xa0") == "a  [31m  z φ\xc2\xa0");
  CHECK(without_controls("a\nb\tc\x1b") == "a\nb c ");
  CHECK(on_one_line("\xc2") == "�");
  CHECK(on_one_line("a\x9b"
                    "31m\xe9z") == "a�31m�z");
  // What turns the order of reading round, or breaks lines: U+061C, 200E, 202E, 2028, 2066, 2069.
  CHECK(on_one_line("a\u061cb\u200ec\u202ed\u2028e\u2066f\u2069g") == "a b c d e f g");
  CHECK(on_one_line("p′ – 5 ° א\xe2\x80") == "p′ – 5 ° א��");
}

TEST_CASE("a table keeps its lines whatever its cells hold") {
  const Table table{{{"a", Align::left}, {"b\n", Align::right}}, {{"x\ny", "1"}, {"\x1b", "10"}}};
  CHECK(to_text(table) == "a    b\n---  --\nx y   1\n     10\n");
}

TEST_CASE("a table too wide wraps its words, never its numbers") {
  const Table table{{{"Remark"}, {"q at the peak (kPa)", Align::right}},
                    {{"strength is lost and recovers", "100.25"}, {"short", "1.5"}}};
  CHECK(to_text(table, 24) ==
        "Remark          q at the\n"
        "              peak (kPa)\n"
        "-----------  -----------\n"
        "strength is       100.25\n"
        "lost and\n"
        "recovers\n"
        "short                1.5\n");
  // Below the longest words there is nothing to give: lines stick out, words stay whole.
  CHECK(to_text(table, 1).find("recovers\n") != std::string::npos);
}

TEST_CASE("indented: every line two blanks further in, none behind the last") {
  CHECK(triax::src::indented("a\nb\n") == "  a\n  b\n");
}
