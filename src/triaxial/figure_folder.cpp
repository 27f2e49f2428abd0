// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figure_folder.hpp"

#include <filesystem>
#include <map>

#include "src/cli/output_guard.hpp"
#include "src/output/file_names.hpp"
#include "src/plot/figure_files.hpp"
#include "src/study/triaxial/read_again.hpp"
#include "src/study/triaxial/tests_origin.hpp"
#include "src/triaxial/figures/collapse_points_figure.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/shear_curves_figure.hpp"
#include "src/triaxial/figures/strains_over_p_figure.hpp"
#include "src/triaxial/figures/stress_increments_figure.hpp"
#include "src/triaxial/figures/stress_paths_figure.hpp"
#include "src/triaxial/sheet/sheet_figures.hpp"
#include "src/triaxial/test_figures.hpp"

namespace triax::src {
namespace {

std::string file_name(const std::string& name) {
  std::string out;
  for (const unsigned char c : name)
    // Not the C library's: Turkish has another lower case of I.
    out += c >= 'A' && c <= 'Z'                               ? static_cast<char>(c + ('a' - 'A'))
           : (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? static_cast<char>(c)
                                                              : '_';
  return out.empty() ? "_" : out;
}

class FigureFolder {
 public:
  explicit FigureFolder(const std::string& folder) : folder_(folder) {
    make_folder("--figures", folder);
  }

  void add(const std::string& name, const Drawing& drawing) {
    if (!drawing.plot) return;
    const auto prefix = (std::filesystem::path(folder_) / name).string();
    write_figure(drawing, prefix);
    written_.push_back(prefix);
  }
  std::vector<std::string> take() { return std::move(written_); }

 private:
  std::string folder_;
  std::vector<std::string> written_;
};

void add_tests(FigureFolder& folder, const std::vector<study::TestResult>& tests) {
  FileNames names;
  for (const auto& test : tests) {
    const auto name = names.take(file_name(test.stored.header.name), test.stored.id);
    for (const auto& figure : test_figures(test))
      folder.add(name + '_' + figure.name, figure.drawing);
  }
}

void add_types(FigureFolder& folder, const std::vector<study::TestResult>& tests) {
  const auto left_out = study::read_again(tests);
  std::map<std::string, std::vector<study::TestResult>> types;
  for (const auto& test : tests) {
    if (left_out.contains(test.stored.id)) continue;
    const auto& type = test.stored.header.programme;
    types[type.empty() ? "other" : type].push_back(test);
  }
  FileNames names;
  std::int64_t number = 0;
  for (const auto& [type, members] : types) {
    const auto name = names.take(file_name(type), ++number);
    const auto series = study::shear_series(members);
    folder.add(name + "_stress_paths", stress_paths_figure(series));
    folder.add(name + "_shear_curves", shear_curves_figure(series));
    folder.add(name + "_strains", strains_over_p_figure(study::shear_beginnings(members)));
  }
}

}  // namespace

std::vector<std::string> write_figures(const std::vector<study::TestResult>& tests,
                                       const std::vector<study::CollapseIncrement>& increments,
                                       const std::string& folder) {
  FigureFolder figures(folder);
  add_tests(figures, tests);
  add_types(figures, tests);
  figures.add("collapse_points", collapse_points_figure(study::collapse_points(tests)));
  figures.add("stress_increments",
              stress_increments_figure(increments, origin_note(study::origin_of(tests))));
  return figures.take();
}

void write_sheet_figures(const std::vector<SheetTest>& tests, const std::string& folder) {
  FigureFolder figures(folder);
  FileNames names;
  for (const auto& test : tests) {
    const auto& stored = test.result.stored;
    const auto name = names.take(file_name(stored.header.name), stored.id);
    for (const auto& figure : sheet_figures(test))
      figures.add(name + '_' + figure.name, figure.drawing);
  }
}

}  // namespace triax::src
