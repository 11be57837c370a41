// Draws random states as firmware of an MPS2 board, run with -icount shift=0. The command line is "NAME SEED
// NUMBER...". By semihosting it prints "NUMBER INSTRUCTIONS FRAGMENTS PICTURE" for each state.
#include <spangle/mcu/instructions.hpp>
#include <spangle/mcu/semihosting.hpp>
#include <spangle/native.hpp>

#include "tests/tools/bench/states/counted.hpp"

namespace {

namespace semihosting = spangle::mcu::semihosting;
using namespace spangle::bench::states;

alignas(8) unsigned char memory_pool[3 * 1024 * 1024];

/// Reads the next number of a line of words. Returns false if there is none.
bool next_number(const char*& at, std::uint32_t& out) {
    while (*at != '\0' && (*at < '0' || *at > '9'))
        ++at;
    if (*at == '\0')
        return false;
    for (out = 0; *at >= '0' && *at <= '9'; ++at)
        out = out * 10 + static_cast<std::uint32_t>(*at - '0');
    return true;
}

void print(std::uint32_t number, const char* end) {
    semihosting::print_number(number);
    semihosting::print(end);
}

} // namespace

int main() {
    static char text[4096];
    const char* at = text;
    std::uint32_t seed = 0, number = 0;
    if (!semihosting::command_line(text, sizeof text) || !next_number(at, seed)) {
        semihosting::print("the command line is NAME SEED NUMBER...\n");
        return 2;
    }
    spangle::memory(memory_pool, sizeof memory_pool);
    spangle::mcu::InstructionCount clock(25'000'000); // clock frequency of these boards in Hz
    while (next_number(at, number)) {
        std::uint32_t instructions = 0;
        const Counted found = count(
            state(seed, number), [&] { clock.begin(); }, [&] { instructions = clock.end(); });
        print(number, " ");
        print(instructions, " ");
        print(found.good ? found.fragments : 0, " ");
        semihosting::print_hex(found.picture);
        semihosting::print("\n");
    }
    return 0;
}
