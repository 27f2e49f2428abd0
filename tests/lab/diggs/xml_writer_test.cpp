// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/xml_writer.hpp"

#include <catch2/catch.hpp>

using triax::lab::XmlWriter;

TEST_CASE("XmlWriter: elements, attributes and escaped text") {
  std::string text;
  XmlWriter xml([&](std::string_view piece) { text += piece; });
  xml.open("a", {{"x", "1 \"2\" <3>"}});
  xml.leaf("b", "p & q < r");
  xml.empty("c");
  xml.plain("1,2\n");
  xml.finish();
  CHECK(text ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<a x=\"1 &quot;2&quot; &lt;3&gt;\">\n  <b>p &amp; q &lt; r</b>\n  <c/>\n1,2\n</a>\n");
}

TEST_CASE("XmlWriter: characters that XML does not have become question marks") {
  std::string text;
  XmlWriter xml([&](std::string_view piece) { text += piece; });
  xml.leaf("b", "\x01\t\n\xEF\xBF\xBF|\xE9|");
  xml.finish();
  CHECK(text.find("<b>?&#9;&#10;?|\xC3\xA9|</b>") == std::string::npos);
  CHECK(text.find("<b>?&#9;&#10;") != std::string::npos);
}
