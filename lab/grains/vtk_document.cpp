// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/vtk_document.hpp"

#include <fmt/format.h>

#include <QXmlStreamWriter>
#include <iterator>

namespace triax::lab {
namespace {

constexpr int kNumbersALine = 12;

template <class T>
VtkArray array_of(const std::string& name, const char* type, const std::vector<T>& values,
                  int components) {
  VtkArray array{name, type, components, {}};
  for (std::size_t k = 0; k < values.size(); ++k)
    fmt::format_to(std::back_inserter(array.text), "{}{}", values[k],
                   k % kNumbersALine == kNumbersALine - 1 ? '\n' : ' ');
  return array;
}

/// One XML document, from its first line on. A comment must not hold two dashes.
class Document {
 public:
  Document(const char* type, std::string comment) : xml_(&bytes_) {
    for (std::size_t at = 0; (at = comment.find("--", at)) != std::string::npos;)
      comment[at + 1] = ' ';
    if (!comment.empty() && comment.back() == '-') comment += ' ';
    xml_.writeStartDocument();
    xml_.writeComment(' ' + QString::fromStdString(comment) + ' ');
    xml_.writeCharacters("\n");
    open("VTKFile");
    attribute("type", type);
    attribute("version", "1.0");
    attribute("byte_order", "LittleEndian");
    attribute("header_type", "UInt64");
  }
  void open(const char* name) { xml_.writeStartElement(name); }
  void attribute(const char* name, const std::string& value) {
    xml_.writeAttribute(name, QString::fromStdString(value));
  }
  void close() {
    xml_.writeEndElement();
    xml_.writeCharacters("\n");
  }
  void array(const VtkArray& of, std::size_t tuples = 0) {
    open("DataArray");
    attribute("type", of.type);
    attribute("Name", of.name);
    attribute("NumberOfComponents", std::to_string(of.components));
    if (tuples > 0) attribute("NumberOfTuples", std::to_string(tuples));
    attribute("format", "ascii");
    xml_.writeCharacters(QString::fromStdString('\n' + of.text));
    close();
  }
  void arrays(const char* element, const std::vector<VtkArray>& all) {
    open(element);
    xml_.writeCharacters("\n");
    for (const VtkArray& one : all) array(one);
    close();
  }
  std::string text() {
    xml_.writeEndDocument();
    return bytes_.toStdString();
  }

 private:
  QByteArray bytes_;
  QXmlStreamWriter xml_;
};

std::size_t numbers_in(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text) count += c == ' ' || c == '\n';
  return count;
}

}  // namespace

VtkArray vtk_array(const std::string& name, const std::vector<double>& values, int components) {
  return array_of(name, "Float64", values, components);
}
VtkArray vtk_array(const std::string& name, const std::vector<float>& values, int components) {
  return array_of(name, "Float32", values, components);
}
VtkArray vtk_array(const std::string& name, const std::vector<std::int32_t>& values,
                   int components) {
  return array_of(name, "Int32", values, components);
}

std::string vtk_document(const VtkPolyData& data) {
  Document xml("PolyData", data.comment);
  xml.open("PolyData");
  xml.open("FieldData");
  xml.array(vtk_array("TimeValue", std::vector<double>{data.time_s}), 1);
  for (const VtkArray& one : data.field)
    xml.array(one, numbers_in(one.text) / static_cast<std::size_t>(one.components));
  xml.close();
  const std::string cells = std::to_string(data.offsets.size());
  xml.open("Piece");
  xml.attribute("NumberOfPoints", std::to_string(data.points_m.size() / 3));
  xml.attribute("NumberOfVerts", data.lines ? "0" : cells);
  xml.attribute("NumberOfLines", data.lines ? cells : "0");
  xml.attribute("NumberOfStrips", "0");
  xml.attribute("NumberOfPolys", "0");
  xml.arrays("Points", {vtk_array("position_m", data.points_m, 3)});
  xml.arrays("PointData", data.point_data);
  xml.arrays("CellData", data.cell_data);
  xml.arrays(data.lines ? "Lines" : "Verts",
             {vtk_array("connectivity", data.connectivity), vtk_array("offsets", data.offsets)});
  xml.close();
  xml.close();
  return xml.text();
}

std::string vtk_collection(const std::vector<VtkInstant>& series, const std::string& comment) {
  Document xml("Collection", comment);
  xml.open("Collection");
  int part = 0;
  for (std::size_t k = 0; k < series.size(); ++k) {
    part = k > 0 && series[k].time_s == series[k - 1].time_s ? part + 1 : 0;
    xml.open("DataSet");
    xml.attribute("timestep", fmt::format("{}", series[k].time_s));
    xml.attribute("group", "");
    xml.attribute("part", std::to_string(part));
    xml.attribute("file", series[k].file);
    xml.close();
  }
  xml.close();
  return xml.text();
}

}  // namespace triax::lab
