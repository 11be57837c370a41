#include "tests/gl/api/command_table.hpp"

#include <spangle/GL/gl.h>

namespace spangle::test {

#include "tests/gl/api/generated/command_table.inc"

std::span<const Command> commands() {
    return table;
}

} // namespace spangle::test
