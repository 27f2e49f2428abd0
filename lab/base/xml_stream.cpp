// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/xml_stream.hpp"

#include <expat.h>

#include <exception>
#include <utility>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kXmlBlock = std::size_t{1} << 16;
constexpr long long kMaxPiece_bytes = 8LL << 20;
constexpr std::string_view kEndOfRow = "</row>";
/// A longer row is parsed in pieces.
constexpr std::size_t kMaxHeldRow_bytes = std::size_t{1} << 20;

/// Returns the index of the byte that the parser is at, or -1. Expat 2.9 deprecates the older
/// functions.
long long byte_index(XML_Parser parser) {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
  return XML_GetCurrentByteIndex64(parser);
#else
  return XML_GetCurrentByteIndex(parser);
#endif
}

/// Returns the number of bytes of the event that the parser is at, or 0.
long long byte_count(XML_Parser parser) {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
  return XML_GetCurrentByteCount64(parser);
#else
  return XML_GetCurrentByteCount(parser);
#endif
}

}  // namespace

std::string_view local_name(const char* name) {
  const std::string_view whole = name;
  const auto colon = whole.rfind(':');
  return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

std::string_view XmlAttributes::operator[](std::string_view name) const {
  for (const char** pair = pairs_; *pair != nullptr; pair += 2)
    if (local_name(pair[0]) == name) return pair[1];
  return {};
}

/// Expat is written in C: an exception of the listener is kept until expat has returned.
struct XmlStream::Impl {
  Impl(XmlInput from, XmlListener listening)
      : input(std::move(from)), listener(std::move(listening)) {}
  ~Impl() { XML_ParserFree(parser); }

  template <class Work>
  void guarded(const Work& work) {
    if (thrown) return;
    try {
      work();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
  static Impl& of(void* self) { return *static_cast<Impl*>(self); }
  static void on_start(void* self, const char* element, const char** pairs) {
    Impl& me = of(self);
    me.guarded([&] {
      if (++me.depth > kMaxDepth) me.fail("its XML is nested too deep for a " + me.input.kind);
      if (me.listener.start) me.listener.start(local_name(element), XmlAttributes(pairs));
    });
  }
  static void on_end(void* self, const char* element) {
    Impl& me = of(self);
    me.guarded([&] {
      --me.depth;
      const auto local = local_name(element);
      if (me.listener.rows && local == "row")
        me.row_ended_at = byte_index(me.parser) + byte_count(me.parser);
      if (me.listener.end) me.listener.end(local);
    });
  }
  static void on_text(void* self, const char* text, int length) {
    Impl& me = of(self);
    me.guarded([&] {
      if (me.listener.text) me.listener.text({text, static_cast<std::size_t>(length)});
    });
  }
  static void on_doctype(void* self, const char*, const char*, const char*, int) {
    Impl& me = of(self);
    me.guarded([&] {
      me.fail("its XML declares a document type, which is not allowed in a " + me.input.kind);
    });
  }

  void feed(std::string_view bytes, bool last);
  /// Removes the bytes that the listener or the parser has taken. A row without its end is left
  /// until more bytes are read.
  void take_rows(std::string_view& bytes);
  bool behind_row() const { return row_ended_at == fed; }
  std::int64_t line() const {
    return input.has_lines ? static_cast<std::int64_t>(XML_GetCurrentLineNumber(parser)) : 0;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw BadInput(input.name, line(), what);
  }

  XmlInput input;
  XmlListener listener;
  XML_Parser parser = nullptr;
  std::string held;             ///< a row whose end was not read yet
  long long row_ended_at = -1;  ///< of the bytes that were fed
  std::exception_ptr thrown;
  int depth = 0;
  long long fed = 0;
  bool over = false;
};

XmlStream::XmlStream(XmlInput input, XmlListener listener)
    : impl_(std::make_unique<Impl>(std::move(input), std::move(listener))) {
  impl_->parser = XML_ParserCreate(nullptr);
  if (impl_->parser == nullptr) throw WorkFailed("no memory for reading XML");
  XML_SetUserData(impl_->parser, impl_.get());
  XML_SetElementHandler(impl_->parser, Impl::on_start, Impl::on_end);
  XML_SetCharacterDataHandler(impl_->parser, Impl::on_text);
  XML_SetStartDoctypeDeclHandler(impl_->parser, Impl::on_doctype);
}

XmlStream::~XmlStream() = default;

std::int64_t XmlStream::line() const { return impl_->line(); }

void XmlStream::Impl::feed(std::string_view bytes, bool last) {
  fed += static_cast<long long>(bytes.size());
  const auto status = XML_Parse(parser, bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0);
  if (thrown) std::rethrow_exception(thrown);
  if (status != XML_STATUS_OK)
    fail(std::string("its XML is broken (") + XML_ErrorString(XML_GetErrorCode(parser)) + "); " +
         input.remedy);
  const auto at = byte_index(parser);
  if (at >= 0 && fed - at > kMaxPiece_bytes)
    fail("its XML has a text of more than 8 MB, too large for a " + input.kind);
}

void XmlStream::Impl::take_rows(std::string_view& bytes) {
  while (!bytes.empty()) {
    if (behind_row()) bytes.remove_prefix(listener.rows(bytes));
    const auto end = bytes.find(kEndOfRow);
    if (end == std::string_view::npos) {
      if (behind_row() && bytes.starts_with('<') && bytes.size() < kMaxHeldRow_bytes) return;
      return feed(std::exchange(bytes, {}), false);
    }
    feed(bytes.substr(0, end + kEndOfRow.size()), false);
    bytes.remove_prefix(end + kEndOfRow.size());
  }
}

bool XmlStream::advance() {
  Impl& me = *impl_;
  if (me.over || stopped_) return false;
  const std::size_t kept = me.held.size();
  me.held.resize(kept + kXmlBlock);
  const auto count = me.input.read({me.held.data() + kept, kXmlBlock});
  me.held.resize(kept + count);
  me.over = count == 0;
  std::string_view bytes = me.held;
  if (me.over || !me.listener.rows)
    me.feed(std::exchange(bytes, {}), me.over);
  else
    me.take_rows(bytes);
  me.held.erase(0, me.held.size() - bytes.size());
  return !me.over;
}

}  // namespace triax::lab
