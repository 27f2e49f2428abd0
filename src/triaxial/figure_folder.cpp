#include "src/triaxial/figure_folder.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "lab/base/bad_input.hpp"
#include "src/plot/figure_files.hpp"
#include "src/triaxial/figures/collapse_points_figure.hpp"
#include "src/triaxial/figures/history_figure.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/series_plot.hpp"
#include "src/triaxial/figures/shear_curves_figure.hpp"
#include "src/triaxial/figures/strains_over_p_figure.hpp"
#include "src/triaxial/figures/stress_path_figure.hpp"
#include "src/triaxial/figures/stress_paths_figure.hpp"

namespace triax::src {
namespace {

std::string file_name(const std::string& name) {
  std::string out;
  for (const unsigned char c : name)
    out += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : '_';
  return out.empty() ? "_" : out;
}

void need_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw lab::BadInput(fmt::format("--figures {}: cannot create folder{}", folder,
                                    error ? ": " + error.message() : std::string()));
}

class FigureFolder {
 public:
  explicit FigureFolder(const std::string& folder) : folder_(folder) { need_folder(folder); }

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
  std::set<std::string> names;
  for (const auto& test : tests) {
    auto name = file_name(test.stored.header.name);
    if (!names.insert(name).second) name += fmt::format("_{}", test.stored.id);
    folder.add(name + "_stress_path", stress_path_figure(test));
    folder.add(name + "_history", history_figure(test, Span::shear));
    folder.add(name + "_onset", history_figure(test, Span::onset));
  }
}

void add_types(FigureFolder& folder, const std::vector<study::TestResult>& tests) {
  std::map<std::string, std::vector<study::TestResult>> types;
  for (const auto& test : tests) {
    const auto& type = test.stored.header.programme;
    types[type.empty() ? "other" : type].push_back(test);
  }
  for (const auto& [type, members] : types) {
    folder.add(file_name(type) + "_stress_paths", stress_paths_figure(members));
    folder.add(file_name(type) + "_shear_curves", shear_curves_figure(members));
    folder.add(file_name(type) + "_strains", strains_over_p_figure(members));
  }
}

}  // namespace

std::vector<std::string> write_figures(const std::vector<study::TestResult>& tests,
                                       const std::vector<study::CollapseIncrement>& increments,
                                       const std::string& folder) {
  FigureFolder figures(folder);
  add_tests(figures, tests);
  add_types(figures, tests);
  figures.add("collapse_points", collapse_points_figure(tests));
  figures.add("stress_increments",
              stress_increments_figure(increments, origin_of(pointers_to(tests))));
  return figures.take();
}

}  // namespace triax::src
