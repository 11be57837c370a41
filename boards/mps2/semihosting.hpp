// Arm semihosting for M-profile cores: text, files and the exit status of an emulated board. Needs a debugger
// or an emulator on the other side; images for real boards leave it out.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::semihosting {

inline std::uint32_t call(std::uint32_t operation, const void* argument) {
    register std::uint32_t r0 asm("r0") = operation;
    register const void* r1 asm("r1") = argument;
    asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/// SYS_WRITE0
inline void print(const char* text) {
    call(0x04, text);
}

inline void print_number(std::uint32_t value) {
    char digits[11];
    char* at = digits + 10;
    *at = '\0';
    do {
        *--at = static_cast<char>('0' + value % 10);
        value /= 10;
    } while (value != 0);
    print(at);
}

inline void print_hex(std::uint32_t value) {
    char digits[9] = {};
    for (int i = 0; i < 8; ++i)
        digits[i] = "0123456789abcdef"[value >> (28 - 4 * i) & 15];
    print(digits);
}

/// SYS_EXIT_EXTENDED with ADP_Stopped_ApplicationExit
[[noreturn]] inline void exit(int status) {
    const std::uint32_t block[2] = {0x20026, static_cast<std::uint32_t>(status)};
    call(0x20, block);
    for (;;) {
    }
}

} // namespace spangle::semihosting
