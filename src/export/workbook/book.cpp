// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/book.hpp"

#include <fmt/format.h>
#include <xlsxwriter.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"
#include "src/output/table.hpp"
#include "src/output/written_files.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kLongestCell = 32'000;  // bytes; a cell ends at 32767 characters
constexpr double kSameValue = 1e-13;

std::string text_of_cell(const std::string& text) {
  std::string clean = on_one_line(text);
  if (clean.size() <= kLongestCell) return clean;
  std::size_t end = kLongestCell;
  while (end > 0 && (static_cast<unsigned char>(clean[end]) & 0xC0) == 0x80) --end;
  return clean.substr(0, end) + " ...";
}

/// The library writes 16 digits, which most numbers are known by.
double as_written(double value) {
  return std::strtod(fmt::format("{:.16g}", value).c_str(), nullptr);
}

bool comes_to(double value, double stored) {
  return value == stored || std::fabs(value - stored) <= kSameValue * std::fabs(stored);
}

lxw_row_t row_of(std::size_t row) { return static_cast<lxw_row_t>(row); }
lxw_col_t column_of(std::size_t column) { return static_cast<lxw_col_t>(column); }

std::time_t time_from(const std::string& iso) {
  std::tm at{};
  return strptime(iso.c_str(), "%Y-%m-%dT%H:%M:%S", &at) != nullptr ? timegm(&at) : 0;
}

[[noreturn]] void no_room(const char* what) {
  throw lab::WorkFailed(fmt::format("workbook cannot be written: {}: {}", what,
                                    errno != 0 ? std::strerror(errno) : "unknown"));
}

}  // namespace

void Sheet::text(std::size_t row, std::size_t column, const std::string& text, Look look) {
  if (text.empty()) return;
  worksheet_write_string(sheet_, row_of(row), column_of(column), text_of_cell(text).c_str(),
                         book_->format(look));
}

void Sheet::number(std::size_t row, std::size_t column, double value) {
  if (!std::isfinite(value)) return;
  worksheet_write_number(sheet_, row_of(row), column_of(column), value, nullptr);
}

void Sheet::exact(std::size_t row, std::size_t column, double value) {
  if (!std::isfinite(value) || as_written(value) == value) return number(row, column, value);
  const double begin = std::strtod(fmt::format("{:.15g}", value).c_str(), nullptr);
  const auto exact = fmt::format("=SUM({},{})", constant(begin).text, constant(value - begin).text);
  worksheet_write_formula_num(sheet_, row_of(row), column_of(column), exact.c_str(), nullptr,
                              value);
}

void Sheet::formula(std::size_t row, std::size_t column, const Term& term, double stored) {
  if (!std::isfinite(stored)) return;
  if (term.text.empty() || !comes_to(term.value, stored)) {
    ++book_->without_formula_;
    return exact(row, column, stored);
  }
  worksheet_write_formula_num(sheet_, row_of(row), column_of(column), ('=' + term.text).c_str(),
                              nullptr, stored);
}

void Sheet::widths(std::size_t first, std::size_t last, double characters) {
  worksheet_set_column(sheet_, column_of(first), column_of(last), characters, nullptr);
}

void Sheet::freeze_above(std::size_t row) { worksheet_freeze_panes(sheet_, row_of(row), 0); }

Book::Book(const std::string& title, const std::string& comments, const std::string& stored_at)
    : file_(std::tmpfile(), &std::fclose) {
  if (!file_) no_room("temporary files");
  lxw_workbook_options options{};
  options.constant_memory = LXW_TRUE;
  options.use_zip64 = LXW_TRUE;
  book_ = workbook_new_opt(fmt::format("/proc/self/fd/{}", fileno(file_.get())).c_str(), &options);
  if (book_ == nullptr) no_room("memory");
  std::string name = text_of_cell(title), remark = text_of_cell(comments);
  lxw_doc_properties properties{};
  properties.title = name.data();
  properties.comments = remark.data();
  properties.created = time_from(stored_at);
  workbook_set_properties(book_, &properties);
  for (const Look look : {Look::plain, Look::heading, Look::warning, Look::wrapped}) {
    lxw_format* const format = look == Look::plain ? nullptr : workbook_add_format(book_);
    formats_.push_back(format);
    if (look == Look::heading) format_set_bold(format);
    if (look == Look::wrapped) {
      format_set_text_wrap(format);
      format_set_align(format, LXW_ALIGN_VERTICAL_TOP);
    }
    if (look != Look::warning) continue;
    format_set_bold(format);
    format_set_font_color(format, LXW_COLOR_RED);
  }
}

Book::~Book() {
  if (book_ != nullptr) lxw_workbook_free(book_);
}

Sheet& Book::add_sheet(const std::string& name) {
  auto& sheet = *sheets_.emplace_back(std::make_unique<Sheet>());
  sheet.book_ = this;
  sheet.name_ = name;
  sheet.sheet_ = workbook_add_worksheet(book_, name.c_str());
  if (sheet.sheet_ == nullptr) no_room("temporary files");
  return sheet;
}

void Book::finish(const std::string& path) {
  const WrittenFile noted(path);
  lab::WholeFile whole(path);
  for (const auto& sheet : sheets_) {
    std::FILE* const rows = sheet->sheet_->optimize_tmpfile;
    if (rows != nullptr && (std::fflush(rows) != 0 || std::ferror(rows) != 0))
      no_room("temporary files");
  }
  if (const auto error = workbook_close(std::exchange(book_, nullptr)); error != LXW_NO_ERROR)
    throw lab::WorkFailed(std::string("workbook cannot be written: ") + lxw_strerror(error));
  std::rewind(file_.get());
  std::string block(std::size_t{1} << 16, '\0');
  while (const auto count = std::fread(block.data(), 1, block.size(), file_.get()))
    whole.write(std::string_view(block).substr(0, count));
  if (std::ferror(file_.get()) != 0) no_room("temporary files");
  whole.finish();
  noted.is_there();
}

}  // namespace triax::src
