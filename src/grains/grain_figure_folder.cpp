// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_figure_folder.hpp"

#include <filesystem>

#include "src/grains/grain_figures.hpp"
#include "src/output/file_names.hpp"

namespace triax::src {

std::vector<std::string> write_grain_figures(const std::vector<db::StoredGrainRun>& runs,
                                             const std::string& folder) {
  std::vector<std::string> written;
  FileNames names;
  for (const auto& run : runs) {
    const std::string name = names.take(lab::in_file_name(run.report.programme), run.id);
    const std::string prefix = (std::filesystem::path(folder) / name).string();
    for (const NamedFigure& figure : grain_figures(run.report)) {
      write_named_figure(figure, prefix);
      written.push_back(prefix + "_" + figure.name);
    }
  }
  return written;
}

}  // namespace triax::src
