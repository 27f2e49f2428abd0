// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/xml_stream.hpp"

#include <expat.h>

#include <exception>
#include <utility>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

constexpr int kXmlBlock = 1 << 16;
constexpr long long kLongestPiece = 8LL << 20;

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

/// expat is C: nothing may be thrown through it, so that what a listener throws waits here.
struct XmlStream::Impl {
  Impl(std::string file, ZipPart zipped, XmlListener listening)
      : name(std::move(file)), part(std::move(zipped)), listener(std::move(listening)) {}
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
      if (++me.depth > kDeepest)
        throw BadInput(me.name, 0, "its XML nests deeper than any workbook's");
      if (me.listener.start) me.listener.start(local_name(element), XmlAttributes(pairs));
    });
  }
  static void on_end(void* self, const char* element) {
    Impl& me = of(self);
    me.guarded([&] {
      --me.depth;
      if (me.listener.end) me.listener.end(local_name(element));
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
      throw BadInput(me.name, 0, "its XML declares a document type, which no workbook does");
    });
  }

  std::string name;
  ZipPart part;
  XmlListener listener;
  XML_Parser parser = nullptr;
  std::exception_ptr thrown;
  int depth = 0;
  long long fed = 0;
  bool over = false;
};

XmlStream::XmlStream(std::string name, ZipPart part, XmlListener listener)
    : impl_(std::make_unique<Impl>(std::move(name), std::move(part), std::move(listener))) {
  impl_->parser = XML_ParserCreate(nullptr);
  if (impl_->parser == nullptr) throw WorkFailed("no memory for reading XML");
  XML_SetUserData(impl_->parser, impl_.get());
  XML_SetElementHandler(impl_->parser, Impl::on_start, Impl::on_end);
  XML_SetCharacterDataHandler(impl_->parser, Impl::on_text);
  XML_SetStartDoctypeDeclHandler(impl_->parser, Impl::on_doctype);
}

XmlStream::~XmlStream() = default;

bool XmlStream::advance() {
  Impl& me = *impl_;
  if (me.over || stopped_) return false;
  void* const buffer = XML_GetBuffer(me.parser, kXmlBlock);
  if (buffer == nullptr) throw WorkFailed(me.name + ": no memory for reading XML");
  const auto count =
      me.part.read({static_cast<char*>(buffer), static_cast<std::size_t>(kXmlBlock)});
  me.over = count == 0;
  me.fed += static_cast<long long>(count);
  const auto status = XML_ParseBuffer(me.parser, static_cast<int>(count), me.over ? 1 : 0);
  if (me.thrown) std::rethrow_exception(me.thrown);
  if (status != XML_STATUS_OK)
    throw BadInput(me.name, 0,
                   std::string("its XML is broken (") +
                       XML_ErrorString(XML_GetErrorCode(me.parser)) +
                       "); open it in a spreadsheet and save it again");
  const auto at = static_cast<long long>(XML_GetCurrentByteIndex(me.parser));
  if (at >= 0 && me.fed - at > kLongestPiece)
    throw BadInput(me.name, 0, "its XML has a single piece of more than 8 MB: no workbook's cell");
  return !me.over;
}

}  // namespace triax::lab
