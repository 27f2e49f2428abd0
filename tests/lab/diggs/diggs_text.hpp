// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small DIGGS documents for tests. Values are made up.
#include <fmt/format.h>

#include <string>

namespace triax::lab::test {

inline std::string diggs(const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<Diggs xmlns=\"http://diggsml.org/schemas/2.6\" "
         "xmlns:geo=\"http://diggsml.org/schemas/2.6/geotechnical\" "
         "xmlns:gml=\"http://www.opengis.net/gml/3.2\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" gml:id=\"d\">\n" +
         content + "</Diggs>\n";
}

inline std::string increment(double q_kpa, double strain_pct, double u_kpa,
                             const std::string& more = "") {
  return fmt::format(
      "<geo:shearingIncrement><geo:ShearingIncrement>"
      "<geo:deviatorStress uom=\"kPa\">{}</geo:deviatorStress>"
      "<geo:axialStrain uom=\"%\">{}</geo:axialStrain>"
      "<geo:totalPoreWaterPressure uom=\"kPa\">{}</geo:totalPoreWaterPressure>{}"
      "</geo:ShearingIncrement></geo:shearingIncrement>\n",
      q_kpa, strain_pct, u_kpa, more);
}

inline std::string trial(const std::string& specimen, const std::string& shear) {
  return "<geo:trial><geo:TriaxialTestTrial><specimenRef xlink:href=\"#" + specimen +
         "\"/><geo:shearStage><geo:TriaxialTestShearStage>\n" + shear +
         "</geo:TriaxialTestShearStage></geo:shearStage></geo:TriaxialTestTrial></geo:trial>\n";
}

inline const std::string kCellPressure =
    "<geo:totalCellPressureDuringShearStage uom=\"kPa\">300"
    "</geo:totalCellPressureDuringShearStage>\n";

inline std::string specimen(const std::string& id, const std::string& conditions) {
  return "<specimen><SoilSpecimen gml:id=\"" + id + "\"><conditionPreTest><SpecimenConditions>" +
         conditions + "</SpecimenConditions></conditionPreTest></SoilSpecimen></specimen>\n";
}

inline std::string diggs_test(const std::string& name, const std::string& procedure,
                              const std::string& outcome = "") {
  return "<measurement><Test gml:id=\"t\"><gml:name>" + name + "</gml:name>\n" + outcome +
         "<procedure><geo:TriaxialTest>\n" + procedure +
         "</geo:TriaxialTest></procedure></Test></measurement>\n";
}

/// A table of results; `properties` as "name|class|uom" texts.
inline std::string result_set(std::initializer_list<std::string> properties,
                              const std::string& values, const std::string& marks = "") {
  std::string text =
      "<outcome><TestResult><results><ResultSet><parameters>"
      "<PropertyParameters><properties>\n";
  for (const std::string& property : properties) {
    const auto first = property.find('|'), second = property.find('|', first + 1);
    text += "<Property><propertyName>" + property.substr(0, first) +
            "</propertyName><propertyClass>" + property.substr(first + 1, second - first - 1) +
            "</propertyClass><uom>" + property.substr(second + 1) + "</uom></Property>\n";
  }
  return text + "</properties></PropertyParameters></parameters>\n<dataValues " + marks + ">" +
         values + "</dataValues></ResultSet></results></TestResult></outcome>\n";
}

}  // namespace triax::lab::test
