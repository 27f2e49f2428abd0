// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/recorded.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <future>
#include <set>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/digest.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/names/stage_words.hpp"
#include "lab/records/back_pressure_check.hpp"
#include "lab/records/channels.hpp"
#include "lab/records/counter_join.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/record_head.hpp"
#include "lab/records/rows/find_reversed_rows.hpp"
#include "lab/records/rows/rows_ahead.hpp"
#include "lab/records/rows/sample_rows.hpp"
#include "lab/records/rows/spread_times.hpp"
#include "lab/records/stage_guess.hpp"
#include "lab/records/stage_inference.hpp"
#include "lab/records/stage_number.hpp"
#include "lab/records/stage_split.hpp"
#include "lab/records/table_reader.hpp"
#include "lab/records/tables/table_recognition.hpp"
#include "lab/records/time_line.hpp"
#include "lab/results/test_type.hpp"
#include "lab/rig/chosen_test.hpp"
#include "lab/rig/diggs_record.hpp"
#include "lab/rig/sheet_record.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

/// All that was stated about the record, the stronger later.
std::vector<SetValue> stated_values(const RecordOptions& options) {
  std::vector<SetValue> all = options.job;
  for (const auto& [key, value] : options.sets)
    all.push_back({key, value, fmt::format("--set {}={}", key, value)});
  return all;
}

/// Drained compression below the p' or σ'_r that it began with: the confinement was taken away, so
/// that q may have been held.
bool was_unconfined(const StageSummary& stage) {
  constexpr double kLeast = 0.02;
  const auto fell = [&](Quantity stress) {
    return stage[stress].low < (1 - kLeast) * stage[stress].first;
  };
  const auto& q = stage[Quantity::deviator_stress];
  return !(q.high < -q.low) &&
         (fell(Quantity::mean_effective_stress) || fell(Quantity::effective_radial_stress));
}

}  // namespace

struct RecordedRig::Impl {
  Impl(std::unique_ptr<ByteSource> bytes, const RecordOptions& options,
       const std::string& metadata_file, const std::string& metadata)
      : source(std::move(bytes)),
        findings(header.warnings),
        tests(options.tests),
        layout(recognise_table(*source, dialect_for(*source, options, findings), findings,
                               chosen_test(*source, options))),
        stage_numbers(layout.file),
        time_line(layout.has(ColumnRole::time), layout.has(ColumnRole::stage_time)) {
    describe_record(header, layout, findings);
    note_encoding(*source, findings);
    take_cells(header, *source, layout, findings);
    take_diggs_notes(header, *source, findings);
    source = in_order(std::move(source), layout);
    read_document(metadata_file, metadata);
    const auto stated = stated_values(options);
    apply_values(stated, false);
    const auto duplicate = source->file().duplicate();
    auto digest = std::async(duplicate ? std::launch::async : std::launch::deferred,
                             [&] { return sha256(duplicate ? *duplicate : source->file()); });
    settle_cell_pressure();
    settle_channels();
    settle_stages();
    check_stages_to_set(stated);
    apply_values(stated, true);
    header.digest = digest.get();
    if (!layout.test.empty())
      header.digest = sha256(*open_memory(layout.file, header.digest + '\n' + layout.test));
    rows.emplace(*source, layout, findings, header.warnings);
    spread.emplace([this](Row& next) { return rows->next(next); },
                   layout.has(ColumnRole::stage_time), findings);
    waiting = draw(first);
    if (!waiting) throw BadInput(layout.file, layout.heading_line, "no row of readings");
  }

  TomlTable parse_preamble(const std::string& toml) const;
  void read_document(const std::string& metadata_file, const std::string& metadata);
  void apply_values(const std::vector<SetValue>& stated, bool stages);
  void report_contradiction(const SpecimenInfo& before, const std::string& where);
  void settle_stages();
  void settle_stages_by_readings();
  void split_stages(const std::vector<StageSplit::Stage>& found);
  void settle_cell_pressure();
  void settle_channels();
  void settle_drainage(StageInfo& only, Drainage shown,
                       const std::optional<std::vector<StageSummary>>& known);
  void settle_named_drainage(StageInfo& only, const TestType& type);
  void settle_drainage_by_columns(StageInfo& only);
  bool name_stage(StageInfo& info) const;
  using EachRow = std::function<void(const Row&)>;
  std::vector<StageSummary> stages_of_rows(const EachRow& each = {});
  std::vector<StageSummary> stages_of(ByteSource& bytes, const TableLayout& table,
                                      const EachRow& each = {});
  std::optional<std::vector<StageSummary>> sample_of_undrained_test();
  void check_stages_to_set(const std::vector<SetValue>& stated);
  std::set<int> stages_in_rows() const;
  void look_for_typed_height(const std::vector<StageSummary>& summaries);
  bool draw(Reading& reading);
  int stage_of(const Row& drawn);
  void finish();

