// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_SOCKET_CONNECTION_H
#define REEBQUAD_SERVER_SOCKET_CONNECTION_H

#include "server/Connection.h"

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

namespace reebquad {
namespace studio {

/// Answers the request for a WebSocket, which the gate has let in, and joins the page to the hub.
void serve_socket(boost::beast::tcp_stream stream,
                  boost::beast::http::request<boost::beast::http::string_body> request, Shared& shared);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_SOCKET_CONNECTION_H
