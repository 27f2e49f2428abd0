// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/embedded.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

using namespace triax::lab;

TEST_CASE("dialects inside the program are the files of the source tree, byte for byte") {
  REQUIRE_FALSE(kShippedDialects.empty());
  for (const EmbeddedFile& file : kShippedDialects) {
    INFO(file.name);
    std::ifstream stream("lab/records/dialects/" + std::string(file.name) + ".toml");
    std::ostringstream text;
    text << stream.rdbuf();
    CHECK(text.str() == file.text);
  }
}