  std::unique_ptr<ByteSource> source;
  RecordHeader header;
  Findings findings;
  std::shared_ptr<const TestsInFile> tests;  ///< empty: not searched for
  TableLayout layout;
  StageNumbers stage_numbers;
  TimeLine time_line;
  CounterJoin counters;
  std::optional<Truth> truth;
  std::vector<std::string> stage_names;      ///< of a stage column with words, stage 1 first
  std::vector<std::int64_t> stage_lines;     ///< first line of each stage that readings show
  std::optional<double> held_cell_pressure;  ///< that every reading is given
  std::array<bool, kQuantityCount> filled{};
  std::int64_t last_line = 0;
  Reading first;
  bool waiting = false;
  bool over = false;
  std::int64_t count = 0;
  int stage = 0;
  std::optional<RowsAhead> rows;  ///< reads `source`, and ends before it
  std::optional<SpreadTimes> spread;
};

TomlTable RecordedRig::Impl::parse_preamble(const std::string& toml) const {
  try {
    return TomlTable::parse(toml, layout.file);
  } catch (const BadInput& error) {
    throw BadInput(std::string(error.what()) +
                   " (lines after # are TOML; begin a comment with ##)");
  }
}

void RecordedRig::Impl::read_document(const std::string& metadata_file,
                                      const std::string& metadata) {
  if (const auto own = toml_preamble(layout); !own.empty())
    read_metadata(header, truth, parse_preamble(own));
  else if (!metadata_file.empty())
    read_metadata(header, truth, TomlTable::parse(metadata, metadata_file));
}

void RecordedRig::Impl::apply_values(const std::vector<SetValue>& stated, bool stages) {
  for (const SetValue& one : stated) {
    if (one.key.starts_with("stages.") != stages) continue;
    const SpecimenInfo before = header.specimen;
    set_value(header, one);
    report_contradiction(before, one.where);
  }
}

/// What is said stands over what the file says; that they differ may be a slip of either.
void RecordedRig::Impl::report_contradiction(const SpecimenInfo& before, const std::string& where) {
  constexpr double kRounding = 0.005;
  for (const SpecimenKey& key : specimen_keys()) {
    const auto &was = before.*key.member, &now = header.specimen.*key.member;
    if (!was || !now || std::fabs(*now - *was) <= kRounding * std::fabs(*was)) continue;
    header.warnings.push_back(
        {0, fmt::format("{} replaces {:g}{}{} of the record", where,
                        key.unit.empty() ? *was : sim::to_field(*was, *sim::find_unit(key.unit)),
                        key.unit.empty() ? "" : " ", key.unit)});
  }
}

void RecordedRig::Impl::settle_stages() {
  if (!header.stages.empty()) return;
  if (!layout.has(ColumnRole::stage)) {
    header.stages.push_back(single_stage(layout, header.programme));
    if (layout.dialect.stage.drainage != Drainage::unknown) return;
    settle_stages_by_readings();
    return;
  }
  // The file numbers its stages but does not say what they are: look at all of it once.
  const auto summaries = stages_of_rows();
  header.stages = infer_stages(summaries, header.specimen);
  for (StageInfo& info : header.stages) {
    if (name_stage(info)) continue;
    header.guesses.push_back(stage_guess(
        *std::ranges::find(summaries, info.number, &StageSummary::number), info, header.specimen));
  }
  look_for_typed_height(summaries);
}

