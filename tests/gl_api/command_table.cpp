#include "tests/gl_api/command_table.hpp"

#include <spangle/GL/gl.h>

namespace spangle::test {

#include "tests/gl_api/generated/command_table.inc"

std::span<const Command> commands() {
    return table;
}

} // namespace spangle::test
