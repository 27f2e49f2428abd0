// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/materials.hpp"

#include <memory>

#include "lab/base/toml_reader.hpp"
#include "lab/materials/material_library.hpp"
#include "src/cli/shared_options.hpp"
#include "src/element/material_report.hpp"
#include "src/output/output.hpp"

namespace triax::src {
namespace {

struct MaterialsOptions {
  std::string name;
  std::string file;
  bool json = false;
};

void run_materials(const MaterialsOptions& o) {
  const auto sets = o.file.empty() ? lab::shipped_materials()
                                   : lab::read_materials(lab::read_text_file(o.file), o.file);
  if (o.name.empty()) return print(o.json ? materials_json(sets) : materials_text(sets));
  if (const auto* law = sim::find_law(o.name))
    return print(o.json ? law_json(*law) : law_text(*law));
  const auto set = lab::find_material(o.name, sets);
  print(o.json ? material_json(set) : material_text(set));
}

}  // namespace

Command materials_command() {
  return {.name = "materials",
          .purpose = "List laws and parameter sets, or show the parameters of one",
          .description = {"Without NAME, lists all laws with their parameter sets: the soil that "
                          "they describe, their range and the source of their values. With a set "
                          "LAW/SET, lists its parameters with symbol, value, unit, range and "
                          "meaning. With a law, lists the same without values."},
          .diagnostics = {{"unknown material 'LAW/SET'; ...",
                           "use the nearest name, or one of the names listed"}},
          .examples = {{"triax materials", "list all laws and sets"},
                       {"triax materials sanisand/S28-general", "show the parameters of one set"},
                       {"triax materials --materials my_sand.toml", "list your own sets"}},
          .set_up = [](CLI::App& app) -> std::function<void()> {
            const auto o = std::make_shared<MaterialsOptions>();
            app.add_option("NAME", o->name, "parameter set LAW/SET, or law [all]")->type_name("");
            app.add_option("--materials", o->file,
                           "use the sets of this parameter file instead of the shipped sets")
                ->type_name("FILE.toml");
            add_json(app, o->json);
            return [o] { run_materials(*o); };
          }};
}

}  // namespace triax::src
