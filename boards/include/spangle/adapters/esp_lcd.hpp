// A Bus on ESP-IDF's esp_lcd panel IO (SPI, 8080, I2C), so that Spangle's panels and
// [damage](docs/glossary.md#damage) run on Espressif's DMA drivers. The program provides esp_lcd_panel_io.h,
// makes the panel IO, and passes the rest of the board's wiring in EspLcdConfig.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include <esp_lcd_panel_io.h>
#include <spangle/hal/bus.hpp>

namespace spangle::adapters {

/// What an ESP-IDF program says of its wiring.
struct EspLcdConfig {
    /// The panel IO, which must outlive the bus.
    esp_lcd_panel_io_handle_t io = nullptr;
    /// The wires of the panel IO.
    hal::BusKind kind = hal::BusKind::spi4;
    std::uint32_t write_hz = 0; ///< Hz, as the panel IO was made with
    /// 1 for SPI and I2C, 8 for an 8080 bus.
    std::uint8_t bits_per_cycle = 1;
    std::uint32_t command_cost_ns = 20000; ///< nanoseconds that a queued transaction costs
    /// Needed; waits that many microseconds: esp_rom_delay_us, or vTaskDelay for long waits.
    void (*delay_us)(std::uint32_t) = nullptr;
    void (*set_reset)(bool high) = nullptr; ///< drives the reset line; null: there is none
    /// Needed; returns memory for DMA: heap_caps_malloc(bytes, MALLOC_CAP_DMA).
    void* (*allocate)(std::size_t bytes) = nullptr;
};

/// This bus cannot read, because panels need more dummy clocks in a read than esp_lcd sends. Transfers of
/// pixels are queued; a list of operations is done when its last transfer is.
class EspLcdBus final : public hal::Bus {
  public:
    /// Registers the callback of sent pixels with the panel IO; an error of that is told by submit().
    explicit EspLcdBus(const EspLcdConfig& config) : config_(config) {
        esp_lcd_panel_io_callbacks_t callbacks = {};
        callbacks.on_color_trans_done = &sent;
        registered_ = esp_lcd_panel_io_register_event_callbacks(config.io, &callbacks, this);
    }
    /// A bus is not copied: the panel IO calls back to it.
    EspLcdBus(const EspLcdBus&) = delete;
    /// A bus is not assigned.
    EspLcdBus& operator=(const EspLcdBus&) = delete;

    hal::BusCaps caps() const override {
        hal::BusCaps caps;
        caps.kind = config_.kind;
        caps.write_hz = config_.write_hz;
        caps.bits_per_cycle = config_.bits_per_cycle;
        caps.command_cost_ns = config_.command_cost_ns;
        return caps;
    }
    hal::Result<hal::Buffer> acquire(std::size_t size) override {
        if (config_.allocate == nullptr)
            return hal::Error{hal::Fault::bad_argument, "esp_lcd: EspLcdConfig::allocate is not set"};
        void* const bytes = config_.allocate(size);
        if (bytes == nullptr)
            return hal::Error{hal::Fault::no_answer, "esp_lcd: no memory for a frame that DMA can reach"};
        return hal::Buffer{static_cast<std::uint8_t*>(bytes), size};
    }
    hal::Result<hal::Token> submit(const hal::Op* ops, std::size_t count) override {
        if (config_.delay_us == nullptr)
            return hal::Error{hal::Fault::bad_argument, "esp_lcd: EspLcdConfig::delay_us is not set"};
        if (registered_ != ESP_OK)
            return failed("register callbacks", registered_);
        if (queued_.load() != 0)
            return hal::Error{hal::Fault::busy, "esp_lcd: a transfer is still under way"};
        for (std::size_t i = 0; i < count; ++i)
            if (const char* const rule = refusal(ops[i]))
                return hal::Error{hal::Fault::unsupported, rule};
        token_.id = token_.id + 1 != 0 ? token_.id + 1 : 1;
        outcome_ = {};
        for (std::size_t i = 0; i < count && outcome_.ok(); ++i)
            outcome_ = run(ops[i], i + 1 < count ? &ops[i + 1] : nullptr);
        return token_;
    }
    bool done(hal::Token token) const override { return token.id != token_.id || queued_.load() == 0; }
    hal::Result<void> wait(hal::Token token, std::uint32_t timeout_micros) override {
        constexpr std::uint32_t look_us = 50;
        for (std::uint32_t waited = 0; !done(token); waited += look_us) {
            if (waited >= timeout_micros)
                return hal::Error{hal::Fault::timeout, "esp_lcd: the transfer did not end in time"};
            config_.delay_us(look_us);
        }
        return token.id == token_.id ? outcome_ : hal::Result<void>{};
    }