/// Those that the readings of a raw record without a stage column show; else the only one.
void RecordedRig::Impl::settle_stages_by_readings() {
  const bool has_other_volume =
      !header.has(Quantity::back_volume) && header.has(Quantity::volumetric_strain);
  std::optional<std::vector<StageSummary>> summaries;
  std::vector<StageSplit::Stage> found(1);
  if (header.is_raw() && !has_other_volume) {
    StageSplit split;
    summaries = stages_of_rows([&](const Row& drawn) { split.add(drawn); });
    found = split.stages(header.specimen);
  }
  if (found.size() > 1) {
    split_stages(found);
    return;
  }
  header.guesses.push_back(single_stage_guess(header.stages.front()));
  settle_drainage(header.stages.front(), found.front().drainage, summaries);
}

/// Takes the stages that the readings show, in place of the only one.
void RecordedRig::Impl::split_stages(const std::vector<StageSplit::Stage>& found) {
  for (const auto& one : found) stage_lines.push_back(one.line);
  const StageInfo only = header.stages.front();
  const auto summaries = stages_of_rows();
  header.stages = infer_stages(summaries, header.specimen);
  for (std::size_t i = 0; i < header.stages.size(); ++i) {
    StageInfo& info = header.stages[i];
    if (found[i].drainage != Drainage::unknown) info.drainage = found[i].drainage;
    if (found[i].role == StageRole::shear || found[i].role == StageRole::consolidation)
      info.role = found[i].role;
    else if (info.role == StageRole::shear || info.role == StageRole::unknown)
      info.role = StageRole::hold;
    if (info.role != StageRole::shear) continue;
    const bool shows_control = found[i].control != AxialControl::unknown;
    if (shows_control) info.control = found[i].control;
    if (only.drainage != Drainage::unknown) info.drainage = only.drainage;
    header.guesses.push_back(stage_guess(summaries[i], info, header.specimen));
    if (found[i].drainage == Drainage::unknown && only.drainage == Drainage::unknown)
      ask_other_drainage(header.guesses.back(), info);
    // The record may end soon after a peak of q.
    if (shows_control)
      header.guesses.back().otherwise.push_back(
          {fmt::format("stages.{}.control", info.number), "displacement"});
  }
  header.guesses.insert(header.guesses.begin(), split_guess(header.stages, stage_lines));
}

/// Takes role and drainage from the word in the stage column. True if it gives both.
bool RecordedRig::Impl::name_stage(StageInfo& info) const {
  const auto place = static_cast<std::size_t>(info.number - 1);
  if (place >= stage_names.size()) return false;
  info.name = stage_names[place];
  const StageWords words = read_stage_words(info.name);
  if (words.role != StageRole::unknown) info.role = words.role;
  if (words.drainage != Drainage::unknown) info.drainage = words.drainage;
  return words.role != StageRole::unknown && words.drainage != Drainage::unknown;
}

/// A pressure that was held is in no column: the metadata give it, and an unconfined test has none.
void RecordedRig::Impl::settle_cell_pressure() {
  const bool has_column =
      header.has(Quantity::cell_pressure) || header.has(Quantity::radial_stress);
  if (has_column && header.cell_pressure_pa)
    header.warnings.push_back({0,
                               "the cell pressure that was given is not used: the record has a "
                               "column of it"});
  if (!has_column && !header.cell_pressure_pa && header.is_unconfined()) {
    held_cell_pressure = 0;
    header.warnings.push_back(
        {0, fmt::format("{}: unconfined, the cell pressure is assumed to be 0 kPa",
                        header.programme)});
  } else if (!has_column) {
    held_cell_pressure = header.cell_pressure_pa;
  }
  if (held_cell_pressure) header.columns.push_back(Quantity::cell_pressure);
  if (const auto missing = missing_channels(header.columns, header.is_total_stress());
      !missing.empty())
    throw BadInput(layout.file, layout.heading_line, joined({missing, layout.ignored}, "; "));
}

