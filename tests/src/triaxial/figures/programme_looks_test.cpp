// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/programme_looks.hpp"

#include <catch2/catch.hpp>

#include "src/plot/drawing.hpp"

using namespace triax::src;

TEST_CASE("types have looks of their own, in the order of the alphabet, whatever comes first") {
  need_drawing();  // a marker holds a pixmap
  const ProgrammeLooks a({"ICU", "CSD", "CSD", ""}), b({"", "CSD", "ICU"});
  CHECK(a.names() == std::vector<std::string>{"CSD", "ICU", "other"});
  CHECK(a.names() == b.names());
  for (const char* type : {"ICU", "CSD", ""}) {
    CHECK(a.colour(type) == b.colour(type));
    CHECK(a.marker(type, true).shape() == b.marker(type, false).shape());
  }
  CHECK(a.marker("ICU", true).shape() != a.marker("CSD", true).shape());
  CHECK(a.colour("ICU") != a.colour("CSD"));
}

TEST_CASE("markers are filled where tests are recorded, open where they are simulated") {
  need_drawing();
  const ProgrammeLooks looks({"ICU"});
  CHECK(looks.marker("ICU", false).brush().color() == looks.colour("ICU"));
  CHECK(looks.marker("ICU", true).brush().color() == QColor(Qt::white));
}
