// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/pieces.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::study;
using Catch::Contains;

namespace {
std::string nothing(std::size_t) { return {}; }
}  // namespace

TEST_CASE("all pieces must be of one division in any order, once each") {
  CHECK_NOTHROW(check_together({{"b", "1.0", 2, 2}, {"a", "1.0", 1, 2}}, "whole", nothing));
  CHECK_THROWS_WITH(check_together({{"b", "1.0", 2, 2}}, "whole", nothing),
                    "--merge: piece 1 of 2 is missing (1 given)");
  CHECK_THROWS_WITH(check_together({{"b", "1.0", 2, 2}, {"a", "1.0", 2, 2}}, "whole", nothing),
                    "a: is piece 2 of 2, like b; give each piece once");
  CHECK_THROWS_WITH(check_together({{"b", "1.0", 2, 2}, {"a", "1.1", 1, 2}}, "whole", nothing),
                    Contains("a: was written by triax 1.1, b by 1.0"));
  CHECK_THROWS_WITH(check_together({{"b", "1.0", 2, 2}, {"a", "1.0", 1, 3}}, "whole", nothing),
                    Contains("a: is one of 3 pieces, b one of 2"));
  CHECK_THROWS_WITH(
      check_together({{"b", "1.0", 2, 2}, {"a", "1.0", 1, 2}}, "whole",
                     [](std::size_t k) { return k == 1 ? std::string("x is 1") : std::string(); }),
      "a: is a piece of another whole: x is 1");
}

TEST_CASE("a sealed document tells every byte that changes, and stays one of JSON") {
  const std::string document = "{\n\"a\": [1, 2.5],\n\"b\": 7\n}\n";
  const std::string text = sealed(document);
  // printf '{\n"a": [1, 2.5],\n"b": 7' | sha256sum
  CHECK(text == document.substr(0, document.size() - 3) + ",\n\"sha256\": \"" +
                    "dd293733dbce553c28cd86126cb61e040768e4fa4fd53e5471976d80cca8fc37" + "\"\n}\n");
  CHECK_NOTHROW(check_seal(text, "p.json"));
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = changed[i] == '3' ? '4' : '3';
    INFO(changed);
    CHECK_THROWS_AS(check_seal(changed, "p.json"), lab::BadInput);
  }
  CHECK_THROWS_WITH(check_seal(document, "p.json"), Contains("p.json: has no checksum"));
}

TEST_CASE("what is no file of a piece says who writes one") {
  CHECK_THROWS_WITH(piece_text(".", "triax domain --piece", "domain"),
                    ".: is not a regular file; expected a file written by triax domain --piece");
  CHECK(piece_text("tests/CMakeLists.txt", "x", "y").find("Catch2") != std::string::npos);
}
