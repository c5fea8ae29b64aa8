#pragma once

// Declares nlohmann::json, for references and pointers: the only header that names the library, whose own headers
// sources include. Private to io.
#include <nlohmann/json_fwd.hpp>
