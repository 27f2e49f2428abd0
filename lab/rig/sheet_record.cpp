// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/sheet_record.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/metadata.hpp"
#include "lab/workbook/sheet_source.hpp"

namespace triax::lab {
namespace {

/// A copy of all bytes, for archives that lie in memory.
std::string bytes_of(ByteSource& source) {
  std::string bytes(source.size(), '\0');
  source.rewind();
  std::size_t taken = 0;
  while (const auto count = source.read({bytes.data() + taken, bytes.size() - taken}))
    taken += count;
  source.rewind();
  bytes.resize(taken);
  return bytes;
}

/// Why its table is not recognised; empty where it is.
std::string refusal(ByteSource& sheet, const std::optional<Dialect>& forced) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  try {
    recognise_table(sheet, forced, findings);
    return {};
  } catch (const BadInput& error) {
    return error.what();
  }
}

std::unique_ptr<ByteSource> chosen_sheet(ZipArchive archive, std::unique_ptr<ByteSource> file,
                                         const RecordOptions& options) {
  const auto book = std::make_shared<const Workbook>(std::move(archive));
  const std::shared_ptr<ByteSource> behind = std::move(file);
  std::optional<Dialect> forced;
  if (!options.dialect.empty()) forced = find_dialect(options.dialect);
  const std::string wanted = !options.sheet.empty() ? options.sheet
                             : forced               ? forced->sheet
                                                    : std::string();
  if (!wanted.empty()) return std::make_unique<SheetSource>(book, book->sheet(wanted), behind);
  std::string first;
  for (const SheetEntry& entry : book->sheets()) {
    auto sheet = std::make_unique<SheetSource>(book, entry, behind);
    const auto why = refusal(*sheet, forced);
    if (why.empty()) {
      sheet->rewind();
      return sheet;
    }
    if (first.empty()) first = why;
  }
  if (book->sheets().size() > 1)
    first = fmt::format("{}: no readings recognised in its {} worksheets; first worksheet: {}",
                        book->name(), book->sheets().size(), first);
  throw BadInput(first);
}

}  // namespace

std::unique_ptr<ByteSource> sheet_or_text(std::unique_ptr<ByteSource> source,
                                          const RecordOptions& options) {
  if (!looks_like_workbook(*source)) return source;
  auto archive = ZipArchive::in_memory(source->name(), bytes_of(*source));
  return chosen_sheet(std::move(archive), std::move(source), options);
}

std::unique_ptr<ByteSource> open_readings(const std::string& path, const RecordOptions& options) {
  auto file = open_file(path);
  if (!looks_like_workbook(*file)) return file;
  return chosen_sheet(ZipArchive::open(path), std::move(file), options);
}

void take_cells(RecordHeader& header, ByteSource& source, const TableLayout& layout,
                Findings& findings) {
  const auto* const sheet = dynamic_cast<const SheetSource*>(&source);
  if (sheet == nullptr) return;
  for (const DialectKey& key : layout.dialect.keys)
    for (const std::string& label : key.labels) {
      if (!is_cell_reference(label)) continue;
      const auto value = cell_of(sheet->book(), label);
      if (value.empty()) continue;
      try {
        set_metadata(header, fmt::format("{}: cell {}", layout.file, label), key.key, value);
      } catch (const BadInput& error) {
        findings.note("cell " + key.key, 0, std::string(error.what()) + "; ignored");
      }
    }
  if (sheet->book().sheets().size() > 1)
    findings.note("sheet", 0,
                  fmt::format("the readings are from worksheet {}; use --sheet NAME for another",
                              excerpt(sheet->sheet().name)));
}

}  // namespace triax::lab
