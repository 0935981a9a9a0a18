#pragma once

#include <string>
#include <string_view>

namespace eisph {

/// Text as it may stand in HTML, in attributes too.
[[nodiscard]] std::string html_escaped(std::string_view text);

/// Bytes in base64 (RFC 4648).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace eisph
