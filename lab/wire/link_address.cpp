// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/link_address.hpp"

#include <fmt/format.h>

#include <array>

#include "lab/base/bad_input.hpp"
#include "lab/base/names.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

using Kind = LinkAddress::Kind;
using Parity = LinkAddress::Parity;

constexpr std::array<std::pair<Kind, std::string_view>, 4> kSchemes{
    {{Kind::tcp, "tcp"},
     {Kind::serial, "serial"},
     {Kind::modbus_tcp, "modbus-tcp"},
     {Kind::modbus_rtu, "modbus-rtu"}}};
constexpr std::array<std::pair<Parity, std::string_view>, 3> kParities{
    {{Parity::none, "none"}, {Parity::even, "even"}, {Parity::odd, "odd"}}};

class LinkParser {
 public:
  explicit LinkParser(std::string_view text) : text_(text) {}

  LinkAddress link() {
    const std::size_t colon = text_.find("://");
    const auto kind = value_of<Kind>(text_.substr(0, colon), kSchemes);
    if (colon == std::string_view::npos || !kind)
      fail("unknown protocol; must be one of: tcp://, serial://, modbus-tcp://, modbus-rtu://");
    link_.kind = *kind;
    std::string_view rest = text_.substr(colon + 3);
    for (const char c : rest)
      if (static_cast<unsigned char>(c) <= ' ' || c == 127) fail("a link must not contain spaces");
    link_.is_serial() ? serial(rest) : host_and_port(rest);
    return link_;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw BadInput(excerpt(text_) + ": " + message);
  }

  int number(std::string_view what, std::string_view text, int lowest, int highest) const {
    const auto value = whole_text_as<int>(text);
    if (!value || *value < lowest || *value > highest)
      fail(fmt::format("{} is {}; must be an integer from {} to {}", what, excerpt(text), lowest,
                       highest));
    return *value;
  }

  void host_and_port(std::string_view rest) {
    const bool modbus = link_.is_modbus();
    const char* form = modbus ? "modbus-tcp://HOST:PORT/UNIT" : "tcp://HOST:PORT";
    if (const std::size_t slash = rest.find('/'); slash != std::string_view::npos) {
      if (!modbus) fail(fmt::format("unexpected text after the port; expected {}", form));
      link_.unit = number("unit", rest.substr(slash + 1), 0, 255);
      rest = rest.substr(0, slash);
    } else if (modbus) {
      fail(fmt::format("the unit is missing; expected {}", form));
    }
    const std::size_t colon = rest.rfind(':');
    if (colon == std::string_view::npos || (rest.front() == '[' && rest[colon - 1] != ']'))
      fail(fmt::format("the port is missing; expected {}", form));
    std::string_view host = rest.substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']'))
      host = host.substr(1, host.size() - 2);
    else if (host.find(':') != std::string_view::npos)
      fail("write an IPv6 address in brackets: [::1]");
    if (host.empty()) fail(fmt::format("the host is missing; expected {}", form));
    link_.host = host;
    link_.port = number("port", rest.substr(colon + 1), 0, 65535);
  }

  void serial(std::string_view rest) {
    const std::size_t mark = rest.find('?');
    link_.path = rest.substr(0, mark);
    if (!link_.path.starts_with('/'))
      fail("the path of the port must begin with '/', as in serial:///dev/ttyUSB0");
    bool unit = false;
    while (mark != std::string_view::npos && !(rest.empty())) {
      const std::size_t begin = rest.find_first_of("?&");
      if (begin == std::string_view::npos) break;
      rest = rest.substr(begin + 1);
      const std::string_view setting = rest.substr(0, rest.find('&'));
      const std::size_t equals = setting.find('=');
      const std::string_view key = setting.substr(0, equals);
      set(key, equals == std::string_view::npos ? "" : setting.substr(equals + 1));
      unit = unit || key == "unit";
    }
    if (link_.is_modbus() && !unit) fail("the unit is missing, as in ?baud=9600&unit=3");
  }

  void set(std::string_view key, std::string_view value) {
    std::vector<std::string> known{"baud", "parity", "bits", "stop"};
    if (link_.is_modbus()) known.emplace_back("unit");
    if (key == "baud") {
      link_.baud = number(key, value, 50, 4'000'000);
    } else if (key == "bits") {
      link_.bits = number(key, value, 7, 8);
    } else if (key == "stop") {
      link_.stop = number(key, value, 1, 2);
    } else if (key == "unit" && link_.is_modbus()) {
      link_.unit = number(key, value, 1, 247);
    } else if (key == "parity") {
      const auto parity = value_of<Parity>(value, kParities);
      if (!parity) fail("parity: " + invalid_value(value, {"none", "even", "odd"}));
      link_.parity = *parity;
    } else {
      fail(fmt::format("unknown key {}; {}", excerpt(key), suggestion(key, known)));
    }
  }

  std::string_view text_;
  LinkAddress link_;
};

}  // namespace

bool LinkAddress::is_local() const {
  return is_serial() || host == "localhost" || host == "::1" || host.starts_with("127.");
}

LinkAddress parse_link(std::string_view text) { return LinkParser(text).link(); }

std::string to_text(const LinkAddress& link) {
  std::string text = fmt::format("{}://", name_of<Kind>(link.kind, kSchemes));
  if (!link.is_serial()) {
    const bool six = link.host.find(':') != std::string::npos;
    text += fmt::format(fmt::runtime(six ? "[{}]:{}" : "{}:{}"), link.host, link.port);
    if (link.is_modbus()) text += fmt::format("/{}", link.unit);
    return text;
  }
  text += fmt::format("{}?baud={}", link.path, link.baud);
  if (link.parity != Parity::none)
    text += fmt::format("&parity={}", name_of<Parity>(link.parity, kParities));
  if (link.bits != 8) text += fmt::format("&bits={}", link.bits);
  if (link.stop != 1) text += fmt::format("&stop={}", link.stop);
  if (link.is_modbus()) text += fmt::format("&unit={}", link.unit);
  return text;
}

}  // namespace triax::lab
