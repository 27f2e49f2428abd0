// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/diggs_delivery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/diggs/diggs_source.hpp"
#include "lab/diggs/xml_writer.hpp"
#include "lab/records/truth_toml.hpp"
#include "src/study/handover/ags_codes.hpp"
#include "src/study/handover/ags_delivery.hpp"
#include "src/study/handover/shear_values.hpp"
#include "src/study/triaxial/shear_series.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

constexpr const char* kDiggsNamespace = "http://diggsml.org/schemas/2.6";
/// Name space of property classes that are quantities of triax.
constexpr const char* kQuantitySpace = "urn:triax:quantity";
constexpr std::array kDiggsKeys{"PROJ_NAME", "PROJ_CLNT", "LOCA_ID",
                                "SAMP_REF",  "SAMP_TOP",  "SPEC_REF"};
constexpr double kPascals = 1e3, kFraction = 1e-2;  // of kPa, %

std::string said_of_project(const std::vector<AgsSaid>& said, std::string_view heading) {
  std::string value;
  for (const AgsSaid& one : said)
    if (one.heading == heading) value = one.value;
  return value;
}

std::string reference(const AgsCells& cells, const char* heading) {
  const auto found = cells.find(heading);
  return found == cells.end() ? std::string() : found->second;
}

sim::Unit si_unit(sim::Dimension dimension) {
  using enum sim::Dimension;
  switch (dimension) {
    case length:
      return *sim::find_unit("m");
    case area:
      return *sim::find_unit("m2");
    case volume:
      return *sim::find_unit("m3");
    case force:
      return *sim::find_unit("N");
    case pressure:
      return *sim::find_unit("Pa");
    default:
      return *sim::find_unit("");
  }
}

/// One test on its way out.
class DiggsTestWriter {
 public:
  DiggsTestWriter(lab::XmlWriter& xml, const db::Store& store, const db::StoredTest& test,
                  const std::vector<AgsSaid>& said)
      : xml_(xml),
        store_(store),
        test_(test),
        shear_(shear_values(store, test)),
        references_(ags_references(test, said)),
        type_(ags_test_type(test, shear_)) {}

  std::string location() const { return reference(references_, "LOCA_ID"); }
  /// `place` is the id of the location; empty if it is unknown.
  void write(const std::string& place);

 private:
  std::string id(std::string_view part = {}) const {
    return fmt::format("test-{}{}{}", test_.id, part.empty() ? "" : "-", part);
  }
  void refer_to_sample();
  void write_readings();
  void write_property(std::size_t index, std::string_view name, std::string_view uom);
  void choose_units();
  void write_rows();
  void write_procedure();
  /// Left out if the value is empty.
  void parameter(std::string_view name, std::string_view value, std::string_view unit = {});
  void write_parameter(std::string_view name, std::string_view value, std::string_view unit);
  void write_results();
  void write_metadata();
  void write_specimen();
  void write_conditions();
  void write_trial();
  void write_membrane();
  void write_shear_stage();
  void write_increments();
  void measure(const char* element, std::optional<double> si, double unit_si, const char* uom) {
    if (si && std::isfinite(*si))
      xml_.leaf(element, fmt::format("{}", *si / unit_si), {{"uom", uom}});
  }
  /// A value of the specimen with the digits from which it is read back.
  void specimen_value(const char* element, const std::optional<double>& si, const char* unit,
                      const char* uom) {
    if (!si) return;
    const auto text = fmt::format("{}", sim::to_field(*si, *sim::find_unit(unit)));
    if (*uom != 0)
      xml_.leaf(element, text, {{"uom", uom}});
    else
      xml_.leaf(element, text);
  }

  lab::XmlWriter& xml_;
  const db::Store& store_;
  const db::StoredTest& test_;
  ShearValues shear_;
  AgsCells references_;
  std::string type_;
  std::vector<std::pair<lab::Quantity, sim::Unit>> columns_;  ///< with the units of the cells
};

