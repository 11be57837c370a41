// Runs the GL command stream under libFuzzer; its grammar is the command table.
#include "tests/gl/api/command_stream.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    spangle::test::run_command_stream(data, bytes);
    return 0;
}
