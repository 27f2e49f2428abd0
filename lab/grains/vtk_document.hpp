// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// XML files of VTK, which ParaView and other viewers open: PolyData (.vtp) of points and cells on
// them, and collections (.pvd) that give files a time. Numbers are written as text.
#include <cstdint>
#include <string>
#include <vector>

namespace triax::lab {

/// Numbers under a name that has their unit.
struct VtkArray {
  std::string name;
  const char* type = "Float32";  ///< as VTK has it
  int components = 1;            ///< so many numbers belong together
  std::string text;              ///< all of them; parted by blanks and line ends
};

/// The array of these values; double is written in the shortest digits that mean the same double,
/// float in those that mean the same float. Pre-condition: finite values.
VtkArray vtk_array(const std::string& name, const std::vector<double>& values, int components = 1);
VtkArray vtk_array(const std::string& name, const std::vector<float>& values, int components = 1);
VtkArray vtk_array(const std::string& name, const std::vector<std::int32_t>& values,
                   int components = 1);

struct VtkPolyData {
  std::string comment;  ///< at the head of the file
  double time_s = 0;
  std::vector<VtkArray> field;                      ///< of the whole
  std::vector<double> points_m;                     ///< three a point
  std::vector<std::int32_t> connectivity, offsets;  ///< of the cells: points, and where each ends
  bool lines = false;  ///< the cells are lines; else they are single points
  std::vector<VtkArray> point_data, cell_data;
};
std::string vtk_document(const VtkPolyData& data);

/// A file of a series. Several files of one time are parts of a whole.
struct VtkInstant {
  double time_s = 0;
  std::string file;  ///< as seen from the collection's folder
};
std::string vtk_collection(const std::vector<VtkInstant>& series, const std::string& comment);

}  // namespace triax::lab