void DiggsTestWriter::write(const std::string& place) {
  xml_.open("measurement");
  xml_.open("Test", {{"gml:id", id()}});
  xml_.leaf("gml:name", test_.header.name);
  if (const auto remark = ags_remark(test_); !remark.empty()) {
    xml_.open("remark");
    xml_.open("Remark");
    xml_.leaf("content", remark);
    xml_.close();
    xml_.close();
  }
  xml_.leaf("investigationTarget", "Natural Ground");
  xml_.empty("projectRef", {{"xlink:href", "#project"}});
  if (!place.empty()) xml_.empty("samplingFeatureRef", {{"xlink:href", "#" + place}});
  refer_to_sample();
  write_readings();
  write_procedure();
  xml_.close();
  xml_.close();
}

/// The sample itself is no feature of the document: who took it, and when, is not known.
void DiggsTestWriter::refer_to_sample() {
  const auto sample = reference(references_, "SAMP_REF");
  if (sample.empty())
    xml_.empty("sampleRef", {{"nilReason", "unknown"}});
  else
    xml_.empty("sampleRef", {{"xlink:title", sample}, {"nilReason", "missing"}});
}

void DiggsTestWriter::write_readings() {
  xml_.open("outcome");
  xml_.open("TestResult", {{"gml:id", id("result")}});
  if (const auto depth = reference(references_, "SAMP_TOP"); depth.empty()) {
    xml_.empty("location", {{"nilReason", "unknown"}});
  } else {
    xml_.open("location");
    xml_.open("PointLocation", {{"gml:id", id("depth")}});
    xml_.leaf("gml:pos", depth,
              {{"srsDimension", "1"}, {"axisLabels", "depth"}, {"uomLabels", "m"}});
    xml_.close();
    xml_.close();
  }
  xml_.open("results");
  xml_.open("ResultSet");
  xml_.open("parameters");
  xml_.open("PropertyParameters", {{"gml:id", id("parameters")}});
  xml_.open("properties");
  choose_units();
  std::size_t index = 0;
  if (test_.header.has_time) write_property(++index, "time", "s");
  write_property(++index, "stage", "");
  for (const auto& [quantity, unit] : columns_)
    write_property(++index, info(quantity).name, unit.name);
  for (int level = 0; level < 3; ++level) xml_.close();
  write_rows();
  for (int level = 0; level < 4; ++level) xml_.close();
}

void DiggsTestWriter::write_property(std::size_t index, std::string_view name,
                                     std::string_view uom) {
  xml_.open("Property",
            {{"gml:id", id(fmt::format("property-{}", index))}, {"index", std::to_string(index)}});
  xml_.leaf("propertyName", name);
  xml_.leaf("typeData", "double");
  xml_.leaf("propertyClass", name, {{"codeSpace", kQuantitySpace}});
  if (!uom.empty()) xml_.leaf("uom", uom);
  xml_.close();
}

/// The usual unit of a column, or the SI unit if a value would not be read back bit for bit.
void DiggsTestWriter::choose_units() {
  for (const lab::Quantity quantity : test_.header.columns)
    columns_.emplace_back(quantity, *sim::find_unit(info(quantity).unit));
  std::vector<bool> is_exact(columns_.size(), true);
  store_.for_each_scan(test_.id, 1, [&](const lab::Reading& reading, const lab::State&) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto& [quantity, unit] = columns_[i];
      const double si = reading[quantity];
      is_exact[i] =
          is_exact[i] && (std::isnan(si) || sim::to_si(sim::to_field(si, unit), unit) == si);
    }
  });
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (!is_exact[i]) columns_[i].second = si_unit(columns_[i].second.dimension);
}

void DiggsTestWriter::write_rows() {
  xml_.plain("<dataValues cs=\",\" decimal=\".\" ts=\" \">\n");
  std::string row;
  const auto append = [&](double value) {
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(row), "{}", value);
  };
  store_.for_each_scan(test_.id, 1, [&](const lab::Reading& reading, const lab::State&) {
    row.clear();
    if (test_.header.has_time) {
      append(reading.time_s);
      row += ',';
    }
    row += std::to_string(reading.stage);
    for (const auto& [quantity, unit] : columns_) {
      row += ',';
      append(sim::to_field(reading[quantity], unit));
    }
    xml_.plain(row += '\n');
  });
  xml_.plain("</dataValues>\n");
}

