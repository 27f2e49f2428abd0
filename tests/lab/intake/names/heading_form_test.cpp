// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/heading_form.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

std::string key_of(std::string_view text) {
  return heading_key(repair_heading(text)).toStdString();
}

std::vector<std::string> heading_tokens_of(std::string_view text) {
  std::vector<std::string> tokens;
  for (const QString& token : heading_tokens(repair_heading(text)))
    tokens.push_back(token.toStdString());
  return tokens;
}

using TokenTexts = std::vector<std::string>;

}  // namespace

TEST_CASE("repair_heading: broken encodings and look-alike characters are replaced") {
  CHECK(repair_heading("Ïƒ (kN/mÂ²)").toStdString() == "σ (kN/m2)");
  CHECK(repair_heading("𝜎₃′").toStdString() == "σ3'");
  CHECK(repair_heading("ｋＰａ　（％）").toStdString() == "kPa (%)");
  CHECK(repair_heading("e\u0301").toStdString() == "é");
  CHECK(repair_heading("p\u0304").toStdString() == "p'");
  CHECK(repair_heading("plain").toStdString() == "plain");
}

TEST_CASE("heading_tokens: words, scripts and signs are separated") {
  CHECK(heading_tokens_of("Cell_Press. No.1") == TokenTexts{"cell", "pressure", "no", "1"});
  CHECK(heading_tokens_of("CellPress") == TokenTexts{"cell", "pressure"});
  CHECK(heading_tokens_of("轴向应变ε1") == TokenTexts{"轴向应变", "ε1"});
  CHECK(heading_tokens_of("q / p '") == TokenTexts{"q/p'"});
  CHECK(heading_tokens_of("Contraintes, gas") == TokenTexts{"contrainte", "gas"});
  CHECK(heading_tokens_of("...") == TokenTexts{});
}

TEST_CASE("heading_key: letter case, accents, signs and plural do not matter") {
  CHECK(key_of("Déformation-Axiale") == "deformationaxiale");
  CHECK(key_of("DEFORMATION AXIALE") == "deformationaxiale");
  CHECK(key_of("Объём") == key_of("объем"));
  CHECK(key_of("") == "");
}

TEST_CASE("name_keys: an umlaut has two forms") {
  CHECK(name_keys("Höhe") == std::vector<QString>{"hohe", "hoehe"});
  CHECK(name_keys("Kraft") == std::vector<QString>{"kraft"});
}
