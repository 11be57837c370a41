// The extreme numbers of each type that an argument may have.
#pragma once

#include <cstddef>
#include <span>

#include "tests/gl_api/command_table.hpp"

namespace spangle::test {

/// As entry points of the command table take them. Integers are whole numbers that the type holds.
std::span<const double> extremes_of(char type);

/// Writes `number` to element `index` of an array of that type.
void put(void* array, char type, std::size_t index, double number);

} // namespace spangle::test
