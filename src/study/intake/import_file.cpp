// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/import_file.hpp"

#include <filesystem>

#include "lab/intake/text/encoding.hpp"
#include "lab/rig/sheet_record.hpp"
#include "lab/workbook/sheet_source.hpp"

namespace triax::study {

ImportFile read_proposals(const std::string& path, const lab::RecordOptions& options) {
  const auto readings = lab::open_readings(path, options);
  ImportFile out;
  out.source.name = std::filesystem::path(path).stem().string();
  if (const auto* const text = dynamic_cast<const lab::Utf8Source*>(readings.get()))
    out.source.encoding = text->encoding().name;
  if (const auto* const sheet = dynamic_cast<const lab::SheetSource*>(readings.get()))
    out.source.sheet = sheet->sheet().name;
  out.proposals = lab::propose(*readings);
  return out;
}

}  // namespace triax::study
