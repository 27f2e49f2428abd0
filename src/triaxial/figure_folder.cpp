// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figure_folder.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include "src/cli/output_guard.hpp"
#include "src/plot/figure_files.hpp"
#include "src/study/triaxial/read_again.hpp"
#include "src/study/triaxial/tests_origin.hpp"
#include "src/triaxial/figures/collapse_points_figure.hpp"
#include "src/triaxial/figures/few_states.hpp"
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

}  // namespace

FigureFolder::FigureFolder(std::string folder) : folder_(std::move(folder)) {
  make_folder("--figures", folder_);
}

std::string FigureFolder::name_of(const db::StoredTest& test) {
  return names_.take(file_name(test.header.name), test.id);
}

void FigureFolder::write(const std::string& name, const Drawing& drawing) {
  if (!drawing.plot) return;
  const auto prefix = (std::filesystem::path(folder_) / name).string();
  write_figure(drawing, prefix);
  written_.push_back(prefix);
}

void FigureFolder::add_as(const std::string& name, const study::TestResult& test) {
  for (const auto& figure : test_figures(test)) write(name + '_' + figure.name, figure.drawing);
  compared_.push_back(test);
  keep_few_states(compared_.back());
}

void FigureFolder::add(const study::TestResult& test) { add_as(name_of(test.stored), test); }

void FigureFolder::add(const SheetTest& test) {
  const auto name = name_of(test.result.stored);
  for (const auto& figure : sheet_figures(test)) write(name + '_' + figure.name, figure.drawing);
  add_as(name, test.result);
}

void FigureFolder::write_types() {
  const auto left_out = study::read_again(compared_);
  std::map<std::string, std::vector<study::TestResult>> types;
  for (auto& test : compared_) {
    if (left_out.contains(test.stored.id)) continue;
    const auto& type = test.stored.header.programme;
    types[type.empty() ? "other" : type].push_back(std::move(test));
  }
  FileNames names;
  std::int64_t number = 0;
  for (const auto& [type, members] : types) {
    const auto name = names.take(file_name(type), ++number);
    const auto series = study::shear_series(members);
    write(name + "_stress_paths", stress_paths_figure(series));
    write(name + "_shear_curves", shear_curves_figure(series));
    write(name + "_strains", strains_over_p_figure(study::shear_beginnings(members)));
  }
}

void FigureFolder::finish(const std::vector<study::CollapseIncrement>& increments) {
  write("collapse_points", collapse_points_figure(study::collapse_points(compared_)));
  write("stress_increments",
        stress_increments_figure(increments, origin_note(study::origin_of(compared_))));
  write_types();
  compared_.clear();
}

}  // namespace triax::src
