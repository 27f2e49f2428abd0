// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scan_writer.hpp"

#include <SQLiteCpp/Statement.h>

#include <string>

#include "db/channel_columns.hpp"
#include "db/columns.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::db {
namespace {

void bind_unless_zero(PlainStatement& statement, int parameter, std::int64_t bits) {
  if (bits != 0)
    statement.bind(parameter, bits);
  else
    statement.bind_null(parameter);
}

std::string insert_scans() {
  const std::string columns = column_list(scan_columns());
  return "INSERT INTO scans (" + columns + ") SELECT " + columns + " FROM incoming_scans";
}

std::string insert_detail() {
  std::string marks = "?";
  for (std::size_t i = 1; i < detail_columns().size(); ++i) marks += ",?";
  return "INSERT INTO scan_details (" + column_list(detail_columns()) + ") VALUES (" + marks + ")";
}

ScanSource& registered(SQLite::Database& database, ScanSource& source) {
  register_scan_source(database.getHandle(), source);
  return source;
}

}  // namespace

std::map<int, StageReference> stage_references(SQLite::Database& database, std::int64_t test_id) {
  PlainStatement select(
      database, "SELECT stage, void_ratio, area_m2 FROM stage_references WHERE test_id = ?");
  select.bind(1, test_id);
  std::map<int, StageReference> result;
  while (select.step())
    result[static_cast<int>(select.integer(0))] = {select.number(1), select.number(2)};
  return result;
}

ScanWriter::ScanWriter(SQLite::Database& database, std::int64_t test_id)
    : database_(database),
      test_id_(test_id),
      source_{{}, [this](const Scan& scan, ScanRow& row) { return encode_row(scan, row); }, {}},
      scans_((registered(database, source_), database), insert_scans().c_str()),
      detail_(database, insert_detail().c_str()),
      work_(database,
            "INSERT INTO work_points (id, time_s, small_strain, eulerian, semi_lagrangian, "
            "normalised, normalised_error, window_readings, axial_strain_path) "
            "VALUES (?,?,?,?,?,?,?,?,?) "
            // No test is lost for a second point at one reading: the first stands.
            "ON CONFLICT (id) DO NOTHING"),
      references_(stage_references(database, test_id)) {}

std::int64_t ScanWriter::key(std::int64_t reading) const {
  if (reading < 0 || reading > 0xffffffff)
    throw lab::WorkFailed("reading " + std::to_string(reading) +
                          " cannot be stored: readings must be 0 to 4294967295");
  return test_id_ << 32 | reading;
}

const StageReference& ScanWriter::reference(const lab::State& state) {
  if (current_ != nullptr && state.stage == current_stage_) return *current_;
  const auto [place, is_new] = references_.try_emplace(state.stage, StageReference{});
  if (is_new) {
    place->second = reference_of(state);
    new_stages_.push_back(state.stage);
  }
  current_stage_ = state.stage;
  current_ = &place->second;
  return *current_;
}

std::int64_t ScanWriter::encode_row(const Scan& scan, ScanRow& row) {
  const std::int64_t id = key(scan.reading.number);
  if (encode(scan.reading, scan.state, reference(scan.state), row, found_))
    details_.emplace_back(id, found_);
  return id;
}

void ScanWriter::write(std::span<const Scan> scans) {
  source_.scans = scans;
  try {
    scans_.run();
  } catch (const SQLite::Exception&) {
    if (source_.failure) std::rethrow_exception(source_.failure);
    throw;
  }
  write_details();
  write_references();
}

void ScanWriter::write_references() {
  for (const int stage : new_stages_) {
    const StageReference& reference = references_.at(stage);
    SQLite::Statement insert(database_, "INSERT INTO stage_references VALUES (?,?,?,?)");
    Binder(insert)
        .integer(test_id_)
        .integer(stage)
        .number(reference.void_ratio)
        .number(reference.area_m2)
        .run();
  }
  new_stages_.clear();
}

void ScanWriter::write_details() {
  for (const auto& [id, detail] : details_) {
    int parameter = 1;
    detail_.bind(parameter++, id);
    for (const double value : detail.given) detail_.bind(parameter++, value);
    bind_unless_zero(detail_, parameter++, detail.given_last_bits);
    for (const double value : detail.state_si) detail_.bind(parameter++, value);
    detail_.bind(parameter, detail.state_missing);
    detail_.run();
  }
  details_.clear();
}

void ScanWriter::write(const lab::SecondOrderWorkPoint& point) {
  work_.bind(1, key(point.reading));
  work_.bind(2, point.time_s);
  work_.bind(3, point.work.small_strain);
  work_.bind(4, point.work.eulerian);
  work_.bind(5, point.work.semi_lagrangian);
  work_.bind(6, point.work.normalised);
  work_.bind(7, point.normalised_error);
  work_.bind(8, point.window_readings);
  work_.bind(9, point.axial_strain_path);
  work_.run();
}

}  // namespace triax::db
