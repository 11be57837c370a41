// A display through the kernel's DRM, as a compositor uses it: with a dumb buffer, a mode, and damage.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>

namespace kernel_test {

class DrmCard {
  public:
    /// Sets the preferred mode of the first connector, with a black picture of 16 (RGB565) or 32 (XRGB8888)
    /// bits a pixel. Throws an error that says what the kernel refused.
    DrmCard(const char* path, unsigned bits);
    ~DrmCard();
    DrmCard(const DrmCard&) = delete;
    DrmCard& operator=(const DrmCard&) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    /// Sets a pixel; `word` has the picture's format.
    void put(int x, int y, std::uint32_t word);
    std::uint32_t get(int x, int y) const;
    /// Hands a changed area to the driver, which may send it later.
    void flush(spangle::Rect area);

  private:
    int file_ = -1;
    unsigned bits_;
    int width_ = 0, height_ = 0;
    std::uint32_t handle_ = 0, pitch_ = 0, framebuffer_ = 0;
    std::uint64_t size_ = 0;
    std::uint8_t* pixels_ = nullptr;

    void make_buffer();
    void set_mode();
    std::uint8_t* at(int x, int y) const;
};

} // namespace kernel_test
