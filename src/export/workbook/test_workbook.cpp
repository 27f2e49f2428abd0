// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/test_workbook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "lab/base/bad_input.hpp"
#include "lab/measured/unread_steps.hpp"
#include "src/export/workbook/charts_sheet.hpp"
#include "src/export/workbook/readings_sheet.hpp"
#include "src/export/workbook/states_sheet.hpp"
#include "src/export/workbook/verdict_sheet.hpp"
#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {
namespace {

/// What is known of a test once its scans were seen: then the sheets can be written row by row.
struct Overview {
  explicit Overview(const lab::RecordHeader& header) : windows(header) {}

  struct Stage {
    std::int64_t first = 0, last = 0, readings = 0;
  };
  WorkWindows windows;
  std::map<int, Stage> stages;
  std::optional<ShearRows> shear;
};

/// The states of shear as the charts draw them, row by row.
class ChartWriter {
 public:
  ChartWriter(const db::Store& store, const db::StoredTest& test)
      : header_(test.header), steps_(test.header.has_time) {
    breaks_.faults = study::faulty_spans(store, test);
  }

  void add(std::size_t row, lab::Reading reading, lab::State state, ShearRows& rows) {
    study::remove_faulty(breaks_.faults, header_, reading, state);
    if (steps_.add(state)) breaks_.unread_steps.push_back(state.reading);
    rows.last = row;
    rows.add_pore(state.pore_pressure * 1e-3);
    const double strain = state.strain.axial;
    add_to(rows.q, q_, row, state, strain, state.q);
    add_to(rows.path, path_, row, state, state.p_eff, state.q);
    add_to(rows.pore, pore_, row, state, strain, state.pore_pressure);
    add_to(rows.volume, volume_, row, state, strain, state.volumetric_strain);
  }

 private:
  static void add_to(ChartLines& lines, study::Joiner& joiner, std::size_t row,
                     const lab::State& state, double x, double y) {
    if (std::isfinite(x) && std::isfinite(y))
      lines.add(row, joiner.join(state));
    else
      joiner.skip(state);
  }

  const lab::RecordHeader& header_;
  study::LineBreaks breaks_;
  lab::UnreadSteps steps_;
  study::Joiner q_{breaks_}, path_{breaks_}, pore_{breaks_}, volume_{breaks_};
};

void look_over(const db::Store& store, const db::StoredTest& test, Overview& seen) {
  ChartWriter charts(store, test);
  std::size_t row = kFirstRow;
  store.for_each_scan(test.id, 1, [&](const lab::Reading& reading, const lab::State& state) {
    seen.windows.add(state, row);
    const auto [stage, is_new] = seen.stages.try_emplace(reading.stage);
    if (is_new) stage->second.first = reading.number;
    stage->second.last = reading.number;
    ++stage->second.readings;
    if (study::is_shear(test.header, reading.stage)) {
      if (!seen.shear) seen.shear = ShearRows{.first = row, .last = row};
      charts.add(row, reading, state, *seen.shear);
    }
    ++row;
  });
  seen.windows.finish();
}

void write_stages(Sheet& sheet, const db::StoredTest& test, const Overview& seen) {
  sheet.widths(0, 9, 16);
  constexpr auto headings =
      std::to_array<const char*>({"stage", "name", "role", "drainage", "control", "strain_path_R",
                                  "first_reading", "last_reading", "readings"});
  for (std::size_t i = 0; i < headings.size(); ++i)
    sheet.text(kHeadingRow, i, headings[i], Look::heading);
  std::size_t row = kFirstRow;
  for (const auto& [number, stage] : seen.stages) {
    sheet.number(row, 0, number);
    if (const lab::StageInfo* const info = test.header.stage(number)) {
      sheet.text(row, 1, info->name);
      sheet.text(row, 2, std::string(to_string(info->role)));
      sheet.text(row, 3, std::string(to_string(info->drainage)));
      sheet.text(row, 4, std::string(to_string(info->control)));
      sheet.number(row, 5, info->strain_path_R.value_or(lab::kMissing));
    }
    sheet.number(row, 6, static_cast<double>(stage.first));
    sheet.number(row, 7, static_cast<double>(stage.last));
    sheet.number(row++, 8, static_cast<double>(stage.readings));
  }
}

std::size_t reference_heading_row(const Overview& seen) {
  return kFirstRow + seen.stages.size() + 2;
}

void write_references(Sheet& sheet, const std::vector<ReferenceRow>& references, std::size_t row) {
  if (references.empty()) return;
  sheet.text(row - 1, 0, "Dimensions from which strains count", Look::heading);
  constexpr auto headings = std::to_array<const char*>(
      {"from_reading", "stage", "height_m", "volume_m3", "area_m2", "displacement_m",
       "back_volume_m3", "void_ratio", "membrane_4Et_over_D_Pa", "height from"});
  for (std::size_t i = 0; i < headings.size(); ++i) sheet.text(row, i, headings[i], Look::heading);
  const auto column = [](ReferenceCell place) { return static_cast<std::size_t>(place); };
  for (const ReferenceRow& reference : references) {
    ++row;
    sheet.number(row, column(ReferenceCell::from_reading),
                 static_cast<double>(reference.from_reading));
    sheet.number(row, column(ReferenceCell::stage), reference.stage);
    const auto put = [&](ReferenceCell place, const Term& term) {
      if (term.text.empty())
        sheet.exact(row, column(place), term.value);
      else
        sheet.formula(row, column(place), term);
    };
    const auto here = [&](ReferenceCell place, const Term& term) {
      return cell(address(column(place), row + 1), term.value);
    };
    put(ReferenceCell::height_m, reference.height_m);
    put(ReferenceCell::volume_m3, reference.volume_m3);
    put(ReferenceCell::area_m2, over(here(ReferenceCell::volume_m3, reference.volume_m3),
                                     here(ReferenceCell::height_m, reference.height_m)));
    put(ReferenceCell::displacement_m, reference.displacement_m);
    put(ReferenceCell::back_volume_m3, reference.back_volume_m3);
    put(ReferenceCell::void_ratio, reference.void_ratio);
    put(ReferenceCell::membrane_pa, reference.membrane_pa);
    sheet.text(row, column(ReferenceCell::how), reference.how);
  }
}

bool is_closed_in_shear(const lab::RecordHeader& header) {
  return std::ranges::any_of(header.stages, [&](const lab::StageInfo& stage) {
    return study::is_shear(header, stage.number) && stage.drainage == lab::Drainage::closed;
  });
}

std::vector<Fact> facts_of_record(const TestContent& content) {
  std::vector<Fact> facts;
  for (const Fact& fact : content.facts)
    if (!is_of_verdict(fact) && fact.label != "Specimen" && fact.label != "Start of shear" &&
        fact.label != "From the file")
      facts.push_back(fact);
  return facts;
}

}  // namespace

