// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_source.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/diggs/diggs_table.hpp"
#include "lab/diggs/diggs_units.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/truth_toml.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMaxTests = 2000;

/// A trial is a test of one specimen; readings in a table of results need no trial.
struct DiggsRecord {
  const DiggsTest* test = nullptr;
  const DiggsTrial* trial = nullptr;  ///< null: the test has none
  std::string name;
};

std::string name_of_test(const DiggsTest& test, const std::string& file) {
  if (!test.name.empty()) return test.name;
  if (!test.id.empty()) return test.id;
  return std::filesystem::path(file).stem().string();
}

std::vector<DiggsRecord> records_of(const DiggsDocument& document) {
  std::vector<DiggsRecord> records;
  for (const DiggsTest& test : document.tests) {
    const auto name = name_of_test(test, document.file);
    for (std::size_t i = 0; i < std::max<std::size_t>(test.trials.size(), 1); ++i)
      records.push_back({&test, test.trials.empty() ? nullptr : &test.trials[i],
                         test.trials.size() < 2 ? name : fmt::format("{}, trial {}", name, i + 1)});
  }
  return records;
}

const DiggsSpecimen* specimen_of(const DiggsRecord& record) {
  const auto& all = record.test->specimens;
  if (record.trial != nullptr)
    if (const auto found = std::ranges::find(all, record.trial->specimen, &DiggsSpecimen::id);
        found != all.end())
      return &*found;
  return all.size() == 1 ? &all.front() : nullptr;
}

/// Fills a header with what the elements of a test say.
class HeaderMaker {
 public:
  HeaderMaker(const DiggsDocument& document, const DiggsRecord& record,
              std::vector<Warning>& warnings)
      : document_(document), record_(record), warnings_(warnings) {}

  RecordHeader make(const DiggsTable& table) {
    header_.name = record_.name;
    header_.programme = record_.test->type;
    if (const auto* const specimen = specimen_of(record_)) take_specimen(*specimen);
    if (record_.trial != nullptr) {
      take("specimen.membrane_thickness", record_.trial->values, "membraneThickness");
      take("specimen.membrane_modulus", record_.trial->values, "membraneYoungsModulus");
    }
    for (const DiggsParameter& parameter : record_.test->parameters) take_parameter(parameter);
    if (header_.stages.empty() && !table.has_stages()) header_.stages.push_back(shear_stage());
    return header_;
  }
  const std::string& truth() const { return truth_; }

 private:
  void take_specimen(const DiggsSpecimen& specimen) {
    header_.specimen.material = specimen.description;
    take("specimen.height", specimen.before, "height");
    take("specimen.diameter", specimen.before, "diameter");
    take("specimen.void_ratio", specimen.before, "voidRatio");
    take("specimen.consolidated_height", specimen.after, "height");
    take("specimen.consolidated_void_ratio", specimen.after, "voidRatio");
    take("specimen.specific_gravity", specimen.other, "specificGravityOfSolids");
    if (auto weight = specimen.before; weight.contains("dryWeight")) {
      take_weight(weight["dryWeight"]);
    }
  }

  /// A weight is the force of a mass under standard gravity.
  void take_weight(DiggsValue& weight) {
    constexpr double kGravity = 9.80665;
    const auto unit = find_diggs_unit(weight.uom);
    const auto number = whole_text_as<double>(trimmed(weight.text));
    if (!number || !unit || unit->dimension != sim::Dimension::force)
      return ignore("dryWeight", weight);
    if (trimmed(weight.uom) == "gf") return set("specimen.dry_mass_g", "dryWeight", weight);
    weight.text = fmt::format("{}", sim::to_si(*number, *unit) / kGravity * 1e3);
    set("specimen.dry_mass_g", "dryWeight", weight);
  }

  void take(const std::string& key, const DiggsValues& values, std::string_view element) {
    const auto found = values.find(element);
    if (found == values.end() || found->second.text.empty()) return;
    DiggsValue value = found->second;
    const auto row =
        std::ranges::find(specimen_keys(), key.substr(key.find('.') + 1), &SpecimenKey::name);
    const auto target = *sim::find_unit(row->unit);
    const auto unit = find_diggs_unit(value.uom);
    const auto number = whole_text_as<double>(trimmed(value.text));
    if (!number || !unit || unit->dimension != target.dimension) return ignore(element, value);
    if (unit->name != target.name)
      value.text = fmt::format("{}", sim::to_field(sim::to_si(*number, *unit), target));
    set(row->unit.empty() ? key : fmt::format("{}_{}", key, row->unit), element, value);
  }

  /// A value of another program that is not possible is left out.
  void set(const std::string& key, std::string_view element, const DiggsValue& value) {
    try {
      set_metadata(header_, document_.file, key, trimmed(value.text));
    } catch (const BadInput&) {
      ignore(element, value);
    }
  }

  void ignore(std::string_view element, const DiggsValue& value) {
    warnings_.push_back({value.line, fmt::format("{} = {} {} is not valid and ignored", element,
                                                 excerpt(value.text), value.uom)});
  }

