#include "lab/records/table_layout.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lab/records/bad_input.hpp"
#include "lab/records/channels.hpp"
#include "lab/records/line_reader.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/text.hpp"

namespace triax::lab {
namespace {

using Cells = std::vector<std::string_view>;
constexpr Separator kCandidates[] = {Separator::tab, Separator::semicolon, Separator::comma,
                                     Separator::blanks};

struct Head {
  std::vector<std::string> lines;  // UTF-8
  bool whole_file = false;
};

Head read_head(ByteSource& source, Findings& findings) {
  constexpr std::size_t kMostBytes = std::size_t{4} << 20;
  Head head;
  LineReader reader(source);
  std::string_view line;
  std::size_t bytes = 0;
  bool utf8 = true;
  bool text = false;
  while (head.lines.size() < kLongestHead && bytes < kMostBytes) {
    if (!reader.next(line)) {
      head.whole_file = true;
      break;
    }
    head.lines.emplace_back(line);
    bytes += line.size();
    utf8 = utf8 && is_utf8(line);
    text = text || !trimmed(line).empty();
  }
  if (!text && head.whole_file)
    throw BadInput(source.name(), 0, "the file is empty; a record has a line of headings and rows");
  if (!utf8) {
    const auto first =
        std::ranges::find_if(head.lines, [](const auto& one) { return !is_utf8(one); });
    findings.note("encoding", first - head.lines.begin() + 1,
                  "no UTF-8: the text is read as Windows-1252");
    for (auto& one : head.lines) one = utf8_from_cp1252(one);
  }
  return head;
}

// How a heading fits a dialect: the column, which synonym, and the unit its text holds.
struct Fit {
  std::size_t synonym = 0;
  std::optional<std::string> unit;
};

std::optional<Fit> fit(const DialectColumn& column, std::string_view heading) {
  if (std::ranges::none_of(column.names,
                           [&](const auto& name) { return may_match(heading, name); }))
    return std::nullopt;
  const auto parts = split_heading(heading);
  const auto tail = split_unit(heading);
  for (std::size_t i = 0; i < column.names.size(); ++i) {
    const auto& name = column.names[i];
    if (matches_name(heading, name) || matches_name(parts.name, name)) return Fit{i, parts.unit};
    if (tail && matches_name(tail->name, name)) return Fit{i, std::string(tail->unit.name)};
  }
  return std::nullopt;
}

// A heading in triax's own form: "cell_pressure_kPa", "axial_strain", "axial_strain_pct".
std::optional<std::pair<Quantity, std::string>> own_heading(std::string_view heading) {
  const bool word = !heading.empty() && static_cast<unsigned char>(heading.front()) > '9';
  if (!word) return std::nullopt;
  const auto name = folded(heading);
  if (const auto quantity = find_quantity(name)) return std::pair(*quantity, std::string());
  for (auto at = name.rfind('_'); at != std::string::npos && at > 0; at = name.rfind('_', at - 1))
    if (const auto quantity = find_quantity(name.substr(0, at)))
      return std::pair(*quantity, std::string(trimmed(heading).substr(at + 1)));
  return std::nullopt;
}

// One heading line read with one separator.
struct Candidate {
  const Dialect* dialect = nullptr;
  std::size_t line = 0;
  Separator separator = Separator::comma;
  std::size_t known = 0;  // headings that this dialect understands
};

std::size_t count_known(const Dialect& dialect, const Cells& cells) {
  std::size_t known = 0;
  for (const auto cell : cells) {
    if (cell.empty()) continue;
    const bool named = std::ranges::any_of(
        dialect.columns, [&](const auto& column) { return fit(column, cell).has_value(); });
    if (named || (dialect.own_headings && own_heading(cell))) ++known;
  }
  return known;
}

bool has_headings(const Dialect& dialect, const Cells& cells) {
  return std::ranges::all_of(dialect.headings, [&](const std::string& name) {
    return std::ranges::any_of(cells, [&](std::string_view cell) {
      return may_match(cell, name) &&
             (matches_name(cell, name) || matches_name(split_heading(cell).name, name));
    });
  });
}

bool is_comment(const Dialect& dialect, std::string_view line) {
  return !dialect.comment.empty() && line.starts_with(dialect.comment);
}

bool holds_texts(const Dialect& dialect, const Head& head, std::size_t line) {
  return std::ranges::all_of(dialect.contains, [&](const std::string& text) {
    return std::any_of(head.lines.begin(),
                       head.lines.begin() + static_cast<std::ptrdiff_t>(line) + 1,
                       [&](const auto& one) { return one.find(text) != std::string::npos; });
  });
}

std::optional<Candidate> find_heading_line(const Dialect& dialect, const Head& head) {
  constexpr std::size_t kFewestKnown = 2;
  std::vector<Separator> separators(std::begin(kCandidates), std::end(kCandidates));
  if (dialect.separator != Separator::automatic) separators = {dialect.separator};
  if (dialect.heading_separator != Separator::automatic) separators = {dialect.heading_separator};
  std::optional<Candidate> best;
  Cells cells;
  for (std::size_t line = 0; line < head.lines.size(); ++line) {
    if (is_comment(dialect, head.lines[line])) continue;
    for (const Separator separator : separators) {
      split_cells(head.lines[line], separator, cells);
      if (!has_headings(dialect, cells) || !holds_texts(dialect, head, line)) continue;
      const auto known = count_known(dialect, cells);
      if (known < kFewestKnown || (best && known <= best->known)) continue;
      best = Candidate{&dialect, line, separator, known};
    }
    if (best && !dialect.headings.empty()) break;
  }
  return best;
}

[[noreturn]] void nothing_fits(const ByteSource& source, const Head& head,
                               const std::optional<Dialect>& forced) {
  // The line with the most cells that are words is the likeliest line of headings.
  Cells cells;
  Cells best;
  std::size_t best_line = 0;
  for (std::size_t line = 0; line < head.lines.size(); ++line)
    for (const Separator separator : kCandidates) {
      split_cells(head.lines[line], separator, cells);
      std::erase_if(cells, [](std::string_view cell) {
        DecimalMark mark = DecimalMark::open;
        double value = 0;
        return parse_cell(cell, mark, value) != CellKind::text;
      });
      if (separator == Separator::blanks && !best.empty()) continue;
      if (cells.size() <= best.size()) continue;
      best = cells;
      best_line = line;
    }
  constexpr std::size_t kMostShown = 12;
  std::vector<std::string> shown;
  for (const auto cell : best)
    if (shown.size() < kMostShown) shown.push_back(excerpt(cell));
  if (best.size() > kMostShown) shown.push_back(fmt::format("... {} in all", best.size()));
  if (best.size() == 1)
    throw BadInput(source.name(), static_cast<std::int64_t>(best_line) + 1,
                   "only one column found (" + shown.front() +
                       "); columns are separated by comma, semicolon, tab or blanks");
  const auto who = forced ? "the dialect '" + forced->name + "' does not fit this file"
                          : std::string("no dialect fits this file");
  throw BadInput(
      source.name(), best.empty() ? 0 : static_cast<std::int64_t>(best_line) + 1,
      fmt::format("{}; headings found: {}. Describe it in a few lines of TOML and give "
                  "that with --dialect FILE.toml: name = \"...\", [columns] axial_strain "
                  "= {{ names = \"its heading\", unit = \"%\" }}, ... (docs/formats.md)",
                  who, shown.empty() ? "none" : joined(shown)));
}

// The unit that a units row states for a cell: its first bracket, or the whole of it.
std::optional<std::string> unit_in_cell(std::string_view cell) {
  const auto open = cell.find_first_of("([");
  if (open == std::string_view::npos) {
    if (cell.empty()) return std::nullopt;
    return std::string(cell);
  }
  const auto close = cell.find_first_of(")]", open);
  if (close == std::string_view::npos) return std::nullopt;
  return std::string(trimmed(cell.substr(open + 1, close - open - 1)));
}

// The units of the line, if it is a units row: no numbers, at least one unit.
std::vector<std::optional<std::string>> units_row(std::string_view line, Separator separator) {
  Cells cells;
  split_cells(line, separator, cells);
  std::vector<std::optional<std::string>> units;
  bool any = false;
  for (const auto cell : cells) {
    DecimalMark mark = DecimalMark::open;
    double value = 0;
    if (parse_cell(cell, mark, value) == CellKind::number) return {};
    units.push_back(unit_in_cell(cell));
    any = any || (units.back() && !units.back()->empty() && sim::find_unit(*units.back()));
  }
  return any ? units : std::vector<std::optional<std::string>>{};
}

class Planner {
 public:
  Planner(TableLayout& layout, std::string_view heading_line, Findings& findings)
      : layout_(layout), findings_(findings) {
    split_cells(heading_line, layout.heading_separator, cells_);
    while (!cells_.empty() && cells_.back().empty()) cells_.pop_back();
    layout.cell_count = cells_.size();
    taken_.assign(cells_.size(), false);
  }

