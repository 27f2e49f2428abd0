// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_files.hpp"
#include "lab/grains/lammps_export.hpp"
#include "lab/grains/vtk_snapshot.hpp"
#include "src/output/output.hpp"
#include "src/output/patient_write.hpp"
#include "src/output/written_files.hpp"

namespace triax::src {
namespace {

constexpr const char* kState = ".grains";
constexpr const char* kSeries = ".pvd";
constexpr const char* kLammpsData = ".lammps.data";
constexpr const char* kLammpsScript = ".lammps.in";
constexpr const char* kLammpsTable = ".lammps.csv";

bool for_lammps(const lab::GrainStage& stage) {
  const auto* path = std::get_if<lab::GrainPathStage>(&stage.work);
  return path != nullptr && path->lammps;
}
int pictures_of(const lab::GrainStage& stage) {
  const auto* path = std::get_if<lab::GrainPathStage>(&stage.work);
  return path == nullptr ? 0 : path->snapshots;
}

std::string without_folder(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

GrainOutputs::GrainOutputs(const lab::GrainProgramme& programme, std::string prefix,
                           std::function<bool()> stop)
    : programme_(programme), prefix_(std::move(prefix)), stop_(std::move(stop)) {
  for (const lab::GrainStage& stage : programme.stages)
    if (prefix_.empty() && (stage.save || for_lammps(stage) || pictures_of(stage) > 0))
      throw lab::BadInput(programme.source, stage.line,
                          fmt::format("stage '{}' writes files; give --output FOLDER", stage.name));
}

std::string GrainOutputs::named(const lab::GrainStage& stage, const std::string& ending) const {
  return prefix_ + "_" + lab::in_file_name(stage.name) + ending;
}

void GrainOutputs::write(const std::string& path, const std::string& text) const {
  write_when_there_is_room([&] { write_file(path, text); }, stop_);
}

std::vector<std::string> GrainOutputs::files() const {
  std::vector<std::string> files;
  for (const lab::GrainStage& stage : programme_.stages) {
    if (stage.save) files.push_back(named(stage, kState));
    if (pictures_of(stage) > 0) files.push_back(named(stage, kSeries));
    if (!for_lammps(stage)) continue;
    files.push_back(named(stage, kLammpsData));
    files.push_back(named(stage, kLammpsScript));
  }
  return files;
}

void GrainOutputs::begins(const lab::GrainStage& stage, const sim::GrainState& state) {
  points_ = 0;
  last_picture_s_ = -1;
  series_.clear();
  if (!for_lammps(stage)) return;
  lab::LammpsOptions options;
  options.title = programme_.name + ", stage " + stage.name;
  options.data_file = without_folder(named(stage, kLammpsData));
  options.table_file = without_folder(named(stage, kLammpsTable));
  const lab::LammpsExport made =
      lab::lammps_export(state, std::get<lab::GrainPathStage>(stage.work).path, options);
  write(named(stage, kLammpsData), made.data);
  write(named(stage, kLammpsScript), made.script);
}

void GrainOutputs::point(const lab::GrainStage& stage, const sim::GrainState& state,
                         double time_s) {
  const int pictures = pictures_of(stage);
  if (pictures == 0) return;
  const int samples = std::get<lab::GrainPathStage>(stage.work).path.samples;
  if (points_++ % std::max(1, samples / pictures) == 0) picture(stage, state, time_s);
}

void GrainOutputs::picture(const lab::GrainStage& stage, const sim::GrainState& state,
                           double time_s) {
  const std::string title =
      fmt::format("{}, stage {}, {:.6g} s", programme_.name, stage.name, time_s);
  const auto drawn = [&](const char* what, const std::string& text) {
    const std::string file = named(stage, fmt::format("_{}_{:04d}.vtp", what, series_.size() / 3));
    write(file, text);
    return lab::VtkInstant{time_s, without_folder(file)};
  };
  const lab::VtkInstant grains = drawn("grains", lab::vtk_grains(state, title)),
                        contacts = drawn("contacts", lab::vtk_contacts(state, title)),
                        box = drawn("box", lab::vtk_box(state, title));
  series_.insert(series_.end(), {grains, contacts, box});
  last_picture_s_ = state.time_s;
  write(named(stage, kSeries), lab::vtk_collection(series_, "simulated: " + programme_.name));
}

void GrainOutputs::ends(const lab::GrainStage& stage, const sim::GrainState& state) {
  if (stage.save) {
    const WrittenFile noted(named(stage, kState));
    write_when_there_is_room([&] { lab::save_state(named(stage, kState), state); }, stop_);
    noted.is_there();
  }
  if (pictures_of(stage) > 0 && state.time_s != last_picture_s_)
    picture(stage, state,
            series_.empty() ? 0 : state.time_s - last_picture_s_ + series_.back().time_s);
}

}  // namespace triax::src
