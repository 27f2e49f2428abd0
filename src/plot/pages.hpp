// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sections of rich text with vector figures on numbered A4 pages.
#include <QPainter>
#include <QPdfWriter>
#include <functional>
#include <string>
#include <vector>

#include "src/plot/drawing.hpp"

namespace triax::src {

/// One section of a document. Its figures, each with its caption below it, are where `markup` has
/// <img src="0"/>, <img src="1"/>...
struct PageSection {
  std::string running_head;  ///< at the top of each of its pages
  std::string markup;        ///< rich text as Qt understands it
  std::vector<Drawing> figures;
};

/// Writes sections one after the other; every section begins a page.
class Pages {
 public:
  /// Begins a document on `device`, which must be open and outlive this. Throws lab::WorkFailed.
  Pages(QIODevice& device, const std::string& title);
  void add(const PageSection& section);
  /// A page without head and number, drawn by the function in points.
  void add_page(const std::function<void(QPainter&, QPaintDevice&)>& draw);
  /// Pages written so far.
  int count() const { return count_; }
  /// Ends the document; without it the PDF is not complete. Throws lab::WorkFailed.
  void finish();

 private:
  void turn_page();
  void begin_page(const std::string& running_head);

  QPdfWriter writer_;
  QPainter painter_;
  int count_ = 0;
};

}  // namespace triax::src
