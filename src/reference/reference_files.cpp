// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_files.hpp"

#include "db/reference_store.hpp"
#include "lab/ags/ags_reader.hpp"
#include "lab/diggs/diggs_document.hpp"
#include "lab/intake/text/file_kind.hpp"
#include "lab/workbook/workbook.hpp"

namespace triax::src {

bool ReferenceFiles::take(const std::string& path) {
  const auto source = lab::open_file(path);
  if (lab::looks_like_diggs(*source)) return false;
  lab::refuse_other_kinds(*source);
  if (lab::looks_like_workbook(*source) || !lab::looks_like_ags(*source)) return false;
  files_.push_back(lab::read_triaxial_results(*source));
  return true;
}

void ReferenceFiles::store(const std::string& db) const {
  for (const lab::AgsResults& file : files_)
    db::store_reference_results(db, {.source = file.file, .project = file.project}, file.results);
}

}  // namespace triax::src
