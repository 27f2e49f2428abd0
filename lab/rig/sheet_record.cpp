// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/sheet_record.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/line_reader.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/diggs/diggs_document.hpp"
#include "lab/intake/names/stage_words.hpp"
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

/// A workbook whose worksheets are opened one by one.
struct OpenBook {
  std::shared_ptr<const Workbook> book;
  std::shared_ptr<ByteSource> file;

  std::unique_ptr<SheetSource> open(const SheetEntry& entry,
                                    const std::shared_ptr<const SheetRoles>& roles = {}) const {
    return std::make_unique<SheetSource>(book, entry, file, roles);
  }
};

/// The worksheet with the most rows of a table, whatever they mean; null if there is none.
std::unique_ptr<ByteSource> largest_table(const OpenBook& book,
                                          const std::shared_ptr<const SheetRoles>& roles) {
  std::unique_ptr<ByteSource> best;
  std::size_t rows = 0;
  for (const SheetEntry& entry : book.book->sheets()) {
    auto sheet = book.open(entry, roles);
    const TableSample sample = read_sample(*sheet);
    if (!find_structure(sample).structure || sample.size() <= rows) continue;
    rows = sample.size();
    sheet->rewind();
    best = std::move(sheet);
  }
  return best;
}

void append_lines(SheetSource& sheet, std::vector<std::string>& lines) {
  LineReader reader(sheet);
  std::string_view line;
  for (std::size_t count = 0; count < kMaxHead_lines && reader.next(line); ++count)
    lines.emplace_back(line);
}

std::vector<std::string> headings_of(SheetSource& sheet) {
  const StructureResult found = find_structure(read_sample(sheet));
  return found.structure ? found.structure->headings : std::vector<std::string>();
}

bool is_before_shear(const std::string& sheet) {
  using enum StageRole;
  const StageRole role = read_stage_words(sheet).role;
  return role == saturation || role == b_check || role == consolidation;
}

/// Worksheets that are recognised, with the lines beside of `roles`; adds the lines of the rest.
std::vector<SheetEntry> recognised_sheets(const OpenBook& book, const RecordOptions& options,
                                          const std::shared_ptr<const SheetRoles>& roles,
                                          std::vector<std::string>& lines_of_others) {
  std::vector<SheetEntry> found;
  for (const SheetEntry& entry : book.book->sheets()) {
    const auto sheet = book.open(entry, roles);
    if (refusal(*sheet, options).empty())
      found.push_back(entry);
    else
      append_lines(*sheet, lines_of_others);
  }
  return found;
}

/// A test is a worksheet with the headings of the first one; those of stages before shear come
/// last. Constants that a table needs can be in another worksheet: if no worksheet is recognised
/// without the others, they are read with the lines of the others.
SheetRoles find_roles(const OpenBook& book, const RecordOptions& options) {
  SheetRoles roles;
  auto sheets = recognised_sheets(book, options, {}, roles.beside);
  if (sheets.empty() && book.book->sheets().size() > 1) {
    const auto all = std::make_shared<const SheetRoles>(roles);
    roles.beside.clear();
    sheets = recognised_sheets(book, options, all, roles.beside);
  }
  std::stable_partition(sheets.begin(), sheets.end(),
                        [](const SheetEntry& one) { return !is_before_shear(one.name); });
  std::vector<std::string> headings;
  for (const SheetEntry& entry : sheets) {
    const auto sheet = book.open(entry);
    if (roles.tests.empty()) headings = headings_of(*sheet);
    const bool is_test =
        roles.tests.empty() || (!is_before_shear(entry.name) && headings_of(*sheet) == headings);
    (is_test ? roles.tests : roles.others).push_back(entry.name);
  }
  return roles;
}

/// The worksheet that the options, their dialect or their test name; empty if none does.
std::string named_sheet(const RecordOptions& options) {
  if (!options.sheet.empty()) return options.sheet;
  const auto forced = named_dialect(options);
  if (forced && !forced->sheet.empty()) return forced->sheet;
  const bool is_known =
      options.test > 0 && options.tests && options.test <= options.tests->tables.size();
  return is_known ? options.tests->tables[options.test - 1].sheet : std::string();
}

[[noreturn]] void refuse_workbook(const OpenBook& book, const RecordOptions& options) {
  const auto& sheets = book.book->sheets();
  std::string why = refusal(*book.open(sheets.front()), options);
  if (sheets.size() > 1)
    why = fmt::format("{}: no readings recognised in its {} worksheets; first worksheet: {}",
                      book.book->name(), sheets.size(), why);
  throw BadInput(why);
}

std::unique_ptr<ByteSource> chosen_sheet(ZipArchive archive, std::unique_ptr<ByteSource> file,
                                         const RecordOptions& options) {
  const OpenBook book{std::make_shared<const Workbook>(std::move(archive)), std::move(file)};
  std::string wanted = named_sheet(options);
  if (!wanted.empty()) book.book->sheet(wanted);  // or throws
  const auto roles = options.tests && options.tests->sheets
                         ? options.tests->sheets
                         : std::make_shared<const SheetRoles>(find_roles(book, options));
  if (wanted.empty() && !roles->tests.empty()) wanted = roles->tests.front();
  if (!wanted.empty()) return book.open(book.book->sheet(wanted), roles);
  if (auto sheet = largest_table(book, roles)) return sheet;  // the error names what it lacks
  refuse_workbook(book, options);
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
  if (sheet->book().sheets().size() < 2) return;
  std::vector<std::string> others;
  for (const auto* const names : {&sheet->roles()->tests, &sheet->roles()->others})
    for (const std::string& name : *names)
      if (name != sheet->sheet().name) others.push_back(excerpt(name));
  findings.note("sheet", 0,
                fmt::format("the readings are from worksheet {}; use --sheet NAME for another{}",
                            excerpt(sheet->sheet().name),
                            others.empty() ? "" : ": readings are also in " + joined(others)));
}

}  // namespace triax::lab
