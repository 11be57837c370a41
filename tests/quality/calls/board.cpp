// Runs the cases of calls.hpp on an emulated board, and prints the number of the first wrong case.
#include <spangle/mcu/semihosting.hpp>

#include "tests/quality/calls/calls.hpp"

int main() {
    volatile std::int32_t two = 2, four = 4;
    spangle::mcu::semihosting::print("wrong ");
    spangle::mcu::semihosting::print_number(
        static_cast<std::uint32_t>(spangle::calls::first_wrong(two, four)));
    spangle::mcu::semihosting::print("\n");
    return 0;
}
