#include <spangle/sim/board.hpp>

#include <vector>

#include <spangle/hal/panel_display.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/bus/sim_bus.hpp"

namespace spangle::sim {

namespace {

/// The memory PanelDisplay asks its owner for.
struct Bookkeeping {
    static constexpr std::size_t list = 2048; ///< one for any frame
    std::vector<RowSpan> touched, damage, turned, held, content[2];
    std::vector<std::uint16_t> plan;
    std::vector<hal::Op> ops = std::vector<hal::Op>(list);
    std::vector<hal::OpParams> params = std::vector<hal::OpParams>(list);
    std::vector<std::uint32_t> hashes, changed;
    std::vector<hal::SpanWindow> windows;
    std::unique_ptr<hal::Palette> palette;
    std::int32_t height;
    std::uint8_t buffers;

    explicit Bookkeeping(const hal::PanelConfig& config)
        : height(hal::book_height(config)), buffers(config.buffers) {
        const auto n = static_cast<std::size_t>(height);
        if (config.row_hash) {
            hashes.resize(n * static_cast<std::size_t>(hal::RowHash::cells_of(hal::sent_size(config).width)));
            changed.resize(n);
            windows.resize(hal::RowHashMemory::window_count);
        }
        for (std::vector<RowSpan>* v : {&touched, &damage, &turned, &held})
            v->resize(n);
        for (std::vector<RowSpan>& v : content)
            v.resize(static_cast<std::size_t>(hal::picture_size(config).height));
        plan.resize(n);
        if (is_indexed(config.format))
            palette = std::make_unique<hal::Palette>();
    }
    hal::RowHashMemory hash_memory() {
        if (hashes.empty())
            return {};
        return {hashes.data(), changed.data(), windows.data(), static_cast<std::int32_t>(hashes.size()),
                &hal::row_hash_code};
    }
    hal::PanelMemory memory() {
        return {touched.data(),
                damage.data(),
                {content[0].data(), content[buffers - 1].data()},
                static_cast<std::int32_t>(content[0].size()),
                plan.data(),
                height,
                buffers,
                ops.data(),
                params.data(),
                ops.size(),
                hash_memory(),
                turned.data(),
                &hal::turn,
                held.data(),
                palette.get()};
    }
};

} // namespace

struct SimBoard::Parts {
    hal::Board board;
    std::unique_ptr<Controller> controller;
    SimBus bus;
    Bookkeeping books;
    hal::PanelDisplay display;
    std::unique_ptr<VcdFile> vcd;

    explicit Parts(const hal::Board& b)
        : board(b), controller(make_controller(*b.display.panel, b.bus)), bus(*controller, hal::bus_caps(b)),
          books(b.display), display(bus, board.display, books.memory()) {}
};

SimBoard::SimBoard(const hal::Board& board) : parts_(std::make_unique<Parts>(board)) {}
SimBoard::~SimBoard() = default;

hal::Display& SimBoard::display() {
    return parts_->display;
}

hal::Bus& SimBoard::bus() {
    return parts_->bus;
}

Image SimBoard::glass() const {
    Controller& c = *parts_->controller;
    parts_->bus.settle();
    // Two refreshes later the glass shows what the memory holds.
    parts_->bus.pass(2 * c.refresh_time());
    const Image seen = picture_of(c.glass(parts_->bus.now()), c.mount().width, c.mount().height);
    return upright(seen, parts_->board.display.orientation);
}

Image SimBoard::memory() const {
    const Controller& c = *parts_->controller;
    return picture_of(c.cells(), c.memory_size().width, c.memory_size().height);
}

BoardCounters SimBoard::counters() const {
    const BusCounters& c = parts_->bus.counters();
    return {c.bytes, c.commands, c.pixel_bytes, c.transfers, c.busy_ns};
}

hal::PresentCounters SimBoard::presents() const {
    return parts_->display.counters();
}

const Violations& SimBoard::violations() const {
    return parts_->controller->violations();
}

std::string SimBoard::violations_text() const {
    return parts_->controller->violations_text();
}

Time SimBoard::now() const {
    return parts_->bus.now();
}

void SimBoard::pass(Time ns) {
    parts_->bus.pass(ns);
}

bool SimBoard::record_vcd(const std::string& path) {
    parts_->vcd = std::make_unique<VcdFile>(path, parts_->board.bus == hal::BusKind::i8080);
    parts_->bus.listen(parts_->vcd.get());
    return parts_->vcd->good();
}

void SimBoard::fail_next(hal::Fault fault) {
    parts_->bus.fail_next(fault);
}

void SimBoard::drop_byte(std::uint64_t n) {
    parts_->bus.drop_byte(n);
}

} // namespace spangle::sim
