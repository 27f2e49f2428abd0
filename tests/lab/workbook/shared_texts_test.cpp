// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/shared_texts.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("texts come back in their order, long ones, pieces and nothing among them") {
  SharedTexts texts;
  const std::string large(std::size_t{3} << 20, 'y');
  texts.add("a");
  texts.add("bc");
  CHECK(texts.pending_size() == 3);
  texts.end_text();
  texts.end_text();
  texts.add(large);
  texts.end_text();
  texts.add("z");
  texts.end_text();
  CHECK(texts.at(0) == "abc");
  CHECK(texts.at(1) == "");
  CHECK(texts.at(2) == large);
  CHECK(texts.at(3) == "z");
  CHECK_FALSE(texts.at(4));
}

TEST_CASE("texts stay where they are while others are added, and all count, empty ones too") {
  SharedTexts texts;
  texts.add("first");
  texts.end_text();
  const auto first = *texts.at(0);
  const auto before = texts.bytes();
  constexpr int kMore = 300'000;
  for (int i = 0; i < kMore; ++i) {
    if (i % 2 == 0) texts.add("0123456789");
    texts.end_text();
  }
  CHECK(texts.at(0)->data() == first.data());
  CHECK(first == "first");
  CHECK(*texts.at(kMore - 1) == "0123456789");
  CHECK(texts.at(kMore)->empty());
  CHECK(texts.bytes() >= before + kMore / 2 * 10 + kMore * sizeof(std::uint32_t));
}