  private:
    /// The command by which esp_lcd sends data that continue the last command.
    static constexpr int no_command = -1;
    static constexpr std::uint32_t block_bytes = 240;
    EspLcdConfig config_;
    esp_err_t registered_ = ESP_OK;
    /// Transfers of pixels under way; the driver's interrupt counts down.
    std::atomic<std::uint32_t> queued_{0};
    hal::Token token_;
    hal::Result<void> outcome_;
    int pending_ = no_command;        ///< a command that goes out with the pixels behind it
    std::uint8_t block_[block_bytes]; ///< the bytes of a repeated pattern

    static bool sent(esp_lcd_panel_io_handle_t, esp_lcd_panel_io_event_data_t*, void* self) {
        static_cast<EspLcdBus*>(self)->queued_.fetch_sub(1);
        return false; // no task of higher priority was woken
    }
    static hal::Error failed(const char* operation, esp_err_t code) {
        return {code == ESP_ERR_TIMEOUT ? hal::Fault::timeout : hal::Fault::no_answer, operation,
                static_cast<std::uint32_t>(code)};
    }

    const char* refusal(const hal::Op& op) const {
        using Kind = hal::Op::Kind;
        switch (op.kind) {
        case Kind::command:
        case Kind::pixels:
        case Kind::delay:
            return nullptr;
        case Kind::repeat:
            return op.length == 0 || op.length > 4 ? "esp_lcd: a repeated pattern has one to four bytes"
                                                   : nullptr;
        case Kind::reset:
            return config_.set_reset == nullptr ? "esp_lcd: no reset line is wired" : nullptr;
        default:
            return "esp_lcd: neither reads nor waits for a line";
        }
    }

    hal::Result<void> run(const hal::Op& op, const hal::Op* next) {
        using Kind = hal::Op::Kind;
        switch (op.kind) {
        case Kind::command:
            return command(op, next != nullptr && (next->kind == Kind::pixels || next->kind == Kind::repeat));
        case Kind::pixels:
            return pixels(op);
        case Kind::repeat:
            return repeat(op);
        case Kind::delay:
            settle();
            config_.delay_us(op.micros);
            return {};
        default:
            settle();
            config_.set_reset(false);
            config_.delay_us(op.micros);
            config_.set_reset(true);
            return {};
        }
    }

    hal::Result<void> command(const hal::Op& op, bool pixels_follow) {
        if (op.length == 0 && pixels_follow) {
            pending_ = op.command;
            return {};
        }
        if (!op.parameters_are_commands)
            return checked("esp_lcd: transmit a command",
                           esp_lcd_panel_io_tx_param(config_.io, op.command, op.data, op.length));
        hal::Result<void> result = checked("esp_lcd: transmit a command",
                                           esp_lcd_panel_io_tx_param(config_.io, op.command, nullptr, 0));
        for (std::uint32_t i = 0; i < op.length && result.ok(); ++i)
            result = checked("esp_lcd: transmit a command",
                             esp_lcd_panel_io_tx_param(config_.io, op.data[i], nullptr, 0));
        return result;
    }

    hal::Result<void> pixels(const hal::Op& op) {
        const bool gapless = op.stride == static_cast<std::int64_t>(op.length);
        const std::size_t bytes = gapless ? std::size_t{op.length} * op.rows : op.length;
        hal::Result<void> result;
        for (std::uint32_t row = 0; row < (gapless ? 1 : op.rows) && result.ok(); ++row)
            result = color(op.data + std::ptrdiff_t{op.stride} * static_cast<std::ptrdiff_t>(row), bytes);
        return result;
    }

    hal::Result<void> repeat(const hal::Op& op) {
        settle(); // a transfer may still read the block
        const std::uint32_t whole = block_bytes - block_bytes % op.length;
        for (std::uint32_t i = 0; i < whole; ++i)
            block_[i] = op.data[i % op.length];
        hal::Result<void> result;
        for (std::uint64_t left = std::uint64_t{op.length} * op.rows; left != 0 && result.ok();) {
            const std::uint32_t taken = left < whole ? static_cast<std::uint32_t>(left) : whole;
            result = color(block_, taken);
            left -= taken;
        }
        return result;
    }

    hal::Result<void> color(const std::uint8_t* data, std::size_t bytes) {
        if (bytes == 0)
            return {};
        queued_.fetch_add(1);
        const esp_err_t code = esp_lcd_panel_io_tx_color(config_.io, pending_, data, bytes);
        pending_ = no_command;
        if (code != ESP_OK)
            queued_.fetch_sub(1); // this transfer has no callback
        return checked("esp_lcd: transmit pixels", code);
    }

    /// Waits until all queued pixels are sent: esp_lcd sends parameters only after the pixels before them.
    void settle() {
        if (queued_.load() != 0)
            (void)esp_lcd_panel_io_tx_param(config_.io, no_command, nullptr, 0);
    }

    static hal::Result<void> checked(const char* operation, esp_err_t code) {
        return code == ESP_OK ? hal::Result<void>{} : hal::Result<void>(failed(operation, code));
    }
};

} // namespace spangle::adapters
