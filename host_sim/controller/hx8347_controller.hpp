// HX8347: a controller of colour TFT glass with registers, each with an index and a value of one byte. The
// model is written from the datasheet's facts alone.
#pragma once

#include <array>

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

/// How an index differs from a value: on a parallel bus by D/C, and on a serial bus by the first byte after
/// CS, 70h or 72h.
enum class RegisterBus : std::uint8_t { parallel, start_byte };

class Hx8347Controller final : public Controller {
  public:
    static constexpr int width = 240, height = 320;

    Hx8347Controller(const GlassMount& glass, RegisterBus bus);

    void reset(bool low, Time now) override;
    void select(bool chip_select, Time now) override;
    void write(std::uint8_t byte, bool data, Time now, unsigned period_ns) override;
    bool answers() const override { return is_answering_; }
    bool drive_bit() override;
    void read_clock(Time now, unsigned period_ns) override;

    std::vector<Rgb666> glass(Time now) override;
    std::vector<Rgb666> cells() const override { return memory_; }
    MemorySize memory_size() const override { return {width, height}; }
    // TE is not wired on modules of this chip, so a viewer sees the memory at once.
    Time line_time() const override { return 1; }
    Time refresh_time() const override { return 0; }

    std::uint8_t value(std::uint8_t index) const { return registers_[index]; }

  private:
    RegisterBus bus_;
    std::vector<Rgb666> memory_;
    std::array<std::uint8_t, 256> registers_{};
    std::uint8_t index_ = 0;
    bool is_selected_ = false, is_in_reset_ = false, has_start_byte_ = false, index_follows_ = false;
    bool is_answering_ = false, is_too_fast_ = false;
    int value_count_ = 0; ///< number of values written since the index
    int answer_bit_ = 0;
    Time reset_fell_at_ = 0, ready_at_ = 0;
    std::array<std::uint8_t, 3> pixel_bytes_{};
    int pixel_byte_count_ = 0, column_ = 0, row_ = 0;
    std::uint64_t stream_pixels_ = 0; ///< pixels since index 22h was chosen

    void power_on();
    void start(std::uint8_t byte, Time now);
    void choose(std::uint8_t index, Time now);
    void end_register(Time now);
    void store(std::uint8_t value, Time now);
    void check_window(Time now);
    void pixel_byte(std::uint8_t byte, Time now);
    void put(Rgb666 color, Time now);
    int word(std::uint8_t index) const { return registers_[index] << 8 | registers_[index + 1u]; }
    int pixel_bytes() const { return (registers_[0x17] & 7) == 6 ? 3 : 2; }
    bool order(std::uint8_t bit) const { return (registers_[0x16] & bit) != 0; }
    std::uint64_t window() const;
};

} // namespace spangle::sim
