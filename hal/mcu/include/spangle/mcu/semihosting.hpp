// Semihosting (Arm and RISC-V): text, files and the exit status of an emulated board. Needs a debugger or an
// emulator on the other side; images for real boards leave it out.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::mcu::semihosting {

/// One operation, with the address of its block of arguments; returns what the other side answers.
inline std::uint32_t call(std::uint32_t operation, const void* argument) {
#if defined(__riscv)
    register std::uint32_t result asm("a0") = operation;
    register const void* block asm("a1") = argument;
    asm volatile(".option push\n.option norvc\n.balign 16\n" // the three instructions may not cross a page
                 "slli x0, x0, 0x1f\nebreak\nsrai x0, x0, 7\n.option pop"
                 : "+r"(result)
                 : "r"(block)
                 : "memory");
#else
    register std::uint32_t result asm("r0") = operation;
    register const void* block asm("r1") = argument;
#if __ARM_ARCH_PROFILE == 'M'
    asm volatile("bkpt 0xab" : "+r"(result) : "r"(block) : "memory");
#else
    asm volatile("svc 0xab" : "+r"(result) : "r"(block) : "memory", "lr"); // for Thumb state
#endif
#endif
    return result;
}

/// SYS_WRITE0
inline void print(const char* text) {
    call(0x04, text);
}

/// Prints a number in decimal digits.
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

/// Prints eight hexadecimal digits.
inline void print_hex(std::uint32_t value) {
    char digits[9] = {};
    for (int i = 0; i < 8; ++i)
        digits[i] = "0123456789abcdef"[value >> (28 - 4 * i) & 15];
    print(digits);
}

/// SYS_GET_CMDLINE: what the emulator was told to pass on; false when it does not fit.
inline bool command_line(char* text, std::uint32_t size) {
    struct {
        char* text;
        std::uint32_t size;
    } block = {text, size};
    return call(0x15, &block) == 0;
}

/// SYS_OPEN for reading, and SYS_CLOSE: is there such a file?
inline bool exists(const char* name, std::uint32_t length) {
    const struct {
        const char* name;
        std::uint32_t mode, length;
    } open = {name, 1, length};
    const std::uint32_t handle = call(0x01, &open);
    if (handle == ~0u)
        return false;
    call(0x02, &handle);
    return true;
}

/// SYS_EXIT_EXTENDED with ADP_Stopped_ApplicationExit
[[noreturn]] inline void exit(int status) {
    const std::uint32_t block[2] = {0x20026, static_cast<std::uint32_t>(status)};
    call(0x20, block);
    for (;;) {
    }
}

} // namespace spangle::mcu::semihosting
