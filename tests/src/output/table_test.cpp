#include "src/output/table.hpp"

#include <catch2/catch.hpp>

using namespace triax::src;

TEST_CASE("control characters become blanks, letters above ASCII stay") {
  CHECK(on_one_line("a\n\x1b[31m\x7f\xc2\x9bz φ\xc2\xa0") == "a  [31m  z φ\xc2\xa0");
  CHECK(without_controls("a\nb\tc\x1b") == "a\nb c ");
  CHECK(on_one_line("\xc2") == "\xc2");
}

TEST_CASE("a table keeps its lines whatever its cells hold") {
  const Table table{{{"a", Align::left}, {"b\n", Align::right}}, {{"x\ny", "1"}, {"\x1b", "10"}}};
  CHECK(to_text(table) == "a    b\n---  --\nx y   1\n     10\n");
}
