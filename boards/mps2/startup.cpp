// Reset: copy .data, clear .bss, run constructors, main. Any fault ends the run with a message and exit
// status 3.
#include <cstdint>

#include "boards/mps2/semihosting.hpp"

extern "C" {
extern std::uint32_t stack_top, data_load, data_begin, data_end, bss_begin, bss_end;
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();
int main();

[[noreturn]] void reset_handler() {
    const std::uint32_t* from = &data_load;
    for (std::uint32_t* to = &data_begin; to < &data_end;)
        *to++ = *from++;
    for (std::uint32_t* to = &bss_begin; to < &bss_end;)
        *to++ = 0;
    for (auto constructor = __init_array_start; constructor != __init_array_end; ++constructor)
        (*constructor)();
    spangle::semihosting::exit(main());
}

[[noreturn]] void fault_handler() {
    spangle::semihosting::print("fault\n");
    spangle::semihosting::exit(3);
}

using Handler = void (*)();
struct Vectors {
    std::uint32_t* stack;
    Handler handler[15];
};
extern const Vectors vectors;
__attribute__((section(".vectors"), used)) const Vectors vectors = {
    &stack_top,
    {reset_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, nullptr,
     nullptr, nullptr, nullptr, fault_handler, fault_handler, nullptr, fault_handler, fault_handler}};
}
