// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The header fields that every answer has, whatever it is.
#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>

#include "src/page/request/request.hpp"

namespace triax::src {

/// Nothing of elsewhere is loaded by our page, nothing of ours is shown within others, types are
/// not guessed, nothing is kept. What the answer says itself stands instead.
template <class Body>
void guard_headers(boost::beast::http::response<Body>& response, const PageAnswer& answer) {
  response.set("Content-Type", answer.type);
  response.set("Content-Security-Policy",
               "default-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'self'; "
               "object-src 'none'; frame-ancestors 'none'");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Cache-Control", "no-store");
  for (const auto& [name, value] : answer.fields) response.set(name, value);
}

}  // namespace triax::src
