#include "db/scan_writer.hpp"

#include <SQLiteCpp/Statement.h>

#include <string>

#include "db/columns.hpp"
#include "lab/records/bad_input.hpp"

namespace triax::db {
namespace {

void bind_unless_zero(PlainStatement& statement, int parameter, std::int64_t bits) {
  if (bits != 0)
    statement.bind(parameter, bits);
  else
    statement.bind_null(parameter);
}

}  // namespace

ScanWriter::ScanWriter(SQLite::Database& database, std::int64_t test_id)
    : database_(database),
      test_id_(test_id),
      scan_(database, "INSERT INTO scans VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
      detail_(database,
              "INSERT INTO scan_details VALUES "
              "(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
      work_(database, "INSERT INTO work_points VALUES (?,?,?,?,?,?,?,?)") {}

std::int64_t ScanWriter::key(std::int64_t reading) const {
  if (reading < 0 || reading > 0xffffffff)
    throw lab::WorkFailed("reading " + std::to_string(reading) +
                          " cannot be stored: a test holds readings 0 to 4294967295");
  return test_id_ << 32 | reading;
}

const StageReference& ScanWriter::reference(const lab::State& state) {
  if (current_ != nullptr && state.stage == current_stage_) return *current_;
  const auto [place, is_new] = references_.try_emplace(state.stage, StageReference{});
  if (is_new) {
    place->second = reference_of(state);
    SQLite::Statement insert(database_, "INSERT INTO stage_references VALUES (?,?,?,?)");
    Binder(insert)
        .integer(test_id_)
        .integer(state.stage)
        .number(place->second.void_ratio)
        .number(place->second.area_m2)
        .run();
  }
  current_stage_ = state.stage;
  current_ = &place->second;
  return *current_;
}

void ScanWriter::write(const lab::Reading& reading, const lab::State& state) {
  ScanRow row;
  ScanDetail detail;
  const bool detailed = encode(reading, state, reference(state), row, detail);
  const std::int64_t id = key(row.number);
  scan_.bind(1, id);
  scan_.bind(2, row.time_s);
  scan_.bind(3, std::int64_t{row.stage});
  for (std::size_t i = 0; i < row.raw.size(); ++i) scan_.bind(4 + static_cast<int>(i), row.raw[i]);
  scan_.bind(11, row.axial_strain);
  scan_.bind(12, row.volumetric_strain);
  scan_.bind(13, row.q_pa);
  scan_.bind(14, row.p_eff_pa);
  bind_unless_zero(scan_, 15, row.last_bits);
  scan_.run();
  if (detailed) write_detail(id, detail);
}

void ScanWriter::write_detail(std::int64_t id, const ScanDetail& detail) {
  int parameter = 1;
  detail_.bind(parameter++, id);
  for (const double value : detail.given) detail_.bind(parameter++, value);
  bind_unless_zero(detail_, parameter++, detail.given_last_bits);
  for (const double value : detail.state_si) detail_.bind(parameter++, value);
  detail_.bind(parameter, detail.state_missing);
  detail_.run();
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
  work_.run();
}

}  // namespace triax::db
