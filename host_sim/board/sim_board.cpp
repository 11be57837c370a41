#include <spangle/sim/board.hpp>

#include <utility>

#include "host_sim/board/bookkeeping.hpp"
#include "host_sim/board/module.hpp"
#include "host_sim/bus/sim_bus.hpp"

namespace spangle::sim {

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
SimBoard::~SimBoard() {
    end_vcd();
}

hal::Display& SimBoard::display() {
    return parts_->display;
}

hal::Bus& SimBoard::bus() {
    return parts_->bus;
}

Image SimBoard::glass() const {
    Image image = scan_out();
    if (parts_->controller->mount().round)
        hide_corners(image);
    return image;
}

Image SimBoard::scan_out() const {
    Controller& c = *parts_->controller;
    parts_->bus.settle();
    // After two refreshes the glass surely shows what the memory holds.
    parts_->bus.pass(2 * c.refresh_time());
    const Image scanned = picture_of(c.glass(parts_->bus.now()), c.mount().width, c.mount().height);
    return upright(scanned, parts_->board.display.orientation);
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

std::string SimBoard::record_vcd(const std::string& path, std::uint64_t most_bytes) {
    end_vcd();
    auto vcd = std::make_unique<VcdFile>(path, parts_->board.bus,
                                         most_bytes != 0 ? most_bytes : VcdFile::usual_limit);
    if (!vcd->problem().empty())
        return vcd->problem();
    parts_->vcd = std::move(vcd);
    parts_->bus.listen(parts_->vcd.get());
    return "";
}

SimBoard::Recorded SimBoard::end_vcd() {
    const std::unique_ptr<VcdFile> vcd = std::move(parts_->vcd);
    parts_->bus.listen(nullptr);
    if (vcd == nullptr)
        return {};
    const Time end = vcd->end();
    return {vcd->commit(), vcd->is_full(), end};
}

void SimBoard::fail_next(hal::Fault fault) {
    parts_->bus.fail_next(fault);
}

void SimBoard::drop_byte(std::uint64_t n) {
    parts_->bus.drop_byte(n);
}

} // namespace spangle::sim
