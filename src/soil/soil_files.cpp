// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/soil_files.hpp"

#include <filesystem>

#include "lab/grains/grain_programme.hpp"
#include "src/output/file_names.hpp"
#include "src/output/output.hpp"
#include "src/soil/soil_figures.hpp"
#include "src/study/soil/soil_json.hpp"

namespace triax::src {

void write_soil_files(const std::vector<study::Soil>& soils, const std::string& folder) {
  FileNames names;
  std::int64_t number = 0;
  for (const auto& soil : soils) {
    ++number;
    const std::string stem =
        soils.size() == 1 ? "soil" : names.take("soil_" + lab::in_file_name(soil.group), number);
    const std::string prefix = (std::filesystem::path(folder) / stem).string();
    write_file(prefix + ".toml", study::toml_document(study::soil_json(soil)));
    for (const auto& figure : soil_figures(soil)) write_named_figure(figure, prefix);
  }
}

}  // namespace triax::src
