// Tells which optional systems commands and tokens ask for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spangle::profile {

/// The optional systems of a command. `command` is the name of its family, as in messages.
const std::vector<const char*>& features_of(const std::string& command);

/// The optional system that a token needs, or null.
const char* feature_of(std::uint32_t token);

} // namespace spangle::profile
