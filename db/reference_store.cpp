// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/reference_store.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <QDateTime>
#include <filesystem>

#include "db/connection.hpp"
#include "db/exact_row.hpp"

namespace triax::db {
namespace {

template <class Row, class Specimen>
void visit_reference_specimen(Row& row, Specimen& of) {
  row.or_null("location", of.location);
  row.or_null("sample_reference", of.sample_reference);
  row.or_null("sample_type", of.sample_type);
  row.or_null("sample_id", of.sample_id);
  row.or_null("specimen_reference", of.specimen_reference);
  row("sample_top_m", of.sample_top_m, "m");
  row("specimen_depth_m", of.specimen_depth_m, "m");
}

template <class Row, class Result>
void visit_reference_result(Row& row, Result& of) {
  row("group_name", of.group);
  row("line", of.line);
  visit_reference_specimen(row, of.specimen);
  row.or_null("test_type", of.test_type);
  row.or_null("condition", of.condition);
  row.or_null("stage", of.stage);
  row("diameter_mm", of.diameter_m, "mm");
  row("height_mm", of.height_m, "mm");
  row("initial_water_content_pct", of.initial_water_content, "%");
  row("final_water_content_pct", of.final_water_content, "%");
  row("bulk_density_Mg_m3", of.bulk_density_kg_m3, "Mg/m3");
  row("dry_density_Mg_m3", of.dry_density_kg_m3, "Mg/m3");
  row("b_value", of.b_value);
  row("back_pressure_kPa", of.back_pressure_pa, "kPa");
  row("consolidation_pressure_kPa", of.consolidation_pressure_pa, "kPa");
  row("cell_pressure_kPa", of.cell_pressure_pa, "kPa");
  row("initial_pore_pressure_kPa", of.initial_pore_pressure_pa, "kPa");
  row("q_kPa", of.q_pa, "kPa");
  row("pore_pressure_kPa", of.pore_pressure_pa, "kPa");
  row("axial_strain_pct", of.axial_strain, "%");
  row("volumetric_strain_pct", of.volumetric_strain, "%");
  row("undrained_strength_kPa", of.undrained_strength_pa, "kPa");
  row.or_null("failure_mode", of.failure_mode);
  row("cohesion_kPa", of.cohesion_pa, "kPa");
  row("friction_angle_deg", of.friction_angle_rad, "deg");
  row.or_null("failure_criterion", of.failure_criterion);
  row.or_null("remarks", of.remarks);
  // For those who ask the database; a result that is read computes them again.
  auto p_eff_pa = of.p_eff_pa(), s_eff_pa = of.s_eff_pa(), t_pa = of.t_pa();
  row.follows("p_eff_kPa", p_eff_pa, "kPa");
  row.follows("s_eff_kPa", s_eff_pa, "kPa");
  row.follows("t_kPa", t_pa, "kPa");
}

std::string path_from_root(const std::string& source) {
  std::error_code unreadable;
  const auto path = std::filesystem::weakly_canonical(source, unreadable);
  return unreadable ? source : path.string();
}

std::string columns_to_read() {
  ColumnNames names;
  lab::ReferenceResult blank;
  visit_reference_result(names, blank);
  return select_sql("reference_results", {}, names.names(), {}) +
         " WHERE source_path = ? ORDER BY id";
}

}  // namespace

void store_reference_results(const std::string& db, const ReferenceFile& file,
                             const std::vector<lab::ReferenceResult>& results) {
  SQLite::Database database = open_for_writing(db);
  try {
    const std::string path = path_from_root(file.source);
    const std::string now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement older(database, "DELETE FROM reference_results WHERE source_path = ?");
    older.bind(1, path);
    older.exec();
    for (const lab::ReferenceResult& result : results)
      insert_row(database, "reference_results", {}, [&](auto& row) {
        row("source", file.source);
        row("source_path", path);
        row.or_null("project", file.project);
        row("imported_at", now);
        visit_reference_result(row, result);
      });
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw_for(error, db);
  }
}

std::vector<lab::ReferenceResult> load_reference_results(const std::string& db,
                                                         const std::string& source) {
  SQLite::Database database = open_for_reading(db);
  try {
    SQLite::Statement select(database, columns_to_read());
    select.bind(1, path_from_root(source));
    std::vector<lab::ReferenceResult> results;
    while (select.executeStep()) {
      RowReader row(select);
      visit_reference_result(row, results.emplace_back());
    }
    return results;
  } catch (const SQLite::Exception& error) {
    throw_for(error, db);
  }
}

}  // namespace triax::db