/// Raw channels need the dimensions of the specimen and a pore pressure. Without them, the strains
/// and stresses of the file are used if it has them.
void RecordedRig::Impl::settle_channels() {
  const SpecimenInfo& specimen = header.specimen;
  const bool has_dimensions = specimen.height_m && specimen.diameter_m;
  const bool has_pore_pressure = header.has(Quantity::pore_pressure) ||
                                 header.has(Quantity::back_pressure) || header.is_total_stress();
  const bool suffices = has_dimensions && has_pore_pressure;
  if (!header.is_raw() || suffices || layout.dialect.own_headings) return;
  auto reduced = header.columns;
  std::erase(reduced, Quantity::axial_force);
  std::erase(reduced, Quantity::axial_displacement);
  if (!missing_channels(reduced, header.is_total_stress()).empty()) return;
  header.columns = std::move(reduced);
  std::erase_if(layout.columns, [](const PlannedColumn& column) {
    return column.role == ColumnRole::quantity && (column.quantity == Quantity::axial_force ||
                                                   column.quantity == Quantity::axial_displacement);
  });
  header.warnings.push_back(
      {layout.heading_line,
       has_dimensions
           ? "the file has no pore pressure: its strains and stresses are used, not its "
             "displacement and force"
           : "the file does not state height and diameter: its strains and stresses are used, not "
             "its displacement and force; otherwise --set specimen.height_mm=... and "
             "specimen.diameter_mm"});
}

/// The only stage of a record that does not say whether it was drained: its readings may (`shown`:
/// StageSplit), else the type of the test, else its columns. `known`: the summaries of all rows.
void RecordedRig::Impl::settle_drainage(StageInfo& only, Drainage shown,
                                        const std::optional<std::vector<StageSummary>>& known) {
  if (const TestType* type = find_test_type(header.programme)) {
    settle_named_drainage(only, *type);
    return;
  }
  if (only.drainage == Drainage::unknown && header.has(Quantity::back_volume)) {
    const auto summaries = known ? *known : stages_of_rows();
    only.drainage =
        shown != Drainage::unknown ? shown : infer_stages(summaries, header.specimen)[0].drainage;
    header.guesses.push_back(stage_guess(summaries.front(), only, header.specimen));
    if (shown == Drainage::unknown) ask_other_drainage(header.guesses.back(), only);
    return;
  }
  settle_drainage_by_columns(only);
}

/// Readings that contradict the type count, but for a raw record of an undrained test: a pore
/// pressure that does not answer may be that of a dead transducer (ClosedDrainage).
void RecordedRig::Impl::settle_named_drainage(StageInfo& only, const TestType& type) {
  const bool has_volume_counter = header.is_raw() && header.has(Quantity::back_volume);
  if (type.is_total_stress() || has_volume_counter) return;
  if (!type.drained && sample_of_undrained_test()) return;
  const auto found = find_drainage(stages_of_rows().front(), header.specimen);
  const bool is_open = found.drainage == Drainage::open;
  if (found.drainage == Drainage::unknown || is_open == type.drained) return;
  if (is_open && header.is_raw()) return;
  only.drainage = found.drainage;
  header.warnings.push_back(
      {0,
       fmt::format("type {} is {}, but {}: assessed as {}; otherwise --set stages.{}.drainage={}",
                   header.programme, type.drained ? "drained" : "undrained", found.text,
                   is_open ? "drained" : "undrained", only.number, is_open ? "closed" : "open")});
}

void RecordedRig::Impl::settle_drainage_by_columns(StageInfo& only) {
  auto summaries = sample_of_undrained_test();
  if (!summaries) summaries = stages_of_rows();
  const StageSummary& shear = summaries->front();
  const auto found = find_drainage(shear, header.specimen);
  if (found.drainage != Drainage::unknown) only.drainage = found.drainage;
  if (only.drainage == Drainage::unknown) return;
  const double range = shear[Quantity::volumetric_strain].range();
  constexpr double kStands = 1e-4;
  if (found.drainage == Drainage::unknown && header.has(Quantity::volumetric_strain))
    only.drainage = range > kStands ? Drainage::open : Drainage::closed;
  std::string evidence = found.text;
  if (evidence.empty())
    evidence = header.has(Quantity::volumetric_strain)
                   ? fmt::format("its volumetric strain changes by {:.3g} %", range * 100)
                   : "it has a pore pressure and no volume";
  header.guesses.push_back(drainage_guess(only, evidence));
  if (only.drainage != Drainage::open) return;
  auto& otherwise = header.guesses.back().otherwise;
  // Between a strain that is nothing and one that is plainly water nobody knows.
  if (found.drainage == Drainage::unknown)
    otherwise.push_back({fmt::format("stages.{}.drainage", only.number), "closed"});
  if (only.control == AxialControl::unknown && was_unconfined(shear))
    otherwise.push_back({fmt::format("stages.{}.control", only.number), "constant_q"});
}

