// Runs from reset to the picture's hash, which is printed by semihosting. Also has the functions that
// compilers call by themselves.
#include <cstddef>

#include <spangle/mcu/semihosting.hpp>

#include "picture.hpp"

extern "C" {
extern char bss_begin, bss_end, stack_top;

void* memset(void* to, int value, std::size_t n) {
    for (auto* at = static_cast<unsigned char*>(to); n != 0; --n)
        *at++ = static_cast<unsigned char>(value);
    return to;
}
void* memcpy(void* to, const void* from, std::size_t n) {
    auto* at = static_cast<unsigned char*>(to);
    for (const auto* source = static_cast<const unsigned char*>(from); n != 0; --n)
        *at++ = *source++;
    return to;
}
void* memmove(void* to, const void* from, std::size_t n) {
    auto* at = static_cast<unsigned char*>(to);
    const auto* source = static_cast<const unsigned char*>(from);
    if (at < source)
        return memcpy(to, from, n);
    while (n-- != 0)
        at[n] = source[n];
    return to;
}
int memcmp(const void* a, const void* b, std::size_t n) {
    const auto *x = static_cast<const unsigned char*>(a), *y = static_cast<const unsigned char*>(b);
    for (; n != 0; --n, ++x, ++y)
        if (*x != *y)
            return *x - *y;
    return 0;
}

[[noreturn, gnu::used]] void run() {
    memset(&bss_begin, 0, static_cast<std::size_t>(&bss_end - &bss_begin));
    const std::uint32_t hash = picture_hash();
    spangle::mcu::semihosting::print_hex(hash);
    spangle::mcu::semihosting::print("\n");
    spangle::mcu::semihosting::exit(hash != 0 ? 0 : 1);
}

#if defined(__riscv)
[[noreturn, gnu::naked, gnu::section(".start"), gnu::used]] void start() {
    asm volatile("la sp, stack_top\n"
                 "j run");
}
#else
using Word = void (*)();
struct Vectors {
    char* stack;
    Word reset;
};
extern const Vectors vectors;
__attribute__((section(".start"), used)) const Vectors vectors = {&stack_top, run};
#endif
}
