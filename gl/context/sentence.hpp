// A sentence for spangle::on_message, made without allocating memory.
#pragma once

#include <cstdint>

namespace spangle::gl {

/// A text of at most `most` bytes; the end of a longer one is cut off. The longest sentences about arguments
/// fit (gl/api/generated/texts.cpp).
class Sentence {
  public:
    static constexpr unsigned most = 383;
    Sentence& operator<<(const char* text) {
        for (; *text != 0; ++text)
            put(*text);
        return *this;
    }
    /// Appends a number in hexadecimal, with at least four digits, as tokens are written.
    Sentence& hexadecimal(std::uint32_t value) {
        *this << "0x";
        int digits = 4;
        while (digits < 8 && value >> 4 * digits != 0)
            ++digits;
        while (digits-- > 0)
            put("0123456789ABCDEF"[value >> 4 * digits & 15]);
        return *this;
    }
    Sentence& decimal(std::int64_t value) {
        char digits[20];
        int count = 0;
        std::uint64_t rest =
            value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
        do {
            digits[count++] = static_cast<char>('0' + rest % 10);
        } while ((rest /= 10) != 0);
        if (value < 0)
            put('-');
        while (count-- > 0)
            put(digits[count]);
        return *this;
    }
    const char* text() const { return text_; }

  private:
    char text_[most + 1] = {};
    unsigned length_ = 0;

    void put(char c) {
        if (length_ + 1 < sizeof text_)
            text_[length_++] = c;
    }
};

} // namespace spangle::gl