  void take_parameter(const DiggsParameter& parameter) {
    if (!parameter.name.starts_with(kDiggsKeyPrefix)) return;
    const auto key = std::string_view(parameter.name).substr(kDiggsKeyPrefix.size());
    if (key == "truth") {
      truth_ = parameter.value;
      return;
    }
    set_metadata(header_, fmt::format("{}:{}", document_.file, parameter.line), key,
                 parameter.value);
  }

  StageInfo shear_stage() const {
    StageInfo stage;
    stage.name = "Shear";
    stage.role = StageRole::shear;
    stage.drainage = drainage_of_type(header_.programme);
    if (record_.trial != nullptr && record_.trial->values.contains("rateOfAxialStrainDuringShear"))
      stage.control = AxialControl::displacement;
    return stage;
  }

  const DiggsDocument& document_;
  const DiggsRecord& record_;
  std::vector<Warning>& warnings_;
  RecordHeader header_;
  std::string truth_;
};

/// A position along the borehole has one coordinate, or two of an extent from top to bottom; the
/// others are on a map.
std::string depth_of(const DiggsValue& position) {
  const std::string_view text = trimmed(position.text);
  const auto first = text.substr(0, text.find_first_of(" \t\r\n"));
  const bool is_along = first.size() == text.size() || position.uom == "1";
  return is_along ? std::string(first) : std::string();
}

std::vector<Note> notes_of(const DiggsRecord& record) {
  const DiggsTest& test = *record.test;
  const auto* const specimen = specimen_of(record);
  const auto& sample = test.sample.empty() && specimen != nullptr ? specimen->sample : test.sample;
  std::vector<Note> notes;
  const auto add = [&](const char* label, const std::string& text) {
    if (!text.empty()) notes.push_back({label, text});
  };
  if (test.project != kUnnamedProject) add("Project", test.project);
  add("Client", test.client);
  add("Borehole", test.location);
  add("Sample", sample);
  add("Depth", depth_of(test.depth));
  add("Test Number", specimen == nullptr ? std::string() : specimen->name);
  return notes;
}

DiggsTable readings_of(const DiggsRecord& record, const std::string& file) {
  DiggsTable table;
  // A table of results belongs to the test as a whole.
  if (record.test->trials.size() < 2) table = read_result_sets(*record.test, file);
  if (table.count == 0 && record.trial != nullptr) table = read_increments(*record.trial, file);
  if (table.count > 0) return table;
  throw BadInput(
      file, record.trial != nullptr ? record.trial->line : record.test->line,
      fmt::format("triaxial test {} has no readings, only results; expected elements "
                  "shearingIncrement, or a table of dataValues with an axial strain and a stress",
                  excerpt(record.name)));
}

}  // namespace

DiggsSource::DiggsSource(const DiggsDocument& document, std::size_t number,
                         std::unique_ptr<ByteSource> file)
    : file_(std::move(file)) {
  const auto records = records_of(document);
  const DiggsRecord& record = records.at(number - 1);
  is_only_ = records.size() == 1;
  DiggsTable table = readings_of(record, document.file);
  warnings_ = std::move(table.warnings);
  HeaderMaker maker(document, record, warnings_);
  const RecordHeader header = maker.make(table);
  notes_ = notes_of(record);
  std::string text = as_comment(metadata_toml(header)) + table.text() +
                     as_comment(ending_toml(header)) + as_comment(maker.truth());
  text_ = open_memory(document.file, std::move(text));
}

std::vector<std::string> diggs_tests(const DiggsDocument& document) {
  std::vector<std::string> names;
  for (const DiggsRecord& record : records_of(document)) names.push_back(record.name);
  if (names.size() > kMaxTests)
    throw BadInput(
        document.file, 0,
        fmt::format("{} triaxial tests in one file; expected at most {}", names.size(), kMaxTests));
  if (!names.empty()) return names;
  std::vector<std::string> others;
  for (const auto& [name, count] : document.other_procedures)
    others.push_back(count > 1 ? fmt::format("{} ({})", name, count) : name);
  throw BadInput(document.file, 0,
                 "DIGGS without a triaxial test; " +
                     (others.empty() ? "it has no test procedure" : "it has " + joined(others)));
}

Drainage drainage_of_type(std::string_view type) {
  std::string name;
  for (const char c : folded(type))
    if (c != ' ' && c != '-' && c != '_') name += c;
  std::string_view rest = name;
  if (rest == "unc" || rest.starts_with("uu")) return Drainage::closed;
  if (!rest.starts_with('c')) return Drainage::unknown;
  rest.remove_prefix(1);
  for (const std::string_view consolidated : {"k0", "ko", "i", "a"})
    if (rest.starts_with(consolidated)) {
      rest.remove_prefix(consolidated.size());
      break;
    }
  if (rest.starts_with('u')) return Drainage::closed;
  return rest.starts_with('d') ? Drainage::open : Drainage::unknown;
}

}  // namespace triax::lab
