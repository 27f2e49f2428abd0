// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_report.hpp"
#include "src/domain/domain_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/src/sample_domain.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;
using Catch::Contains;

TEST_CASE("a domain in the units of the field: kPa, degrees, and eta with its sign") {
  const ReportedDomain domain = sample_domain();
  const auto computed = sim::domain_column(*sample_material().material.axisymmetric,
                                           domain_grid(domain.settings.grid), 1);
  const ReportedColumn& column = domain.columns.at(1);
  CHECK(column.p_eff_kPa == computed.p / 1e3);
  CHECK(column.compression.first_unstable->q_kPa == *computed.compression.first_unstable_q / 1e3);
  CHECK(*column.compression.first_unstable->alpha_deg ==
        Approx(*computed.compression.first_unstable_angle * 180 / M_PI));
  CHECK(column.extension.limit->eta == *computed.extension.limit_q / computed.p);
  CHECK(column.extension.limit->eta < 0);
  CHECK_FALSE(column.compression.mark("localisation"));
  const auto back = domain_columns(domain);
  REQUIRE(back.size() == domain.columns.size());
  CHECK(back[1].states.size() == computed.states.size());
  CHECK(*back[1].compression.isotropic_unloading_q ==
        Approx(*computed.compression.isotropic_unloading_q).epsilon(1e-14));
  for (std::size_t i = 0; i < computed.states.size(); ++i) {
    CHECK(back[1].states[i].kind == computed.states[i].kind);
    CHECK(back[1].states[i].cones.size() == computed.states[i].cones.size());
  }
}

TEST_CASE("the document says that it is simulated, of what, and null for what is unknown") {
  const ReportedDomain domain = sample_domain();
  const auto json = nlohmann::json::parse(domain_json(domain));
  CHECK(json["origin"] == "simulated");
  CHECK(json["material"]["name"] == "inl2/S28-general");
  CHECK(json["material"]["based_on"].is_string());
  CHECK(json["material"]["parameters"]["hardening_factor"] == "1.996");
  CHECK(json["grid"]["p_from_kPa"] == 50.0);
  CHECK(json["grid"]["plane"] == "axisymmetric");
  CHECK(json["grid"]["directions"] == 36);
  REQUIRE(json["boundaries"].size() == 2 * domain.columns.size());
  const auto& boundary = json["boundaries"][0];
  CHECK(boundary["side"] == "compression");
  CHECK(boundary["first_unstable"]["eta"].get<double>() > 0);
  CHECK(boundary["first_unstable"]["alpha_deg"].get<double>() == Approx(225.6).margin(0.5));
  CHECK(boundary["localisation"].is_null());
  CHECK(boundary["limit"]["alpha_deg"].is_null());
  CHECK(json["boundaries"][1]["side"] == "extension");
  REQUIRE(json["states"].size() == 3 * 12);
  int unstable = 0, beyond = 0;
  for (const auto& state : json["states"]) {
    const bool known = state["w2_normalised_least"].is_number();
    CHECK(known == (state["kind"] == "stable" || state["kind"] == "unstable"));
    CHECK((state["kind"] == "unstable") == !state["cones"].empty());
    unstable += state["kind"] == "unstable";
    beyond += state["kind"] == "beyond_limit";
  }
  CHECK(unstable > 0);
  CHECK(beyond > 0);
  CHECK(json["refused"]["states"] == 0);
  CHECK(json["refused"]["reason"].is_null());
}

TEST_CASE("the text tells the boundaries of both sides and the shares of the states") {
  const std::string text = domain_text(sample_domain());
  CHECK_THAT(text, Contains("(simulated)") && Contains("compression") && Contains("extension"));
  CHECK_THAT(text, Contains("stable ") && Contains("beyond the limit "));
  CHECK_THAT(text, !Contains(" nan") && !Contains("refused   "));
}

TEST_CASE("what a law refuses is told with its words; a set out of its range is warned of") {
  ReportedDomain domain = sample_domain();
  domain.columns[2].refusal = "the law has no such state";
  domain.columns[2].states[0].kind = sim::DomainStateKind::refused;
  CHECK_THAT(domain_text(domain), Contains("first at p′ 150 kPa: the law has no such state"));
  const auto json = nlohmann::json::parse(domain_json(domain));
  CHECK(json["refused"]["states"] == 1);
  CHECK(json["refused"]["reason"] == "the law has no such state");
  auto grid = domain.settings.grid;
  grid.void_ratio = 1.4;
  const auto settings = domain_settings(sample_material(), grid);
  REQUIRE(settings.warnings.size() == 1);
  CHECK_THAT(settings.warnings[0], Contains("void ratio is 1.4"));
}

TEST_CASE("a state of which not all directions are answered has a word and a share of its own") {
  ReportedDomain domain = sample_domain();
  CHECK_THAT(domain_text(domain), !Contains("unknown"));
  for (auto& state : domain.columns[0].states) state.kind = sim::DomainStateKind::unknown;
  CHECK_THAT(domain_text(domain), Contains("unknown 33.3 %"));
  CHECK_THAT(domain_states_csv(domain), Contains(",unknown,"));
  CHECK(nlohmann::json::parse(domain_json(domain))["states"][0]["kind"] == "unknown");
}

TEST_CASE("every cone is in the table, as many columns as the widest state needs") {
  ReportedDomain domain = sample_domain();
  CHECK_THAT(domain_states_csv(domain), !Contains("cone_3"));
  domain.columns[0].states[0].least_work = -0.1;
  domain.columns[0].states[0].cones_deg = {{1, 2}, {3, 4}, {5, 6.5}};
  const std::string csv = domain_states_csv(domain);
  CHECK_THAT(csv, Contains("cone_3_from_deg,cone_3_to_deg,refused_directions"));
  CHECK_THAT(csv, Contains(",3,1,2,3,4,5,6.5,"));
}

TEST_CASE("a criterion that was not looked for has no column, one that was not met an empty cell") {
  ReportedDomain domain = sample_domain();
  for (const bool determinant : {false, true}) {
    domain.settings.grid.criteria.clear();
    if (determinant) domain.settings.grid.criteria.emplace_back("determinant");
    CHECK((domain_text(domain).find("η determinant") != std::string::npos) == determinant);
    CHECK((domain_boundaries_csv(domain).find("determinant_q_kPa") != std::string::npos) ==
          determinant);
  }
  CHECK_THAT(domain_text(domain), !Contains("localisation"));
  CHECK_THAT(domain_boundaries_csv(domain), !Contains("localisation"));
}

TEST_CASE("the tables have a line a state and a line a boundary, of equal numbers of cells") {
  const ReportedDomain domain = sample_domain();
  for (const auto& [csv, lines] : {std::pair(domain_states_csv(domain), 3 + 3 * 12),
                                   std::pair(domain_boundaries_csv(domain), 3 + 3 * 2)}) {
    CHECK(csv.rfind("# origin = \"simulated\"\n", 0) == 0);
    std::istringstream stream(csv);
    std::string line;
    int count = 0;
    std::ptrdiff_t commas = -1;
    while (std::getline(stream, line)) {
      if (++count < 3) continue;
      const auto here = std::count(line.begin(), line.end(), ',');
      if (commas < 0) commas = here;
      CHECK(here == commas);
    }
    CHECK(count == lines);
  }
}