/// Summaries of the first and last rows of a long record whose pore pressure shows that it is
/// undrained: the rows between do not change that. Nothing otherwise.
std::optional<std::vector<StageSummary>> RecordedRig::Impl::sample_of_undrained_test() {
  if (header.has(Quantity::volumetric_strain) || layout.is_reversed) return std::nullopt;
  const bool is_known = tests && tests->sample;
  const TableSample own = is_known ? TableSample() : read_sample(*source);
  const TableSample& sample = is_known ? *tests->sample : own;
  if (sample.whole) return std::nullopt;
  const SampleRows ends = sample_rows(sample, layout);
  auto summaries = stages_of(*ends.text, ends.layout);
  if (summaries.empty() ||
      find_drainage(summaries.front(), header.specimen).drainage != Drainage::closed)
    return std::nullopt;
  return summaries;
}

std::vector<StageSummary> RecordedRig::Impl::stages_of_rows(const EachRow& each) {
  return stages_of(*source, layout, each);
}

std::vector<StageSummary> RecordedRig::Impl::stages_of(ByteSource& bytes, const TableLayout& table,
                                                       const EachRow& each) {
  std::vector<Warning> repeated;
  Findings scratch(repeated);
  TableReader reader(bytes, table, scratch);
  StageNumbers numbers(layout.file);
  auto summaries = summarise_stages(
      reader, [&](double value, std::int64_t line) { return numbers.of(value, line, scratch); },
      held_cell_pressure, stage_lines, each);
  stage_names = reader.stage_names();
  return summaries;
}

std::set<int> RecordedRig::Impl::stages_in_rows() const {
  std::vector<Warning> repeated;
  Findings scratch(repeated);
  TableReader reader(*source, layout, scratch);
  StageNumbers numbers(layout.file);
  std::set<int> found;
  Row drawn;
  while (reader.next(drawn))
    if (!std::isnan(drawn.stage)) found.insert(numbers.of(drawn.stage, drawn.line, scratch));
  return found;
}

// A stage that the metadata do not name may still stand in the rows: only then are they looked
// through.
void RecordedRig::Impl::check_stages_to_set(const std::vector<SetValue>& stated) {
  std::optional<std::set<int>> known;
  for (const SetValue& one : stated) {
    const auto number = stage_of_key(one.key);
    if (!number || header.stage(*number)) continue;
    if (!known) {
      known = layout.has(ColumnRole::stage) ? stages_in_rows() : std::set<int>();
      for (const StageInfo& info : header.stages) known->insert(info.number);
    }
    if (!known->contains(*number))
      throw BadInput(fmt::format("{}: {} has no stage {}; it has {}", one.where, layout.file,
                                 *number, fmt::join(*known, ", ")));
  }
}

void RecordedRig::Impl::look_for_typed_height(const std::vector<StageSummary>& summaries) {
  const auto found = std::ranges::find_if(summaries, [&](const StageSummary& summary) {
    const StageInfo* info = header.stage(summary.number);
    return info && info->role == StageRole::shear;
  });
  if (found == summaries.end() || !header.specimen.height_m ||
      header.specimen.consolidated_height_m)
    return;
  double moved = 0;
  for (auto stage_before = summaries.begin(); stage_before != found; ++stage_before) {
    const double change = (*stage_before)[Quantity::axial_displacement].change();
    if (!std::isnan(change)) moved += change;
  }
  const double ours = *header.specimen.height_m - moved;
  const auto typed = typed_height(*found, ours);
  if (!typed) return;
  header.specimen.consolidated_height_m = typed;
  findings.note(
      "typed height", found->first_line,
      fmt::format("the axial strain of the file in stage {} is the displacement over {:.2f} mm, "
                  "not over {:.2f} mm, the height after the displacement of the previous stages: "
                  "the operator entered a new start height; it is used as the consolidated height",
                  found->number, *typed * 1e3, ours * 1e3));
}

int RecordedRig::Impl::stage_of(const Row& drawn) {
  if (!std::isnan(drawn.stage)) return stage_numbers.of(drawn.stage, drawn.line, findings);
  if (!stage_lines.empty()) return stage_at_line(stage_lines, drawn.line);
  if (count > 0) return stage;
  return header.stages.empty() ? 1 : header.stages.front().number;
}

