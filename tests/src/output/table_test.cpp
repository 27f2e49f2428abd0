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