void DiggsTestWriter::write_procedure() {
  xml_.open("procedure");
  xml_.open("diggs_geo:TriaxialTest", {{"gml:id", id("procedure")}});
  write_results();
  write_metadata();
  write_specimen();
  if (!type_.empty()) xml_.leaf("diggs_geo:triaxialTestType", type_);
  write_trial();
  xml_.close();
  xml_.close();
}

void DiggsTestWriter::parameter(std::string_view name, std::string_view value,
                                std::string_view unit) {
  if (!value.empty()) write_parameter(name, value, unit);
}

void DiggsTestWriter::write_parameter(std::string_view name, std::string_view value,
                                      std::string_view unit) {
  xml_.open("otherTestProperty");
  xml_.open("Parameter");
  xml_.leaf("parameterName", name);
  xml_.leaf("parameterValue", value);
  if (!unit.empty()) xml_.leaf("parameterUnits", unit);
  xml_.close();
  xml_.close();
}

void DiggsTestWriter::write_results() {
  const auto number = [](const std::optional<double>& si, double unit) {
    return si && std::isfinite(*si) ? fmt::format("{}", *si / unit) : std::string();
  };
  const bool simulated = test_.header.origin == lab::Origin::simulated;
  parameter("origin of the readings", simulated ? "SIMULATED, not measured" : "recorded");
  parameter("software", fmt::format("triax {}", version()));
  parameter("kind of collapse", ags_kind(test_));
  const auto& summary = test_.summary;
  parameter("mean effective stress at the start of shear",
            number(summary.consolidation.p_eff_pa, kPascals), "kPa");
  parameter("B value", number(summary.consolidation.b_value, 1));
  const auto write_instant = [&](const std::string& what, const lab::Instant& at) {
    parameter("time at the " + what, number(at.time_s, 1), "s");
    parameter("axial strain at the " + what, number(at.axial_strain, kFraction), "%");
    parameter("deviator stress at the " + what, number(at.q_pa, kPascals), "kPa");
    parameter("mean effective stress at the " + what, number(at.p_eff_pa, kPascals), "kPa");
    parameter("pore pressure at the " + what, number(at.pore_pressure_pa, kPascals), "kPa");
    parameter("stress ratio at the " + what, number(at.eta(), 1));
  };
  if (summary.peak) write_instant("peak of the deviator stress", *summary.peak);
  if (const auto onset = collapse_onset(test_)) write_instant("onset of instability", *onset);
  if (const auto& lost = summary.collapse.loss_of_control) write_instant("loss of control", *lost);
}

/// Keys that no element of DIGGS holds.
void DiggsTestWriter::write_metadata() {
  const lab::RecordHeader& header = test_.header;
  const auto key = [&](const std::string& name, std::string_view value) {
    parameter(std::string(lab::kDiggsKeyPrefix) + name, value);
  };
  if (header.origin == lab::Origin::simulated) key("test.origin", "simulated");
  // Also an empty one: the type is a conclusion then.
  if (header.programme != type_)
    write_parameter(std::string(lab::kDiggsKeyPrefix) + "test.programme", header.programme, {});
  if (header.seed) key("test.seed", std::to_string(*header.seed));
  key("test.cut_short", header.cut_short);
  if (const auto& angle = header.specimen.limit_friction_angle_rad)
    key("specimen.limit_friction_angle_deg",
        fmt::format("{}", sim::to_field(*angle, *sim::find_unit("deg"))));
  for (const lab::Quantity channel : header.vouched)
    key(fmt::format("sensors.{}", info(channel).name), "sound");
  for (const lab::StageInfo& stage : header.stages) {
    const auto prefix = fmt::format("stages.{}.", stage.number);
    key(prefix + "name", stage.name);
    key(prefix + "role", to_string(stage.role));
    key(prefix + "drainage", to_string(stage.drainage));
    key(prefix + "control", to_string(stage.control));
    if (stage.strain_path_R) key(prefix + "strain_path_R", fmt::format("{}", *stage.strain_path_R));
  }
  if (test_.summary.truth) key("truth", lab::truth_toml(*test_.summary.truth));
}