bool RecordedRig::Impl::draw(Reading& reading) {
  Row* const drawn = over ? nullptr : spread->next();
  if (!drawn) {
    finish();
    return false;
  }
  Row& row = *drawn;
  last_line = row.line;
  const int number = stage_of(row);
  const bool begins = count == 0 || number != stage;
  stage = number;
  if (begins && !header.stage(stage))
    findings.note("unnamed stage", row.line,
                  fmt::format("stage {} has no description; its role is unknown", stage));
  reading.time_s = time_line.next(row.time_s, row.stage_time_s, stage, begins, row.line, findings);
  if (header.origin == Origin::recorded) {
    // Counters are set to zero between stages of the file, not between those of its readings.
    counters.apply(row.si, stage, begins && stage_lines.empty(), row.line, findings);
    header.back_volume_joined = counters.joined(Quantity::back_volume);
  }
  if (held_cell_pressure) row.si[index(Quantity::cell_pressure)] = *held_cell_pressure;
  reading.number = count++;
  reading.stage = stage;
  reading.si = row.si;
  reading.line = row.line;
  check_back_pressure(reading, header.stage(stage), begins, findings);
  for (std::size_t i = 0; i < filled.size(); ++i) filled[i] |= !std::isnan(row.si[i]);
  constexpr std::int64_t kPatience = 1000;
  if (count == kPatience && time_line.stands_still()) finish();
  return true;
}

void RecordedRig::Impl::finish() {
  if (over) return;
  if (time_line.stands_still())
    throw BadInput(layout.file, last_line,
                   fmt::format("the time is the same in all {} rows; leave the time column out",
                               time_line.rows()));
  std::vector<Quantity> held;
  for (const Quantity q : header.columns)
    if (filled[index(q)]) held.push_back(q);
  if (count > 0)
    if (const auto missing = missing_channels(held, header.is_total_stress()); !missing.empty())
      throw BadInput(layout.file, layout.heading_line, "a column without any value: " + missing);
  if (!rows->trailer().empty()) {
    RecordHeader end;
    read_metadata(end, truth, TomlTable::parse(rows->trailer(), layout.file, rows->trailer_line()));
    if (header.cut_short.empty()) header.cut_short = end.cut_short;
  }
  over = true;
  findings.finish();
  rows->finish();
  remove_text_lines(header.warnings, *source);
}

RecordedRig::RecordedRig(std::unique_ptr<ByteSource> source, const RecordOptions& options,
                         const std::string& metadata_file, const std::string& metadata)
    : impl_(std::make_unique<Impl>(std::move(source), options, metadata_file, metadata)) {}
RecordedRig::~RecordedRig() = default;

const RecordHeader& RecordedRig::header() const { return impl_->header; }
std::optional<Truth> RecordedRig::truth() const { return impl_->truth; }

bool RecordedRig::next(Reading& reading) {
  if (!impl_->waiting) return impl_->draw(reading);
  impl_->waiting = false;
  reading = impl_->first;
  return true;
}

double RecordedRig::progress() const {
  if (impl_->over) return 1;
  const auto size = static_cast<double>(impl_->source->size());
  return size > 0 ? std::min(1.0, static_cast<double>(impl_->rows->position()) / size) : 0.0;
}

std::unique_ptr<RecordedRig> open_record(const std::string& path, const RecordOptions& given) {
  const RecordOptions options = with_dialect_beside(path, given);
  auto source = diggs_or_other(open_readings(path, options), options);
  const auto beside = std::filesystem::path(path).replace_extension(".toml");
  std::error_code unreadable;
  if (beside == path || is_dialect(beside) || !std::filesystem::is_regular_file(beside, unreadable))
    return std::make_unique<RecordedRig>(std::move(source), options, "", "");
  return std::make_unique<RecordedRig>(std::move(source), options, beside.string(),
                                       read_text_file(beside.string()));
}

std::unique_ptr<RecordedRig> open_record(std::unique_ptr<ByteSource> source,
                                         const RecordOptions& options) {
  auto readings = diggs_or_other(sheet_or_text(std::move(source), options), options);
  return std::make_unique<RecordedRig>(std::move(readings), options, "", "");
}

}  // namespace triax::lab
