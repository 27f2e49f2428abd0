// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/encoding.hpp"

#include <utility>

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

using namespace triax::lab;
using namespace std::string_literals;

namespace {

std::string read_all(ByteSource& source, std::size_t block = 1000) {
  std::string text;
  std::string part(block, '\0');
  while (const auto count = source.read(part)) text.append(part, 0, count);
  return text;
}

std::string utf8_of(const std::string& bytes, const std::optional<std::string>& encoding = {}) {
  return read_all(*open_utf8(open_memory("m", bytes), encoding));
}

std::string utf16(std::string_view ascii, bool little) {
  std::string out;
  for (const char c : ascii) {
    if (!little) out += '\0';
    out += c;
    if (little) out += '\0';
  }
  return out;
}

}  // namespace

TEST_CASE("Encoding: UTF-8 is not touched") {
  for (const std::string& text : {""s, "a;b\n1;2\n"s, "\xEF\xBB\xBF"s + "a\n", "σ';°C\n1;2\n"s}) {
    auto source = open_memory("m", text);
    const ByteSource* const before = source.get();
    const auto after = open_utf8(std::move(source));
    CHECK(after.get() == before);
    CHECK(read_all(*after) == text);
  }
}

TEST_CASE("Encoding: UTF-16 with and without a mark becomes UTF-8") {
  const std::string text = "t\tq\n0.5\t12.25\n";
  CHECK(utf8_of("\xFF\xFE" + utf16(text, true)) == text);
  CHECK(utf8_of("\xFE\xFF" + utf16(text, false)) == text);
  CHECK(utf8_of(utf16(text, true)) == text);
  CHECK(utf8_of(utf16(text, false)) == text);
  CHECK(utf8_of("\xFF\xFE" + utf16(text, true) + "x") == text + "\uFFFD");  // half a character
  CHECK(utf8_of("\xFF\xFE\x00\xD8"s + utf16("a\n", true)) == "\uFFFDa\n");  // half a pair
}

TEST_CASE("Encoding: code pages are found by their letters") {
  const std::pair<std::string, std::string> texts[] = {
      {"Zeit;H\xF6he (mm\xB3)\n1;2\n", "Zeit;Höhe (mm³)\n1;2\n"},
      {"Presi\xF3n;Deformaci\xF3n\n1;2\n", "Presión;Deformación\n1;2\n"},
      {"Varia\xE7\xE3o de volume\n1\n", "Variação de volume\n1\n"},
      {"\xC2\xF0\xE5\xEC\xFF, \xEC\xE8\xED\n1\n", "Время, мин\n1\n"},
      {"\xCA\xB1\xBC\xE4(min),\xBF\xD7\xD1\xB9\n1,2\n", "时间(min),孔压\n1,2\n"},
      {"\x8E\x9E\x8A\xD4,\x95\xCF\x88\xCA\n1,2\n", "時間,変位\n1,2\n"},
      {"\xBD\xC3\xB0\xA3,\xBA\xAF\xC0\xA7\n1,2\n", "시간,변위\n1,2\n"},
      {"Ci\x9Cnienie;Odkszta\xB3"
       "cenie\n1;2\n",
       "Ciśnienie;Odkształcenie\n1;2\n"},
      {"q,str,area\n[kPa],[\x89],[mm\xB2]\n1,2,3\n", "q,str,area\n[kPa],[‰],[mm²]\n1,2,3\n"},
      {"Bo\xFEluk suyu bas\xFDnc\xFD\n1\n", "Boşluk suyu basıncı\n1\n"}};
  for (const auto& [bytes, text] : texts) {
    INFO(text);
    CHECK(utf8_of(bytes) == text);
  }
}

TEST_CASE("Encoding: a name overrides what the bytes say") {
  CHECK(utf8_of("\xE9\n", "cp1251") == "й\n");
  CHECK(utf8_of("\xE9\n", "windows-1252") == "é\n");
  CHECK(utf8_of("\xE9\n", "Latin-1") == "é\n");
  CHECK(utf8_of("\xC3\xA9\n", "cp1252") == "Ã©\n");
  CHECK(utf8_of("\xC3\xA9\n", "") == "é\n");
  CHECK(utf8_of("\xEF\xBB\xBF\xC3\xA9\n", "utf-8-sig") == "\xEF\xBB\xBFé\n");
  CHECK_THROWS_WITH(utf8_of("a\n", "cp9999"),
                    Catch::Contains("m: encoding 'cp9999'") && Catch::Contains("Shift-JIS"));
  for (const std::string& name : encoding_names()) CHECK(utf8_of("", name).empty());
}

TEST_CASE("Encoding: bytes that are no character become U+FFFD") {
  CHECK(utf8_of("a\x81z\n", "cp1252") == "a\uFFFDz\n");
  CHECK(utf8_of("a\xFF\n", "utf-8") == "a\uFFFD\n");
  CHECK(utf8_of("\xCA", "gb18030") == "\uFFFD");
}

TEST_CASE("Encoding: lines that end with CR alone end with LF") {
  CHECK(utf8_of("a;b\r1;2\r") == "a;b\n1;2\n");
  CHECK(utf8_of("d\xE9"
                "but;b\r1;2\r") == "début;b\n1;2\n");
  CHECK(utf8_of("a\r\nb\n") == "a\r\nb\n");
}

TEST_CASE("Encoding: a long file is converted in blocks, and again after a rewind") {
  std::string bytes = "\xCA\xB1\xBC\xE4,\xBF\xD7\xD1\xB9\n";
  std::string text = "时间,孔压\n";
  for (int i = 0; i < 17; ++i) {
    bytes += bytes;
    text += text;
  }
  const auto source = open_utf8(open_memory("m", bytes));
  CHECK(read_all(*source, 777) == text);
  source->rewind();
  CHECK(read_all(*source, 100000) == text);
  source->rewind();
  std::string part(5, ' ');
  source->skip(3);
  CHECK(source->read(part) == 5);
  CHECK(part.substr(0, 4) == "间,");
  source->file().rewind();
  CHECK(read_all(source->file()) == bytes);
  CHECK(source->name() == "m");
}

TEST_CASE("Encoding: a sample may cut a character") {
  std::string text(kEncodingSample - 1, 'a');
  text += "é";
  text += std::string(3 * kEncodingSample, 'b');
  text += "é\n";
  for (std::size_t shift = 0; shift < 4; ++shift) {
    const auto bytes = std::string(shift, 'c') + text;
    CHECK(utf8_of(bytes) == bytes);
  }
}

TEST_CASE("Encoding: letters in the last rows count") {
  const auto rows = std::string(4 * kEncodingSample, '1') + "\n";
  CHECK(utf8_of(rows + "Gepr\xFC"
                       "ft\n") == rows + "Geprüft\n");
}

TEST_CASE("Encoding: any bytes become UTF-8") {
  std::string bytes;
  std::uint32_t state = 1;
  for (int i = 0; i < 200000; ++i) {
    state = state * 1664525U + 1013904223U;
    bytes += static_cast<char>(state >> 24U);
  }
  CHECK(is_utf8(utf8_of(bytes)));
  for (const std::string& name : encoding_names()) {
    INFO(name);
    CHECK(is_utf8(utf8_of(bytes + "\n", name)));
  }
}