void DiggsTestWriter::write_specimen() {
  const lab::SpecimenInfo& specimen = test_.header.specimen;
  xml_.open("specimen");
  xml_.open("SoilSpecimen", {{"gml:id", id("specimen")}});
  if (!specimen.material.empty()) xml_.leaf("gml:description", specimen.material);
  xml_.leaf("gml:name", reference(references_, "SPEC_REF"));
  refer_to_sample();
  write_conditions();
  specimen_value("specificGravityOfSolids", specimen.specific_gravity, "", "");
  xml_.close();
  xml_.close();
}

void DiggsTestWriter::write_conditions() {
  const lab::SpecimenInfo& specimen = test_.header.specimen;
  xml_.open("conditionPreTest");
  xml_.open("SpecimenConditions", {{"gml:id", id("as-built")}});
  specimen_value("dryWeight", specimen.dry_mass_kg, "g", "gf");
  specimen_value("diameter", specimen.diameter_m, "mm", "mm");
  specimen_value("height", specimen.height_m, "mm", "mm");
  xml_.leaf("shape", "cylinder");
  specimen_value("voidRatio", specimen.void_ratio, "", "");
  xml_.close();
  xml_.close();
  if (!specimen.consolidated_height_m && !specimen.consolidated_void_ratio) return;
  xml_.open("conditionPostTest");
  xml_.open("SpecimenConditions", {{"gml:id", id("consolidated")}});
  specimen_value("height", specimen.consolidated_height_m, "mm", "mm");
  specimen_value("voidRatio", specimen.consolidated_void_ratio, "", "");
  xml_.close();
  xml_.close();
}

void DiggsTestWriter::write_trial() {
  xml_.open("diggs_geo:trial");
  xml_.open("diggs_geo:TriaxialTestTrial", {{"gml:id", id("trial")}});
  xml_.empty("specimenRef", {{"xlink:href", "#" + id("specimen")}});
  write_membrane();
  write_shear_stage();
  xml_.close();
  xml_.close();
}

void DiggsTestWriter::write_membrane() {
  const lab::SpecimenInfo& specimen = test_.header.specimen;
  if (!specimen.membrane_thickness_m && !specimen.membrane_modulus_pa) return;
  xml_.open("diggs_geo:membraneInfo");
  xml_.open("diggs_geo:MembraneInfo", {{"gml:id", id("membrane")}});
  specimen_value("diggs_geo:membraneThickness", specimen.membrane_thickness_m, "mm", "mm");
  specimen_value("diggs_geo:membraneYoungsModulus", specimen.membrane_modulus_pa, "kPa", "kPa");
  xml_.close();
  xml_.close();
}

void DiggsTestWriter::write_shear_stage() {
  if (!shear_.start || !shear_.failure || std::isnan(shear_.failure->state.pore_pressure)) return;
  const lab::State& failure = shear_.failure->state;
  const lab::StageInfo* const stage = test_.header.stage(failure.stage);
  xml_.open("diggs_geo:shearStage");
  xml_.open("diggs_geo:TriaxialTestShearStage", {{"gml:id", id("shear")}});
  measure("diggs_geo:axialStrainAtFailure", failure.strain.axial, kFraction, "%");
  measure("diggs_geo:deviatorStressAtFailure", failure.q, kPascals, "kPa");
  xml_.leaf("diggs_geo:failureCriterion", "maximum deviator stress");
  measure("diggs_geo:totalPorewaterPressureAtFailure", failure.pore_pressure, kPascals, "kPa");
  measure("diggs_geo:porewaterPressureStartOfShearing", shear_.start->state.pore_pressure, kPascals,
          "kPa");
  write_increments();
  if (stage != nullptr && stage->drainage == lab::Drainage::closed)
    measure("diggs_geo:undrainedShearStrengthAtFailure", std::abs(failure.q) / 2, kPascals, "kPa");
  xml_.close();
  xml_.close();
}

