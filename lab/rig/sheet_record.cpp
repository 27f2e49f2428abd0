// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/sheet_record.hpp"

#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/diggs/diggs_document.hpp"
#include "lab/intake/text/encoding.hpp"
#include "lab/intake/text/file_kind.hpp"
#include "lab/intake/text/structure.hpp"
#include "lab/records/dialect_memory.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/tables/table_recognition.hpp"
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
std::string refusal(ByteSource& sheet, const RecordOptions& options) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  try {
    recognise_table(sheet, dialect_for(sheet, options, findings), findings);
    return {};
  } catch (const SeveralTests&) {
    return {};
  } catch (const BadInput& error) {
    return error.what();
  }
}

std::unique_ptr<ByteSource> text_of(std::unique_ptr<ByteSource> source,
                                    const RecordOptions& options) {
  auto encoding = options.encoding;
  if (const auto dialect = named_dialect(options); dialect && !encoding)
    encoding = dialect->encoding;
  return open_utf8(std::move(source), encoding);
}

/// The worksheet with the most rows of a table, whatever they mean; null if there is none.
std::unique_ptr<ByteSource> largest_table(const std::shared_ptr<const Workbook>& book,
                                          const std::shared_ptr<ByteSource>& file) {
  std::unique_ptr<ByteSource> best;
  std::size_t rows = 0;
  for (const SheetEntry& entry : book->sheets()) {
    auto sheet = std::make_unique<SheetSource>(book, entry, file);
    const TableSample sample = read_sample(*sheet);
    if (!find_structure(sample).structure || sample.size() <= rows) continue;
    rows = sample.size();
    sheet->rewind();
    best = std::move(sheet);
  }
  return best;
}

std::unique_ptr<ByteSource> chosen_sheet(ZipArchive archive, std::unique_ptr<ByteSource> file,
                                         const RecordOptions& options) {
  const auto book = std::make_shared<const Workbook>(std::move(archive));
  const std::shared_ptr<ByteSource> behind = std::move(file);
  const auto forced = named_dialect(options);
  const std::string wanted = !options.sheet.empty() ? options.sheet
                             : forced               ? forced->sheet
                                                    : std::string();
  if (!wanted.empty()) return std::make_unique<SheetSource>(book, book->sheet(wanted), behind);
  std::string first;
  for (const SheetEntry& entry : book->sheets()) {
    auto sheet = std::make_unique<SheetSource>(book, entry, behind);
    const auto why = refusal(*sheet, options);
    if (why.empty()) {
      sheet->rewind();
      return sheet;
    }
    if (first.empty()) first = why;
  }
  if (options.is_to_propose)
    if (auto sheet = largest_table(book, behind)) return sheet;
  if (book->sheets().size() > 1)
    first = fmt::format("{}: no readings recognised in its {} worksheets; first worksheet: {}",
                        book->name(), book->sheets().size(), first);
  throw BadInput(first);
}

}  // namespace

bool is_dialect(const std::filesystem::path& file) {
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(file, unreadable)) return false;
  try {
    return TomlTable::read(file.string()).has("columns");
  } catch (const BadInput&) {
    return false;  // reported where it is read as metadata
  }
}

std::optional<Dialect> named_dialect(const RecordOptions& options) {
  if (!options.dialect_text.empty()) return parse_dialect(options.dialect_text, "the answers");
  if (options.dialect.empty()) return std::nullopt;
  return find_dialect(options.dialect);
}

std::optional<Dialect> dialect_for(ByteSource& table, const RecordOptions& options,
                                   Findings& findings) {
  if (auto named = named_dialect(options)) return named;
  auto remembered = DialectMemory(options.dialect_folder).find(table);
  if (!remembered) return std::nullopt;
  findings.note(
      "remembered dialect", 0,
      fmt::format("the columns are read as remembered for these headings: {}", remembered->file));
  return std::move(remembered->dialect);
}

RecordOptions with_dialect_beside(const std::string& path, const RecordOptions& options) {
  RecordOptions complete = options;
  const auto beside = std::filesystem::path(path).replace_extension(".toml");
  if (!options.names_dialect() && beside != path && is_dialect(beside))
    complete.dialect = beside.string();
  return complete;
}

std::unique_ptr<ByteSource> sheet_or_text(std::unique_ptr<ByteSource> source,
                                          const RecordOptions& options) {
  if (looks_like_diggs(*source)) return source;
  refuse_other_kinds(*source);
  if (!looks_like_workbook(*source)) return text_of(std::move(source), options);
  auto archive = ZipArchive::in_memory(source->name(), bytes_of(*source));
  return chosen_sheet(std::move(archive), std::move(source), options);
}

std::unique_ptr<ByteSource> open_readings(const std::string& path, const RecordOptions& options) {
  auto file = open_file(path);
  if (looks_like_diggs(*file)) return file;
  refuse_other_kinds(*file);
  if (!looks_like_workbook(*file)) return text_of(std::move(file), options);
  return chosen_sheet(ZipArchive::open(path), std::move(file), options);
}

void note_encoding(const ByteSource& source, Findings& findings) {
  const auto* const text = dynamic_cast<const Utf8Source*>(&source);
  if (text == nullptr || text->encoding().is_utf8()) return;
  findings.note("encoding", 0, "not UTF-8: read as " + text->encoding().name);
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
