// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/element.hpp"

#include <memory>

#include "lab/base/bad_input.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/element/figures/path_figure.hpp"
#include "src/element/path_csv.hpp"
#include "src/element/path_json.hpp"
#include "src/element/path_text.hpp"
#include "src/output/output.hpp"
#include "src/output/progress_bar.hpp"
#include "src/study/element/run_element.hpp"

namespace triax::src {
namespace {

struct ElementOptions {
  std::string path;
  std::vector<std::string> sets;
  std::string output;
  std::string save_failure;
  std::string format;
  std::string figure;
};

void run_element(const ElementOptions& o) {
  const lab::PathDescription description =
      study::described_path(o.path, key_values(o.sets, "void_ratio=1.086"));
  refuse_overwriting("--output", o.output, description.files, "a file of the path");
  refuse_overwriting("--save-failure", o.save_failure, description.files, "a file of the path");
  if (!o.save_failure.empty() && description.material_name.empty())
    throw lab::BadInput(
        "--save-failure: a material of incrementalDriver files has no name for a path file");
  if (!o.output.empty())
    refuse_overwriting("--save-failure", o.save_failure, {o.output}, "the file of --output");
  const study::PathResult result = study::run_element(description, progress_bars());
  if (!o.save_failure.empty() && !result.failed_increment.empty())
    write_file(o.save_failure, result.failed_increment);
  if (!o.output.empty())
    write_file(o.output, o.output.ends_with(".json") ? path_json(result) : path_csv(result));
  if (!o.figure.empty()) {
    const auto figure = path_figure(result);
    if (!figure.drawing.plot) throw lab::BadInput("--figure: the path has fewer than two rows");
    write_named_figure(figure, o.figure);
  }
  print(o.format == "json"  ? path_json(result)
        : o.format == "csv" ? path_csv(result)
                            : path_text(result));
  if (!result.went_to_the_end()) throw lab::WorkFailed(result.message);
}

}  // namespace

Command element_command() {
  return {
      .name = "element",
      .purpose = "Run a material point along a stress or strain path",
      .description =
          {"PATH is a TOML file with a material, a start and segments of conditions on stress and "
           "strain increments: any six conditions, or two in axisymmetry. Drained, undrained, "
           "constant p', constant q, proportional strain and free combinations are possible. "
           "Integration is error-controlled. Zeros of the second-order work, peaks, end conditions "
           "and loss of control are located within the step.",
           "Beyond the limit load, the run stops, reports which condition cannot be maintained and "
           "at which state, prints its results and ends with status 1. --save-failure writes the "
           "increment that failed as a path file.",
           "Columns memory.NAME contain the state variables of the law. Columns whose names end in "
           "_root2 contain sqrt(2) times the tensor component, and [start] memory is given in the "
           "same scale.",
           "PATH can also be a folder with test.inp, parameters.inp and initialconditions.inp of "
           "Niemunis' incrementalDriver, or the test.inp in it (any name that ends in .inp). --set "
           "umat=libNAME.so names the library with the UMAT."},
      .diagnostics =
          {{"control of q_kPa is lost ...",
            "reduce the load, or control a strain instead: the material cannot carry more"},
           {"... is out of range for ...", "choose a start within the range of the law"},
           {"the closed cycle of stress ... gains ...",
            "use --set hyperelastic=1: bulk and shear moduli that depend on p' alone do not "
            "conserve energy"},
           {"undrained needs one condition on a total stress",
            "add a condition such as radial_stress_kPa = 0: the pore pressure is undetermined "
            "without it"}},
      .examples =
          {{"triax element samples/paths/icu_100.toml --set void_ratio=1.05 --json",
            "compress a denser specimen undrained"},
           {"triax element samples/paths/load_beyond_limit.toml --save-failure step.toml",
            "apply a load that cannot be carried (status 1) and save the increment that failed"},
           {"triax element FOLDER/test.inp",
            "run files of incrementalDriver; naming only the folder does the same"},
           {"triax element FOLDER --set umat=libsand.so --set void_ratio_index=7",
            "run them with their UMAT, built as a shared library"},
           {"triax element samples/paths/drained_100.toml --figure drained",
            "write the figure of the path as drained_path.svg, .png and .pdf"},
           {"triax element path.toml --set material=sanisand/Toyoura-DM04 --output rows.csv",
            "use another material and write all rows for a spreadsheet"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ElementOptions>();
        app.add_option("PATH", o->path,
                       "path file (.toml), folder of incrementalDriver files, or its test.inp")
            ->required()
            ->type_name("");
        app.add_option("--set", o->sets,
                       "set material, void_ratio, p_eff_kPa, tolerance or a parameter of the law "
                       "(repeatable)")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        app.add_option("--output", o->output, "also write all rows as CSV or JSON")
            ->type_name("FILE.csv|FILE.json");
        app.add_option("--save-failure", o->save_failure,
                       "write an increment that failed as a path file")
            ->type_name("FILE.toml");
        app.add_option("--figure", o->figure,
                       "draw q, volume and pore pressure against strain, the stress path, and e "
                       "against log p'; writes PREFIX_path.svg, .png, .pdf, .csv and .json")
            ->type_name("PREFIX");
        add_format(app, o->format, {"text", "json", "csv"});
        return [o] { run_element(*o); };
      }};
}

}  // namespace triax::src
