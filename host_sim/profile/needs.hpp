// Which optional systems commands and tokens ask for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spangle::profile {

/// Of a family, as commands are named in messages.
const std::vector<const char*>& features_of(const std::string& command);

/// Null where a token needs none.
const char* feature_of(std::uint32_t token);

} // namespace spangle::profile
