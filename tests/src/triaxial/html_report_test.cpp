// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/html_report.hpp"

#include <QXmlStreamReader>
#include <catch2/catch.hpp>

#include "tests/src/sample_sheets.hpp"

using namespace triax::src;
using namespace triax::study;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("one file, nothing from outside, figures inside, hostile names harmless") {
  auto hostile = test::flow_test();
  hostile.stored.header.name = "<script>alert(\"1\")</script> & 'x'";
  const std::string html = html_report(test::sheets_of(
      {hostile, test::simulated_test(), test::stable_test(), test::interrupted_test()}));
  CHECK(count(html, "<script") == 0);
  CHECK(count(html, "&lt;script&gt;") >= 1);
  CHECK(count(html, "<link") == 0);
  CHECK(count(html, "src=\"http") == 0);
  CHECK(count(html, "<svg") >= 20);  // q, u, eta, path, circle of each; those of the set
  CHECK(count(html, "SIMULATED") >= 1);
  CHECK(count(html, "INTERRUPTED") >= 1);
  for (const char* unit : {"(kPa)", "(°)", " mm"}) CHECK(count(html, unit) >= 1);
}

TEST_CASE("every figure inside is well-formed") {
  const std::string html = html_report(test::sheets_of({test::flow_test()}, true));
  std::size_t figures = 0;
  for (auto at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1)) {
    const auto end = html.find("</svg>", at);
    REQUIRE(end != std::string::npos);
    QXmlStreamReader reader(QByteArray::fromStdString(html.substr(at, end + 6 - at)));
    int paths = 0, texts = 0;
    while (!reader.atEnd()) {
      reader.readNext();
      if (!reader.isStartElement()) continue;
      paths += reader.name() == u"path" || reader.name() == u"polyline";
      texts += reader.name() == u"text";
    }
    INFO(reader.errorString().toStdString());
    CHECK_FALSE(reader.hasError());
    CHECK(paths > 5);
    CHECK(texts > 5);
    ++figures;
  }
  CHECK(figures == 8);  // five of the sheet, three of the evidence
}
