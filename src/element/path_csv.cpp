// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/path_csv.hpp"

#include <fmt/format.h>

#include "lab/base/toml_reader.hpp"
#include "src/output/table.hpp"

namespace triax::src {

std::string path_csv(const study::PathResult& path) {
  std::string out = fmt::format(
      "# [test]\n# name = {}\n# origin = \"simulated\"\n## one material point, {}\nsegment",
      lab::toml_quoted(path.name), on_one_line(path.material.name));
  for (const auto& column : path.columns) out += ',' + column;
  out += '\n';
  for (const auto& row : path.rows) {
    std::string name = row.segment;
    for (std::size_t at = 0; (at = name.find('"', at)) != std::string::npos; at += 2)
      name.insert(at, 1, '"');
    out += '"' + on_one_line(name) + '"';
    for (const auto& value : row.values) out += value ? fmt::format(",{}", *value) : ",";
    out += '\n';
  }
  return out;
}

}  // namespace triax::src
