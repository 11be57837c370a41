// The four functions of memory that C++ compilers may call by themselves. They move words where both sides
// are aligned.
#include <cstddef>
#include <cstdint>

extern "C" {

void* memcpy(void* to, const void* from, std::size_t n) {
    auto* d = static_cast<unsigned char*>(to);
    const auto* s = static_cast<const unsigned char*>(from);
    if (((reinterpret_cast<std::uintptr_t>(d) | reinterpret_cast<std::uintptr_t>(s)) & 3) == 0)
        for (; n >= 4; n -= 4, d += 4, s += 4)
            *reinterpret_cast<std::uint32_t*>(d) = *reinterpret_cast<const std::uint32_t*>(s);
    for (; n != 0; --n)
        *d++ = *s++;
    return to;
}

void* memmove(void* to, const void* from, std::size_t n) {
    auto* d = static_cast<unsigned char*>(to);
    const auto* s = static_cast<const unsigned char*>(from);
    if (d <= s)
        return memcpy(to, from, n);
    for (; n != 0; --n)
        d[n - 1] = s[n - 1];
    return to;
}

void* memset(void* to, int value, std::size_t n) {
    auto* d = static_cast<unsigned char*>(to);
    const std::uint32_t word = 0x01010101u * static_cast<unsigned char>(value);
    if ((reinterpret_cast<std::uintptr_t>(d) & 3) == 0)
        for (; n >= 4; n -= 4, d += 4)
            *reinterpret_cast<std::uint32_t*>(d) = word;
    for (; n != 0; --n)
        *d++ = static_cast<unsigned char>(value);
    return to;
}

int memcmp(const void* a, const void* b, std::size_t n) {
    const auto *x = static_cast<const unsigned char*>(a), *y = static_cast<const unsigned char*>(b);
    int difference = 0;
    for (; n != 0 && difference == 0; --n)
        difference = *x++ - *y++;
    return difference;
}
}
