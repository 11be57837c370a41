// The cases of calls.hpp as a program of an emulated board: prints the number of the first one that is wrong.
#include <spangle/mcu/semihosting.hpp>

#include "tests/calls/calls.hpp"

int main() {
    volatile std::int32_t two = 2, four = 4;
    spangle::mcu::semihosting::print("wrong ");
    spangle::mcu::semihosting::print_number(
        static_cast<std::uint32_t>(spangle::calls::first_wrong(two, four)));
    spangle::mcu::semihosting::print("\n");
    return 0;
}
