#include "host_sim/boards/desk.hpp"

#include <vector>

#include <spangle/sim/board.hpp>

#include "host_sim/board/scanned_memory.hpp"

namespace spangle::sim {

namespace {

class PanelDesk final : public Desk {
  public:
    explicit PanelDesk(const hal::Board& board) : board_(board) {}
    hal::Display& display() override { return board_.display(); }
    Image glass() override { return board_.glass(); }
    std::string violations() const override { return board_.violations_text(); }

  private:
    SimBoard board_;
};

class ScannedDesk final : public Desk {
  public:
    explicit ScannedDesk(const hal::MappedConfig& config)
        : memory_(2 * frame_bytes(config)), touched_(static_cast<std::size_t>(config.height)),
          port_(config.width, config.format, config.width * bytes_per_pixel(config),
                {config.height, 10, 60000}),
          display_(port_, with_memory(config)) {}
    hal::Display& display() override { return display_; }
    Image glass() override {
        Image seen;
        port_.on_refresh = [&seen](const Image& image) { seen = image; };
        port_.advance(2 * port_.period());
        port_.on_refresh = nullptr;
        return seen;
    }

  private:
    static int bytes_per_pixel(const hal::MappedConfig& config) {
        return format_info(config.format).bytes_per_pixel;
    }
    static std::size_t frame_bytes(const hal::MappedConfig& config) {
        return static_cast<std::size_t>(config.width) * static_cast<std::size_t>(config.height) *
               static_cast<std::size_t>(bytes_per_pixel(config));
    }
    hal::MappedConfig with_memory(hal::MappedConfig config) {
        config.buffers[0] = memory_.data();
        config.buffers[1] = memory_.data() + frame_bytes(config);
        config.touched = touched_.data();
        return config;
    }

    std::vector<std::uint8_t> memory_;
    std::vector<RowSpan> touched_;
    ScannedMemory port_;
    hal::MappedDisplay display_;
};

} // namespace

std::unique_ptr<Desk> make_desk(const hal::Board& board) {
    return std::make_unique<PanelDesk>(board);
}

std::unique_ptr<Desk> make_desk(const hal::MappedConfig& config) {
    return std::make_unique<ScannedDesk>(config);
}

} // namespace spangle::sim
