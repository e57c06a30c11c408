// SPDX-License-Identifier: GPL-3.0-or-later
// What strangers can send to the studio's server before anything is known of them: messages, secrets, names
// of files.
#ifndef FUZZ_REQUEST_H
#define FUZZ_REQUEST_H

#include "fuzz_promise.h"
#include "server/Gate.h"
#include "server/Request.h"
#include "session/Folder.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace fuzz {

inline int request(const std::uint8_t* data, std::size_t size) {
  using namespace reebquad::studio;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto request = parse_request(text);
  if (request) {
    promise(request->id >= 0 && request->id == request_id(text));
    promise(request->body.is_object());
    promise(bool(parse_request(request->body.dump(-1, ' ', false, Json::error_handler_t::replace))));
  } else {
    promise(!request.error().message.empty());
    request_id(text);
  }
  static Gate gate(8080, random_secret());
  promise(!gate.secret_opens(text) && !gate.token_opens(text) && !gate.host_is_ours(text + "x"));
  static const Folder folder(std::filesystem::temp_directory_path());
  if (const auto path = folder.resolve(text))
    promise(path->rfind(folder.path().string() + "/", 0) == 0 && path->find("/../") == std::string::npos);
  return 0;
}

} // namespace fuzz

#endif // FUZZ_REQUEST_H
