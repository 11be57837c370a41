// Command streams that draw. The fuzzer starts with them, because random calls seldom find Begin, vertices
// and End in that order.
#pragma once

#include <cstdint>
#include <vector>

namespace spangle::test {

std::vector<std::vector<std::uint8_t>> command_seeds();

} // namespace spangle::test
