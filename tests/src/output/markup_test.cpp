// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/markup.hpp"

#include <catch2/catch.hpp>

using namespace triax::src;

TEST_CASE("markup shows names as they are, without what turns the order of reading round") {
  CHECK(escaped("a<b & \"c\"") == "a&lt;b &amp; &quot;c&quot;");
  CHECK(escaped("safe\u202eknis\u2066x\u061cy\u009bz") == "safe�knis�x�y�z");
  CHECK(in_xml("<text>p′ – φ \U0001F600\u202e</text>") == "<text>p′ – φ \U0001F600�</text>");
}
