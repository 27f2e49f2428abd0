#include "lab/rig/recorded.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "lab/records/bad_input.hpp"
#include "lab/records/channels.hpp"
#include "lab/records/counter_join.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/record_head.hpp"
#include "lab/records/stage_inference.hpp"
#include "lab/records/table_reader.hpp"
#include "lab/records/time_line.hpp"

namespace triax::lab {
namespace {

std::optional<Dialect> named_dialect(const RecordOptions& options) {
  if (options.dialect.empty()) return std::nullopt;
  return find_dialect(options.dialect);
}

// A stage number as the file has it; "4.1" of an advanced module becomes 41.
int stage_number(double value, const TableLayout& layout, std::int64_t line, Findings& findings) {
  constexpr double kLargest = 1e6;
  const bool fits = value >= 0 && value <= kLargest;
  if (fits && value == std::floor(value)) return static_cast<int>(value);
  const double tenfold = std::round(10 * value);
  if (!fits || std::abs(10 * value - tenfold) > 1e-6)
    throw BadInput(layout.file, line, fmt::format("{} is no number of a stage", value));
  findings.note("stage number", line,
                fmt::format("stage {} is called stage {}", value, static_cast<int>(tenfold)));
  return static_cast<int>(tenfold);
}

}  // namespace

struct RecordedRig::Impl {
  Impl(std::unique_ptr<ByteSource> bytes, const RecordOptions& options,
       const std::string& metadata_file, const std::string& metadata)
      : source(std::move(bytes)),
        findings(header.warnings),
        layout(recognise_table(*source, named_dialect(options), findings)),
        time_line(layout.has(ColumnRole::time), layout.has(ColumnRole::stage_time)) {
    describe_record(header, layout, findings);
    read_document(metadata_file, metadata);
    apply_sets(options, false);
    settle_stages();
    apply_sets(options, true);
    table.emplace(*source, layout, findings);
    waiting = draw(first);
    if (!waiting) throw BadInput(layout.file, layout.heading_line, "no row of readings");
  }

  TomlTable parse_preamble(const std::string& toml) const;
  void read_document(const std::string& metadata_file, const std::string& metadata);
  void apply_sets(const RecordOptions& options, bool stages);
  void settle_stages();
  void look_for_typed_height(const std::vector<StageSummary>& summaries);
  bool draw(Reading& reading);
  int stage_of(const Row& drawn);
  void finish();

  std::unique_ptr<ByteSource> source;
  RecordHeader header;
  Findings findings;
  TableLayout layout;
  TimeLine time_line;
  CounterJoin counters;
  std::optional<TableReader> table;
  std::optional<Truth> truth;
  std::array<bool, kQuantityCount> filled{};
  Row row;
  Reading first;
  bool waiting = false;
  bool over = false;
  std::int64_t count = 0;
  int stage = 0;
};

TomlTable RecordedRig::Impl::parse_preamble(const std::string& toml) const {
  try {
    return TomlTable::parse(toml, layout.file);
  } catch (const BadInput& error) {
    throw BadInput(std::string(error.what()) +
                   " (lines behind # hold TOML; begin a free remark with ##)");
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
  for (const auto& [key, value] : options.sets)
    if (key.starts_with("stages.") == stages)
      set_metadata(header, fmt::format("--set {}={}", key, value), key, value);
}

void RecordedRig::Impl::settle_stages() {
  if (!header.stages.empty()) return;
  if (!layout.has(ColumnRole::stage)) {
    header.stages.push_back(single_stage(layout, header.programme));
    return;
  }
  // The file numbers its stages but does not say what they are: look at all of it once.
  std::vector<Warning> repeated;
  Findings scratch(repeated);
  TableReader reader(*source, layout, scratch);
  const auto summaries = summarise_stages(reader, [&](double value, std::int64_t line) {
    return stage_number(value, layout, line, scratch);
  });
  header.stages = infer_stages(summaries, header.specimen);
  look_for_typed_height(summaries);
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
  findings.note("typed height", found->first_line,
                fmt::format("the file's own axial strain in stage {} is the displacement over "
                            "{:.2f} mm, not over the {:.2f} mm that the displacement of the stages "
                            "before leaves: the operator typed in a new start height; it is taken "
                            "as the consolidated height",
                            found->number, *typed * 1e3, ours * 1e3));
}

int RecordedRig::Impl::stage_of(const Row& drawn) {
  if (!std::isnan(drawn.stage)) return stage_number(drawn.stage, layout, drawn.line, findings);
  if (count > 0) return stage;
  return header.stages.empty() ? 1 : header.stages.front().number;
}

bool RecordedRig::Impl::draw(Reading& reading) {
  if (over || !table->next(row)) {
    finish();
    return false;
  }
  const int number = stage_of(row);
  const bool begins = count == 0 || number != stage;
  stage = number;
  if (begins && !header.stage(stage))
    findings.note("unnamed stage", row.line,
                  fmt::format("stage {} is not described; its role is unknown", stage));
  reading.time_s = time_line.next(row.time_s, row.stage_time_s, stage, begins, row.line, findings);
  if (header.origin == Origin::recorded) counters.apply(row.si, stage, begins, row.line, findings);
  reading.number = count++;
  reading.stage = stage;
  reading.si = row.si;
  reading.line = row.line;
  for (std::size_t i = 0; i < filled.size(); ++i) filled[i] |= !std::isnan(row.si[i]);
  constexpr std::int64_t kPatience = 1000;
  if (count == kPatience && time_line.stands_still()) finish();
  return true;
}

void RecordedRig::Impl::finish() {
  if (over) return;
  if (time_line.stands_still())
    throw BadInput(layout.file, row.line,
                   fmt::format("the time is the same in all {} rows; without a time that runs, "
                               "leave the time column out",
                               time_line.rows()));
  std::vector<Quantity> held;
  for (const Quantity q : header.columns)
    if (filled[index(q)]) held.push_back(q);
  if (count > 0)
    if (const auto missing = missing_channels(held); !missing.empty())
      throw BadInput(layout.file, layout.heading_line,
                     "a column without a single value: " + missing);
  if (!table->trailer().empty()) {
    RecordHeader unused;
    read_metadata(unused, truth,
                  TomlTable::parse(table->trailer(), layout.file, table->trailer_line()));
  }
  over = true;
  findings.finish();
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
  return size > 0 ? std::min(1.0, static_cast<double>(impl_->table->position()) / size) : 0.0;
}

std::unique_ptr<RecordedRig> open_record(const std::string& path, const RecordOptions& options) {
  auto source = open_file(path);
  const auto beside = std::filesystem::path(path).replace_extension(".toml");
  std::error_code unreadable;
  if (beside == path || beside == options.dialect ||
      !std::filesystem::is_regular_file(beside, unreadable))
    return open_record(std::move(source), options);
  return std::make_unique<RecordedRig>(std::move(source), options, beside.string(),
                                       read_text_file(beside.string()));
}

std::unique_ptr<RecordedRig> open_record(std::unique_ptr<ByteSource> source,
                                         const RecordOptions& options) {
  return std::make_unique<RecordedRig>(std::move(source), options, "", "");
}

}  // namespace triax::lab
