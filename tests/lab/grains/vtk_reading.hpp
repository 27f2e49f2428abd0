// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads a VTK XML file back, as any XML reader would.
#include <QXmlStreamReader>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace triax::lab::test {

struct VtkRead {
  bool well_formed = false;
  std::string comment, type;
  std::map<std::string, std::string> piece;  ///< attributes
  std::map<std::string, std::vector<double>> arrays;
  std::map<std::string, std::map<std::string, std::string>> array_attributes;
  std::map<std::string, std::string> parents;  ///< element that an array stands in
  std::vector<std::map<std::string, std::string>> data_sets;
};

inline VtkRead read_vtk(const std::string& text) {
  QXmlStreamReader xml(QByteArray::fromStdString(text));
  VtkRead read;
  std::vector<std::string> open;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isComment() && read.comment.empty()) read.comment = xml.text().toString().toStdString();
    if (xml.isEndElement()) open.pop_back();
    if (!xml.isStartElement()) continue;
    const std::string name = xml.name().toString().toStdString();
    std::map<std::string, std::string> attributes;
    for (const auto& one : xml.attributes())
      attributes[one.name().toString().toStdString()] = one.value().toString().toStdString();
    if (name == "VTKFile") read.type = attributes["type"];
    if (name == "Piece") read.piece = attributes;
    if (name == "DataSet") read.data_sets.push_back(attributes);
    if (name != "DataArray") {
      open.push_back(name);
      continue;
    }
    const std::string array = attributes["Name"];
    read.parents[array] = open.back();
    read.array_attributes[array] = attributes;
    std::istringstream numbers(xml.readElementText().toStdString());
    for (double x = 0; numbers >> x;) read.arrays[array].push_back(x);
  }
  read.well_formed = !xml.hasError();
  return read;
}

}  // namespace triax::lab::test
