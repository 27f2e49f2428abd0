// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/programme_form.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/materials/material_library.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "src/page/request/request.hpp"

namespace triax::lab {
/// samples/programmes/*.toml
extern const std::span<const EmbeddedFile> kSampleProgrammes;
}  // namespace triax::lab

namespace triax::src {
namespace {

using study::Json;

Json number_field(const std::string& key, const std::string& label, const char* unit, double value,
                  double least, double most, double step) {
  return {{"key", key},       {"also", Json::array()},
          {"label", label},   {"unit", study::json_text(unit)},
          {"kind", "number"}, {"value", value},
          {"min", least},     {"max", most},
          {"step", step}};
}

Json choice_field(const std::string& key, const std::string& label, const std::string& value,
                  Json options) {
  return {{"key", key},
          {"also", Json::array()},
          {"label", label},
          {"unit", nullptr},
          {"kind", "choice"},
          {"value", value},
          {"options", std::move(options)}};
}

/// A step of one or two figures, some hundred of them to the whole way.
double usual_step(double way) {
  double step = 1;
  while (step * 100 > way) step /= 10;
  while (step * 1000 < way) step *= 10;
  return step;
}

/// Between a fifth and five times the value, on its side of zero.
Json rate_field(const std::string& key, const std::string& label, const char* unit, double value) {
  const double near = value / 5, far = value * 5;
  const double least = std::min(near, far), most = std::max(near, far);
  return number_field(key, label, unit, value, least, most, usual_step(most - least));
}

Json material_names() {
  Json names = Json::array();
  for (const auto& set : lab::shipped_materials()) names.push_back(set.name);
  return names;
}

Json instrument_names() {
  Json names = Json::array();
  for (const auto& file : lab::kShippedInstruments) names.push_back(file.name);
  return names;
}

void add_specimen(const lab::TomlTable& specimen, Json& fields) {
  const std::string material = specimen.text("material").value_or("");
  if (!material.empty())
    fields.push_back(
        choice_field("specimen.material", "law and parameters", material, material_names()));
  if (const auto e = specimen.number("void_ratio")) {
    double least = *e - 0.2, most = *e + 0.2;
    if (!material.empty())
      if (const auto range = lab::find_material(material).void_ratio_range) {
        least = std::min(range->low, *e);
        most = std::max(range->high, *e);
      }
    fields.push_back(
        number_field("specimen.void_ratio", "void ratio e as built", "", *e, least, most, 0.001));
  }
}

/// The pressure of the cell to which a stage goes, and the end that waits for it.
void add_cell_target(const lab::TomlTable& stage, const std::string& key, const std::string& name,
                     Json& fields) {
  const auto target = stage.number("cell_target_kPa");
  if (!target || stage.text("role").value_or("") != "consolidation") return;
  Json field = number_field(key + "cell_target_kPa", name + ": cell pressure", "kPa", *target,
                            *target / 2, *target * 2, 5);
  const auto ends = stage.tables("end");
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i].text("quantity").value_or("") == "cell_pressure_kPa" && ends[i].number("above"))
      field["also"].push_back(fmt::format("{}end.{}.above", key, i + 1));
  fields.push_back(std::move(field));
}

void add_shear(const lab::TomlTable& stage, const std::string& key, const std::string& name,
               Json& fields) {
  if (stage.text("role").value_or("") != "shear") return;
  if (const auto rate = stage.number("axial_rate_mm_per_min"); rate && *rate != 0)
    fields.push_back(
        rate_field(key + "axial_rate_mm_per_min", name + ": axial rate", "mm/min", *rate));
  if (const auto rate = stage.number("cell_rate_kPa_per_min"); rate && *rate != 0)
    fields.push_back(rate_field(key + "cell_rate_kPa_per_min", name + ": rate of the cell pressure",
                                "kPa/min", *rate));
  const auto ends = stage.tables("end");
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (const auto q = ends[i].number("above");
        q && ends[i].text("quantity").value_or("") == "q_kPa")
      fields.push_back(number_field(fmt::format("{}end.{}.above", key, i + 1),
                                    name + ": deviator stress q at its end", "kPa", *q, *q / 4,
                                    *q * 2, 1));
}

Json fields_of(const lab::TomlTable& document) {
  Json fields = Json::array();
  if (const auto specimen = document.table("specimen")) add_specimen(*specimen, fields);
  const auto stages = document.tables("stages");
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const std::string key = fmt::format("stages.{}.", i + 1);
    const std::string name = stages[i].text("name").value_or(fmt::format("stage {}", i + 1));
    add_cell_target(stages[i], key, name, fields);
    add_shear(stages[i], key, name, fields);
  }
  if (const auto rig = document.table("rig"))
    if (const auto instruments = rig->text("instruments"))
      fields.push_back(choice_field("rig.instruments", "instruments and their noise", *instruments,
                                    instrument_names()));
  if (const auto test = document.table("test"))
    fields.push_back(number_field("test.seed", "seed of the noise", "",
                                  static_cast<double>(test->integer("seed").value_or(0)), 0,
                                  1000000, 1));
  return fields;
}

/// The remark at the head of the file.
std::string remark_of(std::string_view text) {
  std::string remark;
  while (text.starts_with('#')) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto line = lab::trimmed(text.substr(1, end - 1));
    if (!remark.empty()) remark += line.empty() ? "\n" : " ";
    remark += line;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return remark;
}

void refuse_files(const std::string& text, const std::string& name,
                  const std::vector<lab::TomlEdit>& edits) {
  if (const auto key = lab::find_file_key(lab::TomlTable::parse(text, name, 1, edits)))
    throw Refused(400, *key +
                           ": a programme in the web interface cannot use files of this computer; "
                           "run it with `triax simulate`");
}

}  // namespace

study::Json programme_forms() {
  Json list = Json::array();
  for (const lab::EmbeddedFile& file : lab::kSampleProgrammes) {
    const auto document = lab::TomlTable::parse(file.text, std::string(file.name) + ".toml");
    const auto test = document.table("test");
    list.push_back({{"name", file.name},
                    {"title", test ? test->text("name").value_or("") : ""},
                    {"type", test ? test->text("type").value_or("") : ""},
                    {"about", remark_of(file.text)},
                    {"fields", fields_of(document)}});
  }
  return list;
}

std::optional<std::string_view> sample_programme(std::string_view name) {
  const auto found = std::ranges::find(lab::kSampleProgrammes, name, &lab::EmbeddedFile::name);
  if (found == lab::kSampleProgrammes.end()) return std::nullopt;
  return found->text;
}

lab::Programme programme_of(const std::string& name_or_text,
                            const std::vector<lab::TomlEdit>& edits) {
  const auto sample = sample_programme(name_or_text);
  if (!sample && name_or_text.find('\n') == std::string::npos)
    throw Refused(400, "unknown sample programme " + lab::excerpt(name_or_text) +
                           "; give one of those listed, or the text of a programme");
  const std::string text(sample.value_or(name_or_text));
  const std::string name = (sample ? name_or_text : std::string("programme")) + ".toml";
  refuse_files(text, name, edits);
  lab::Programme programme = lab::read_programme(text, name, edits);
  programme.changes = edits;
  std::string changes;
  for (const lab::TomlEdit& edit : edits)
    changes += fmt::format("{}{} {}", changes.empty() ? "" : ", ",
                           edit.key.substr(edit.key.rfind('.') + 1), edit.value);
  if (!changes.empty()) programme.name += fmt::format(" [{}]", changes);
  return programme;
}

}  // namespace triax::src
