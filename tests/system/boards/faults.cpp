// Firmware that goes wrong on purpose. Its second argument chooses an illegal instruction, an address without
// memory, or a recursion without end. The handlers of the start-up code report it; nothing else of the board
// is used.
#include <cstdint>

#include <spangle/mcu/semihosting.hpp>

namespace {

volatile std::uint32_t sink;
constexpr std::uintptr_t nothing_there = 0xE8000000; ///< no board has memory here

__attribute__((noinline)) std::uint32_t deeper(std::uint32_t n) {
    volatile std::uint32_t here[8];
    here[n % 8] = n;
    sink = here[0];
    return n == 0 ? 0 : deeper(n + 1) + here[n % 8]; // the number wraps long after the stack has ended
}

} // namespace

int main() {
    char words[64];
    if (!spangle::mcu::semihosting::command_line(words, sizeof words))
        return 1;
    const char* at = words;
    while (*at != '\0' && *at != ' ')
        ++at;
    if (*at == ' ' && at[1] == 's')
        sink = deeper(1);
    if (*at == ' ' && at[1] == 'i')
#if defined(__riscv)
        asm volatile(".word 0");
#else
        asm volatile("udf #0");
#endif
    if (*at == ' ' && at[1] == 'a')
        sink = *reinterpret_cast<volatile const std::uint32_t*>(nothing_there);
    return 7; // the fault did not happen
}