  void plan(const std::vector<std::optional<std::string>>& units) {
    units_ = units;
    for (const DialectColumn& column : layout_.dialect.columns) plan_named(column);
    if (layout_.dialect.own_headings) plan_own();
    std::ranges::sort(layout_.columns, {}, &PlannedColumn::cell);
  }
  /// What is to be said about headings in which nothing was recognised.
  const std::vector<std::string>& unknown() const { return unknown_; }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw BadInput(layout_.file, layout_.heading_line, message);
  }

  void plan_named(const DialectColumn& column) {
    std::optional<Fit> chosen;
    std::size_t cell = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (taken_[i] || cells_[i].empty()) continue;
      const auto found = fit(column, cells_[i]);
      if (!found) continue;
      if (chosen && chosen->synonym == found->synonym) two_columns(cell, i);
      if (chosen && chosen->synonym < found->synonym) continue;
      chosen = found;
      cell = i;
    }
    if (chosen) add(cell, column, chosen->unit);
  }

  void plan_own() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (taken_[i] || cells_[i].empty()) continue;
      const auto own = own_heading(cells_[i]);
      if (!own) {
        leave_out(cells_[i]);
        continue;
      }
      for (const PlannedColumn& other : layout_.columns)
        if (other.role == ColumnRole::quantity && other.quantity == own->first)
          two_columns(other.cell, i);
      DialectColumn column;
      column.quantity = own->first;
      add(i, column, own->second.empty() ? std::nullopt : std::optional(own->second));
    }
  }

  void leave_out(std::string_view heading) {
    for (const PlannedColumn& other : layout_.columns)
      if (folded(other.heading) == folded(heading)) two_columns(other.cell, other.cell);
    std::vector<std::string> known{"time_s", "stage"};
    for (const QuantityInfo& row : quantities()) known.push_back(lab::heading(row.quantity));
    unknown_.push_back(fmt::format("column {} is not known and left out; did you mean '{}'?",
                                   excerpt(heading), nearest(heading, known)));
    findings_.note("unknown column " + std::string(heading), layout_.heading_line, unknown_.back());
  }

  [[noreturn]] void two_columns(std::size_t a, std::size_t b) const {
    fail(fmt::format("two columns hold the same: {} (column {}) and {} (column {}); keep one",
                     excerpt(cells_[a]), a + 1, excerpt(cells_[b]), b + 1));
  }

  void add(std::size_t cell, const DialectColumn& column,
           const std::optional<std::string>& heading_unit) {
    PlannedColumn planned;
    planned.cell = cell;
    planned.role = column.role;
    planned.quantity = column.quantity;
    planned.heading = cells_[cell];
    planned.scale = column.sign * scale(cell, column, heading_unit);
    taken_[cell] = true;
    layout_.columns.push_back(std::move(planned));
  }

  double scale(std::size_t cell, const DialectColumn& column,
               const std::optional<std::string>& heading_unit) const {
    if (column.role == ColumnRole::stage) return 1;
    const std::string wanted =
        column.role == ColumnRole::quantity ? std::string(info(column.quantity).unit) : "s";
    std::optional<std::string> text;
    if (!column.true_unit.empty())
      text = column.true_unit;
    else if (heading_unit)
      text = heading_unit;
    else if (cell < units_.size() && units_[cell])
      text = units_[cell];
    else if (!column.unit.empty())
      text = column.unit;
    const auto name = std::string(cells_[cell]);
    if (!text) {
      if (wanted.empty()) return 1;
      fail(fmt::format("column {} has no unit; write {}_{} or another unit of that kind",
                       excerpt(name), name, wanted));
    }
    const auto unit = sim::find_unit(*text);
    if (!unit)
      fail(fmt::format("column {} is in {}, which is no known unit; {} would be right",
                       excerpt(name), excerpt(*text), wanted.empty() ? "%" : wanted));
    if (unit->dimension != sim::find_unit(wanted)->dimension)
      fail(fmt::format("column {} is in {}; {} would be right", excerpt(name), excerpt(*text),
                       wanted.empty() ? "a plain number or %" : wanted));
    return unit->scale;
  }

  TableLayout& layout_;
  Findings& findings_;
  Cells cells_;
  std::vector<bool> taken_;
  std::vector<std::optional<std::string>> units_;
  std::vector<std::string> unknown_;
};

