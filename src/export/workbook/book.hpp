// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A workbook as it is written (libxlsxwriter), in constant memory: the rows of a sheet come in
// order, cells of a row too; sheets may take turns.
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "src/export/workbook/term.hpp"

struct lxw_workbook;
struct lxw_worksheet;
struct lxw_format;

namespace triax::src {

/// Rows that a sheet of a spreadsheet has, and no more.
inline constexpr std::size_t kRowsOfSheet = 1'048'576;

enum class Look { plain, heading, warning, wrapped };

class Book;

/// Rows and columns count from 0.
class Sheet {
 public:
  /// Text stays text, whatever it begins with; without control characters, and cut where no cell
  /// holds more.
  void text(std::size_t row, std::size_t column, const std::string& text, Look look = Look::plain);
  /// Sixteen digits; nothing where it is not known.
  void number(std::size_t row, std::size_t column, double value);
  /// What formulas rest on: to the last bit, as a sum where sixteen digits are not enough.
  void exact(std::size_t row, std::size_t column, double value);
  /// The formula with `stored` as the value of the last save, where it comes to that (a part in
  /// 10¹³ aside); the number alone where it does not, which is counted (Book::without_formula).
  void formula(std::size_t row, std::size_t column, const Term& term, double stored);
  /// The formula with its own value.
  void formula(std::size_t row, std::size_t column, const Term& term) {
    formula(row, column, term, term.value);
  }
  void widths(std::size_t first, std::size_t last, double characters);
  /// What stands above `row` stays in sight.
  void freeze_above(std::size_t row);

  lxw_worksheet* get() const { return sheet_; }
  const std::string& name() const { return name_; }

 private:
  friend class Book;
  Book* book_ = nullptr;
  lxw_worksheet* sheet_ = nullptr;
  std::string name_;
};

class Book {
 public:
  /// Throws lab::WorkFailed where there is no room for what is written meanwhile.
  Book(const std::string& title, const std::string& comments, const std::string& stored_at);
  ~Book();
  Book(const Book&) = delete;
  Book& operator=(const Book&) = delete;

  Sheet& add_sheet(const std::string& name);
  /// Whole or not at all, as lab::WholeFile. Throws lab::WorkFailed, lab::BadInput.
  void finish(const std::string& path);
  std::size_t without_formula() const { return without_formula_; }
  lxw_workbook* get() const { return book_; }

 private:
  friend class Sheet;
  lxw_format* format(Look look) const { return formats_[static_cast<std::size_t>(look)]; }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  lxw_workbook* book_ = nullptr;
  std::vector<lxw_format*> formats_;
  std::vector<std::unique_ptr<Sheet>> sheets_;
  std::size_t without_formula_ = 0;
};

}  // namespace triax::src