void refuse_longer_than_a_sheet(const db::Store& store, const db::StoredTest& test) {
  const auto readings = static_cast<std::size_t>(store.scan_count(test.id));
  if (readings > ReadingsSheet(test).room())
    throw lab::BadInput(
        fmt::format("test {} has {} readings, but a worksheet has at most {} rows; nothing was "
                    "written: use --format csv",
                    test.id, readings, kRowsOfSheet));
}

std::size_t export_workbook(const db::Store& store, const study::TestResult& result,
                            const std::string& path) {
  const db::StoredTest& test = result.stored;
  const TestContent content = test_content(result);
  Overview seen(test.header);
  look_over(store, test, seen);

  const std::string title =
      content.banner.empty() ? content.title : content.title + ". " + content.banner;
  Book book(content.title, content.banner, test.stored_at);
  std::vector<Sheet*> sheets;
  for (const char* const name : {kSpecimenSheet, kStagesSheet, kReadingsSheet, kStatesSheet,
                                 kBlocksSheet, kVerdictSheet, kChartsSheet}) {
    Sheet& sheet = *sheets.emplace_back(&book.add_sheet(name));
    if (name != kReadingsSheet)
      sheet.text(kTitleRow, 0, title, content.banner.empty() ? Look::heading : Look::warning);
  }
  Sheet &specimen = *sheets[0], &stages = *sheets[1], &readings = *sheets[2], &states = *sheets[3];
  const SpecimenTerms terms = write_specimen(specimen, test, facts_of_record(content));
  write_stages(stages, test, seen);
  const ReadingsSheet record(test);
  record.begin(readings, title);
  const std::size_t references = reference_heading_row(seen);
  StatesSheet rows(states, test, terms, references + 1, record.first_row(), seen.windows,
                   store.second_order_work(test.id));
  std::size_t reading_row = record.first_row(), state_row = kFirstRow;
  store.for_each_scan(test.id, 1, [&](const lab::Reading& reading, const lab::State& state) {
    record.write(readings, reading_row++, reading);
    rows.write(state_row++, reading, state);
  });
  record.end(readings, reading_row);
  write_references(stages, rows.references(), references);
  rows.work().write_blocks(*sheets[4]);
  write_verdict(*sheets[5], test, content);
  if (seen.shear)
    write_charts(book, *sheets[6], *seen.shear, is_closed_in_shear(test.header),
                 test.header.origin == lab::Origin::simulated ? test.header.name + ", SIMULATED"
                                                              : test.header.name);
  const std::size_t plain = book.without_formula();
  book.finish(path);
  return plain;
}

}  // namespace triax::src