// Where headings are set apart in another way than rows, the first row tells how.
Separator row_separator(const TableLayout& layout, std::string_view row) {
  if (layout.dialect.separator != Separator::automatic) return layout.dialect.separator;
  if (layout.dialect.heading_separator == Separator::automatic) return layout.heading_separator;
  Cells cells;
  for (const Separator separator : kCandidates) {
    split_cells(row, separator, cells);
    if (cells.size() == layout.cell_count) return separator;
  }
  return Separator::blanks;
}

}  // namespace

HeadingParts split_heading(std::string_view heading) {
  heading = trimmed(heading);
  const char close = heading.empty() ? ' ' : heading.back();
  if (close == ')' || close == ']') {
    const auto open = heading.rfind(close == ')' ? '(' : '[');
    if (open != std::string_view::npos && open > 0)
      return {std::string(trimmed(heading.substr(0, open))),
              std::string(trimmed(heading.substr(open + 1, heading.size() - open - 2)))};
  }
  return {std::string(heading), std::nullopt};
}

bool TableLayout::has(ColumnRole role) const {
  return std::ranges::find(columns, role, &PlannedColumn::role) != columns.end();
}

std::vector<Quantity> TableLayout::quantities() const {
  std::vector<Quantity> out;
  for (const PlannedColumn& column : columns)
    if (column.role == ColumnRole::quantity) out.push_back(column.quantity);
  return out;
}

