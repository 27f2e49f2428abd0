// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/recorded.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/digest.hpp"
#include "lab/records/back_pressure_check.hpp"
#include "lab/records/channels.hpp"
#include "lab/records/counter_join.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/record_head.hpp"
#include "lab/records/rows_ahead.hpp"
#include "lab/records/stage_guess.hpp"
#include "lab/records/stage_inference.hpp"
#include "lab/records/stage_number.hpp"
#include "lab/records/table_reader.hpp"
#include "lab/records/time_line.hpp"
#include "lab/rig/sheet_record.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

std::optional<Dialect> named_dialect(const RecordOptions& options) {
  if (options.dialect.empty()) return std::nullopt;
  return find_dialect(options.dialect);
}

// The N of "stages.N.role"; nothing for other keys and for what set_metadata will refuse.
std::optional<int> stage_in(std::string_view key) {
  constexpr std::string_view kGroup = "stages.";
  if (!key.starts_with(kGroup)) return std::nullopt;
  key.remove_prefix(kGroup.size());
  int number = 0;
  const auto [stop, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  if (error != std::errc{} || number < 0) return std::nullopt;
  return number;
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
        layout(recognise_table(*source, named_dialect(options), findings)),
        stage_numbers(layout.file),
        time_line(layout.has(ColumnRole::time), layout.has(ColumnRole::stage_time)) {
    describe_record(header, layout, findings);
    take_cells(header, *source, layout, findings);
    read_document(metadata_file, metadata);
    apply_sets(options, false);
    settle_stages();
    check_stages_to_set(options);
    apply_sets(options, true);
    header.digest = sha256(source->file());
    rows.emplace(*source, layout, findings, header.warnings);
    waiting = draw(first);
    if (!waiting) throw BadInput(layout.file, layout.heading_line, "no row of readings");
  }

  TomlTable parse_preamble(const std::string& toml) const;
  void read_document(const std::string& metadata_file, const std::string& metadata);
  void apply_sets(const RecordOptions& options, bool stages);
  void settle_guess(const std::string& key);
  void tell_contradiction(const SpecimenInfo& before, const std::string& where);
  void settle_stages();
  void settle_drainage(StageInfo& only);
  std::vector<StageSummary> stages_of_rows() const;
  void check_stages_to_set(const RecordOptions& options);
  std::set<int> stages_in_rows() const;
  void look_for_typed_height(const std::vector<StageSummary>& summaries);
  bool draw(Reading& reading);
  int stage_of(const Row& drawn);
  void finish();

  std::unique_ptr<ByteSource> source;
  RecordHeader header;
  Findings findings;
  TableLayout layout;
  StageNumbers stage_numbers;
  TimeLine time_line;
  CounterJoin counters;
  std::optional<Truth> truth;
  std::array<bool, kQuantityCount> filled{};
  Row row;
  Reading first;
  bool waiting = false;
  bool over = false;
  std::int64_t count = 0;
  int stage = 0;
  std::optional<RowsAhead> rows;  ///< reads `source`, and ends before it
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

void RecordedRig::Impl::apply_sets(const RecordOptions& options, bool stages) {
  for (const auto& [key, value] : options.sets) {
    const auto where = fmt::format("--set {}={}", key, value);
    // Whether soil or a program gave the readings is for the record to say, not for its reader.
    if (key == "test.origin" || key == "test.seed")
      throw BadInput(
          fmt::format("{}: {} describes the origin of the record; it cannot be set", where, key));
    if (key.starts_with("stages.") != stages) continue;
    const SpecimenInfo before = header.specimen;
    set_metadata(header, where, key, value);
    tell_contradiction(before, where);
    if (stages) settle_guess(key);
  }
}

/// What was said is asked no more: the other answers to it go, and with the last of them, or with
/// the drainage, the guess itself.
void RecordedRig::Impl::settle_guess(const std::string& key) {
  const auto number = stage_in(key);
  if (!number) return;
  const bool drainage = key.ends_with(".drainage");
  if (drainage)
    std::ranges::find(header.stages, *number, &StageInfo::number)->drainage_was_said = true;
  std::erase_if(header.guesses, [&](Guess& guess) {
    if (guess.what != "drainage" && guess.what != fmt::format("stage {}", *number)) return false;
    std::erase_if(guess.otherwise, [&](const Guess::Said& said) { return said.key == key; });
    return drainage && guess.otherwise.empty();
  });
}

/// What is said stands over what the file says; that they differ may be a slip of either.
void RecordedRig::Impl::tell_contradiction(const SpecimenInfo& before, const std::string& where) {
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
    if (layout.dialect.drainage_from_columns && !names_drainage(header.programme))
      settle_drainage(header.stages.front());
    return;
  }
  // The file numbers its stages but does not say what they are: look at all of it once.
  const auto summaries = stages_of_rows();
  header.stages = infer_stages(summaries, header.specimen);
  for (const StageInfo& info : header.stages)
    header.guesses.push_back(stage_guess(
        *std::ranges::find(summaries, info.number, &StageSummary::number), info, header.specimen));
  look_for_typed_height(summaries);
}

/// The only stage of a record that does not say whether it was drained: its columns may.
void RecordedRig::Impl::settle_drainage(StageInfo& only) {
  if (only.drainage == Drainage::unknown && header.has(Quantity::back_volume)) {
    const auto summaries = stages_of_rows();
    only.drainage = infer_stages(summaries, header.specimen)[0].drainage;
    header.guesses.push_back(stage_guess(summaries.front(), only, header.specimen));
    return;
  }
  if (only.drainage == Drainage::unknown) return;
  if (!header.has(Quantity::volumetric_strain)) {
    header.guesses.push_back(drainage_guess(only, "it has a pore pressure and no volume"));
    return;
  }
  const auto summaries = stages_of_rows();
  const double range = summaries.front()[Quantity::volumetric_strain].range();
  constexpr double kStands = 1e-4;
  only.drainage = range > kStands ? Drainage::open : Drainage::closed;
  header.guesses.push_back(
      drainage_guess(only, fmt::format("its volumetric strain changes by {:.3g} %", range * 100)));
  auto& otherwise = header.guesses.back().otherwise;
  // Between a strain that is nothing and one that is plainly water nobody knows.
  constexpr double kPlain = 1e-3;
  if (range > kStands && range <= kPlain)
    otherwise.push_back({fmt::format("stages.{}.drainage", only.number), "closed"});
  if (range > kStands && only.control == AxialControl::unknown && was_unconfined(summaries.front()))
    otherwise.push_back({fmt::format("stages.{}.control", only.number), "constant_q"});
}

std::vector<StageSummary> RecordedRig::Impl::stages_of_rows() const {
  std::vector<Warning> repeated;
  Findings scratch(repeated);
  TableReader reader(*source, layout, scratch);
  StageNumbers numbers(layout.file);
  return summarise_stages(
      reader, [&](double value, std::int64_t line) { return numbers.of(value, line, scratch); });
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
void RecordedRig::Impl::check_stages_to_set(const RecordOptions& options) {
  std::optional<std::set<int>> known;
  for (const auto& [key, value] : options.sets) {
    const auto number = stage_in(key);
    if (!number || header.stage(*number)) continue;
    if (!known) {
      known = layout.has(ColumnRole::stage) ? stages_in_rows() : std::set<int>();
      for (const StageInfo& info : header.stages) known->insert(info.number);
    }
    if (!known->contains(*number))
      throw BadInput(fmt::format("--set {}={}: {} has no stage {}; it has {}", key, value,
                                 layout.file, *number, fmt::join(*known, ", ")));
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
  if (count > 0) return stage;
  return header.stages.empty() ? 1 : header.stages.front().number;
}

bool RecordedRig::Impl::draw(Reading& reading) {
  if (over || !rows->next(row)) {
    finish();
    return false;
  }
  const int number = stage_of(row);
  const bool begins = count == 0 || number != stage;
  stage = number;
  if (begins && !header.stage(stage))
    findings.note("unnamed stage", row.line,
                  fmt::format("stage {} has no description; its role is unknown", stage));
  reading.time_s = time_line.next(row.time_s, row.stage_time_s, stage, begins, row.line, findings);
  if (header.origin == Origin::recorded) {
    counters.apply(row.si, stage, begins, row.line, findings);
    header.back_volume_joined = counters.joined(Quantity::back_volume);
  }
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
    throw BadInput(layout.file, row.line,
                   fmt::format("the time is the same in all {} rows; leave the time column out",
                               time_line.rows()));
  std::vector<Quantity> held;
  for (const Quantity q : header.columns)
    if (filled[index(q)]) held.push_back(q);
  if (count > 0)
    if (const auto missing = missing_channels(held); !missing.empty())
      throw BadInput(layout.file, layout.heading_line, "a column without any value: " + missing);
  if (!rows->trailer().empty()) {
    RecordHeader end;
    read_metadata(end, truth, TomlTable::parse(rows->trailer(), layout.file, rows->trailer_line()));
    if (header.cut_short.empty()) header.cut_short = end.cut_short;
  }
  over = true;
  findings.finish();
  rows->finish();
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

std::unique_ptr<RecordedRig> open_record(const std::string& path, const RecordOptions& options) {
  auto source = open_readings(path, options);
  const auto beside = std::filesystem::path(path).replace_extension(".toml");
  std::error_code unreadable;
  if (beside == path || beside == options.dialect ||
      !std::filesystem::is_regular_file(beside, unreadable))
    return std::make_unique<RecordedRig>(std::move(source), options, "", "");
  return std::make_unique<RecordedRig>(std::move(source), options, beside.string(),
                                       read_text_file(beside.string()));
}

std::unique_ptr<RecordedRig> open_record(std::unique_ptr<ByteSource> source,
                                         const RecordOptions& options) {
  return std::make_unique<RecordedRig>(sheet_or_text(std::move(source), options), options, "", "");
}

}  // namespace triax::lab
