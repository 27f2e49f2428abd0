// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The triaxial tests of a DIGGS document: elements as they stand, without what they mean.
//
// Names of elements, their order and the reading of units are those of the schema of DIGGS 2.6
// (namespaces http://diggsml.org/schemas/2.6 and .../2.6/geotechnical: Kernel.xsd, Geotechnical.xsd
// and the deprecated part of the latter, GML 3.2). Namespaces are not compared: 2.5 and later
// versions name what is read here alike.
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

/// Text of an element with its unit of measure.
struct DiggsValue {
  std::string text, uom;
  std::int64_t line = 0;
};
using DiggsValues = std::map<std::string, DiggsValue, std::less<>>;

struct DiggsSpecimen {
  std::string id;
  std::string name, description;
  std::string sample;  ///< its title, or the name of the sample it refers to
  DiggsValues before;  ///< conditionPreTest
  DiggsValues after;   ///< conditionPostTest: after consolidation
  DiggsValues other;   ///< of the specimen itself
};

/// One shearingIncrement: its elements by name.
struct DiggsIncrement {
  std::int64_t line = 0;
  std::array<DiggsValue, 8> values;
};
/// Elements of a shearingIncrement, in the order of DiggsIncrement::values.
inline constexpr std::array<std::string_view, 8> kIncrementElements{
    "axialLoad",   "axialDeflection",          "deviatorStress",         "axialStrain",
    "elapsedTime", "inducedPoreWaterPressure", "totalPoreWaterPressure", "totalCellPressure"};

struct DiggsTrial {
  std::int64_t line = 0;
  std::string specimen;  ///< id
  DiggsValues values;    ///< of membrane, saturation, consolidation and shear stage
  std::vector<DiggsIncrement> shearing;
  std::int64_t other_increments = 0;  ///< of saturation and consolidation
};

struct DiggsProperty {
  std::string name, property_class, uom, null_value;
};

/// A table of results.
struct DiggsResultSet {
  std::int64_t line = 0;  ///< in which the values begin
  std::vector<DiggsProperty> properties;
  std::string values, cell_separator = ",", tuple_separator = " ", decimal_mark = ".";
};

struct DiggsParameter {
  std::string name, value, unit;
  std::int64_t line = 0;
};

struct DiggsTest {
  std::int64_t line = 0;
  std::string id, name, type;
  std::string project, client, location, sample;  ///< names
  DiggsValue depth;            ///< coordinates of the location; uom is their number, if given
  bool has_procedure = false;  ///< a TriaxialTest
  std::vector<DiggsSpecimen> specimens;
  std::vector<DiggsTrial> trials;
  std::vector<DiggsResultSet> result_sets;
  std::vector<DiggsParameter> parameters;
};

struct DiggsDocument {
  std::string file;
  std::vector<DiggsTest> tests;                   ///< triaxial ones, in the order of the file
  std::map<std::string, int> other_procedures{};  ///< names and how many
};

/// True for XML whose root element is Diggs, and for a file that is XML and named .diggs.
bool looks_like_diggs(ByteSource& source);

/// Reads the whole file. Throws BadInput "FILE:LINE: ..." for broken XML, a document type
/// declaration (and so entities), elements nested deeper than 100, texts of more than 1 MB beside
/// tables of results, and files of more than 256 MB.
DiggsDocument read_diggs(ByteSource& source);

}  // namespace triax::lab