TableLayout recognise_table(ByteSource& source, const std::optional<Dialect>& forced,
                            Findings& findings) {
  const Head head = read_head(source, findings);
  std::optional<Candidate> best;
  if (forced) {
    best = find_heading_line(*forced, head);
  } else {
    for (const Dialect& dialect : shipped_dialects()) {
      const auto found = find_heading_line(dialect, head);
      if (found && (!best || found->known > best->known)) best = found;
    }
  }
  if (!best) nothing_fits(source, head, forced);

  TableLayout layout;
  layout.dialect = *best->dialect;
  layout.file = source.name();
  layout.heading_line = static_cast<std::int64_t>(best->line) + 1;
  layout.heading_separator = best->separator;
  const auto& lines = head.lines;
  layout.head.assign(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(best->line));

  auto row = best->line + 1;
  const auto skip = [&] {
    while (row < lines.size() &&
           (trimmed(lines[row]).empty() || is_comment(layout.dialect, lines[row])))
      ++row;
  };
  layout.first_row_line = static_cast<std::int64_t>(row) + 1;
  skip();
  std::vector<std::optional<std::string>> units;
  if (row < lines.size()) units = units_row(lines[row], layout.heading_separator);
  if (!units.empty()) {
    layout.first_row_line = static_cast<std::int64_t>(++row) + 1;
    skip();
  }
  if (row >= lines.size() && head.whole_file)
    throw BadInput(layout.file, layout.heading_line,
                   "headings but no row of readings below them; nothing was recorded");
  Planner planner(layout, lines[best->line], findings);
  planner.plan(units);
  layout.separator = row_separator(layout, row < lines.size() ? lines[row] : std::string());
  if (const auto missing = missing_channels(layout.quantities()); !missing.empty())
    throw BadInput(layout.file, layout.heading_line,
                   joined({missing, joined(planner.unknown(), "; ")}, "; "));
  return layout;
}

}  // namespace triax::lab