void DiggsTestWriter::write_increments() {
  const double start_s = shear_.start->state.time_s;
  store_.for_each_scan(test_.id, 1, [&](const lab::Reading&, const lab::State& state) {
    if (!is_shear(test_.header, state.stage)) return;
    if (std::isnan(state.q) || std::isnan(state.strain.axial) || std::isnan(state.pore_pressure))
      return;
    xml_.open("diggs_geo:shearingIncrement");
    xml_.open("diggs_geo:ShearingIncrement",
              {{"gml:id", id(fmt::format("reading-{}", state.reading))}});
    measure("diggs_geo:deviatorStress", state.q, kPascals, "kPa");
    measure("diggs_geo:axialStrain", state.strain.axial, kFraction, "%");
    measure("diggs_geo:elapsedTime", state.time_s - start_s, 1, "s");
    measure("diggs_geo:totalPoreWaterPressure", state.pore_pressure, kPascals, "kPa");
    xml_.close();
    xml_.close();
  });
}

void write_project(lab::XmlWriter& xml, const std::vector<AgsSaid>& said) {
  const auto name = said_of_project(said, "PROJ_NAME");
  xml.open("project");
  xml.open("Project", {{"gml:id", "project"}});
  xml.leaf("gml:name", name.empty() ? lab::kUnnamedProject : name);
  if (const auto client = said_of_project(said, "PROJ_CLNT"); !client.empty()) {
    xml.open("role");
    xml.open("Role");
    xml.leaf("rolePerformed", "Client");
    xml.open("businessAssociate");
    xml.open("BusinessAssociate", {{"gml:id", "client"}});
    xml.leaf("gml:name", client);
    for (int level = 0; level < 4; ++level) xml.close();
  }
  xml.close();
  xml.close();
}

/// A location of which the coordinates are not known is a point of unknown position.
void write_location(lab::XmlWriter& xml, const std::string& id, const std::string& name) {
  xml.open("samplingFeature");
  xml.open("Station", {{"gml:id", id}});
  xml.leaf("gml:name", name);
  xml.leaf("investigationTarget", "Natural Ground");
  xml.empty("projectRef", {{"xlink:href", "#project"}});
  xml.empty("referencePoint", {{"nilReason", "unknown"}});
  xml.close();
  xml.close();
}

}  // namespace

AgsSaid diggs_said(const std::string& key, const std::string& value) {
  AgsSaid said = ags_said(key, value);
  if (std::ranges::find(kDiggsKeys, said.heading) != kDiggsKeys.end()) return said;
  throw lab::BadInput(fmt::format("--set {}: not in a DIGGS file; {}", key,
                                  lab::must_be_one_of({kDiggsKeys.begin(), kDiggsKeys.end()})));
}

void write_diggs(const db::Store& store, const std::vector<db::StoredTest>& tests,
                 const std::vector<AgsSaid>& said, const std::string& date,
                 const std::function<void(std::string_view)>& write) {
  lab::XmlWriter xml(write);
  const std::string diggs = kDiggsNamespace;
  xml.open("Diggs", {{"xmlns", diggs},
                     {"xmlns:diggs_geo", diggs + "/geotechnical"},
                     {"xmlns:gml", "http://www.opengis.net/gml/3.2"},
                     {"xmlns:xlink", "http://www.w3.org/1999/xlink"},
                     {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
                     {"xsi:schemaLocation", diggs + " " + diggs + "/Diggs.xsd"},
                     {"gml:id", "document"}});
  xml.open("documentInformation");
  xml.open("DocumentInformation", {{"gml:id", "document-information"}});
  xml.leaf("creationDate", date);
  xml.close();
  xml.close();
  write_project(xml, said);
  std::vector<std::string> locations;
  for (const db::StoredTest& test : tests) {
    const auto name = reference(ags_references(test, said), "LOCA_ID");
    if (name.empty() || std::ranges::find(locations, name) != locations.end()) continue;
    locations.push_back(name);
    write_location(xml, fmt::format("location-{}", locations.size()), name);
  }
  for (const db::StoredTest& test : tests) {
    DiggsTestWriter writer(xml, store, test, said);
    const auto place = std::ranges::find(locations, writer.location());
    writer.write(place == locations.end()
                     ? std::string()
                     : fmt::format("location-{}", place - locations.begin() + 1));
  }
  xml.finish();
}

}  // namespace triax::study
