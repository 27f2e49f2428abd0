// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/xml_writer.hpp"

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kFlushXmlAt = std::size_t{1} << 16;

/// U+FFFE and U+FFFF are UTF-8 that is no character of XML.
bool is_no_character(std::string_view rest) {
  return rest.starts_with("\xEF\xBF\xBE") || rest.starts_with("\xEF\xBF\xBF");
}

}  // namespace

XmlWriter::XmlWriter(std::function<void(std::string_view)> write) : write_(std::move(write)) {
  text_ = R"(<?xml version="1.0" encoding="UTF-8"?>)";
  text_ += '\n';
}

void XmlWriter::indent() { text_.append(2 * open_.size(), ' '); }

void XmlWriter::append_escaped(std::string_view text) {
  std::string recoded;
  if (!is_utf8(text)) text = recoded = utf8_from_cp1252(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_no_character(text.substr(i))) {
      text_ += '?';
      i += 2;
    } else if (c == '&') {
      text_ += "&amp;";
    } else if (c == '<') {
      text_ += "&lt;";
    } else if (c == '>') {
      text_ += "&gt;";
    } else if (c == '"') {
      text_ += "&quot;";
    } else if (c == '\t') {
      text_ += "&#9;";
    } else if (c == '\n') {
      text_ += "&#10;";
    } else if (c == '\r') {
      text_ += "&#13;";
    } else {
      text_ += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
}

void XmlWriter::begin(std::string_view name, Attributes attributes) {
  indent();
  text_.append("<").append(name);
  for (const auto& [attribute, value] : attributes) {
    text_.append(" ").append(attribute).append("=\"");
    append_escaped(value);
    text_ += '"';
  }
}

void XmlWriter::open(std::string_view name, Attributes attributes) {
  begin(name, attributes);
  text_ += ">\n";
  open_.emplace_back(name);
}

void XmlWriter::close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  indent();
  text_.append("</").append(name).append(">\n");
  flush(kFlushXmlAt);
}

void XmlWriter::leaf(std::string_view name, std::string_view text, Attributes attributes) {
  begin(name, attributes);
  text_ += '>';
  append_escaped(text);
  text_.append("</").append(name).append(">\n");
}

void XmlWriter::empty(std::string_view name, Attributes attributes) {
  begin(name, attributes);
  text_ += "/>\n";
}

void XmlWriter::plain(std::string_view text) {
  text_ += text;
  flush(kFlushXmlAt);
}

void XmlWriter::finish() {
  while (!open_.empty()) close();
  flush(0);
}

void XmlWriter::flush(std::size_t keep) {
  if (text_.size() <= keep) return;
  write_(text_);
  text_.clear();
}

}  // namespace triax::lab
