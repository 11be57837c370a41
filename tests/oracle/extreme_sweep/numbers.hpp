// Lists the extreme numbers of each type that an argument may have.
#pragma once

#include <cstddef>
#include <span>

#include "tests/gl/api/command_table.hpp"

namespace spangle::test {

/// Returns the extreme numbers of a type of the command table. Those of integer types are whole numbers that
/// the type holds.
std::span<const double> extremes_of(char type);

/// Writes `number` to element `index` of an array of that type.
void put(void* array, char type, std::size_t index, double number);

} // namespace spangle::test
