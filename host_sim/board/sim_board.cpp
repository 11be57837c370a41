#include <spangle/sim/board.hpp>

#include <vector>

#include <spangle/hal/panel_display.hpp>

#include "host_sim/bus/sim_bus.hpp"

namespace spangle::sim {

namespace {

const Chip& chip_of(hal::Controller controller) {
    return chips[static_cast<unsigned>(controller)];
}

/// How the module is built, from the panel's data.
GlassMount mount_of(const hal::PanelDesc& panel) {
    GlassMount m;
    m.x = panel.offset.x;
    m.y = panel.offset.y;
    m.width = panel.glass.width;
    m.height = panel.glass.height;
    m.mirror_columns = (panel.mount & 0x40) != 0;
    m.mirror_rows = (panel.mount & 0x80) != 0;
    m.bgr_filter = panel.order == hal::ColorOrder::bgr;
    m.normally_inverted = panel.inverted;
    return m;
}

/// The memory PanelDisplay asks its owner for.
struct Bookkeeping {
    std::vector<RowSpan> touched, damage, content[2];
    std::vector<std::uint16_t> plan;
    std::vector<hal::Op> ops = std::vector<hal::Op>(64);
    std::vector<hal::OpParams> params = std::vector<hal::OpParams>(64);
    std::int32_t height;
    std::uint8_t buffers;

    Bookkeeping(std::int32_t rows, std::uint8_t buffer_count) : height(rows), buffers(buffer_count) {
        const auto n = static_cast<std::size_t>(rows);
        for (std::vector<RowSpan>* v : {&touched, &damage, &content[0], &content[1]})
            v->resize(n);
        plan.resize(n);
    }
    hal::PanelMemory memory() {
        return {touched.data(), damage.data(), {content[0].data(), content[buffers - 1].data()},
                plan.data(),    height,        buffers,
                ops.data(),     params.data(), ops.size()};
    }
};

Image picture_of(const std::vector<Rgb666>& pixels, int width, int height) {
    Image out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb666 p = pixels[static_cast<std::size_t>(y * width + x)];
            const auto eight = [](int six) { return static_cast<std::uint8_t>(six << 2 | six >> 4); };
            std::uint8_t* const to = out.at(x, y);
            to[0] = eight(p.r);
            to[1] = eight(p.g);
            to[2] = eight(p.b);
        }
    return out;
}

/// The picture as it was drawn: turned back, then mirrored back.
Image upright(const Image& glass, hal::Orientation o) {
    const bool across = o.rotation == hal::Rotation::r90 || o.rotation == hal::Rotation::r270;
    Image out(across ? glass.height : glass.width, across ? glass.width : glass.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int px = o.mirrored ? out.width - 1 - x : x;
            int gx = px, gy = y;  // r0
            switch (o.rotation) { // the picture is turned clockwise on the glass
            case hal::Rotation::r90:
                gx = glass.width - 1 - y, gy = px;
                break;
            case hal::Rotation::r180:
                gx = glass.width - 1 - px, gy = glass.height - 1 - y;
                break;
            case hal::Rotation::r270:
                gx = y, gy = glass.height - 1 - px;
                break;
            default:
                break;
            }
            const std::uint8_t* const from = glass.at(gx, gy);
            for (int c = 0; c < 4; ++c)
                out.at(x, y)[c] = from[c];
        }
    return out;
}

} // namespace

struct SimBoard::Parts {
    hal::Board board;
    DcsController controller;
    SimBus bus;
    Bookkeeping books;
    hal::PanelDisplay display;
    std::unique_ptr<VcdFile> vcd;

    explicit Parts(const hal::Board& b)
        : board(b), controller(chip_of(b.display.panel->controller), mount_of(*b.display.panel),
                               b.bus == hal::BusKind::i8080),
          bus(controller, hal::bus_caps(b)),
          books(hal::place(*b.display.panel, b.display.orientation).size.height, b.display.buffers),
          display(bus, board.display, books.memory()) {}
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
    DcsController& c = parts_->controller;
    // Two refreshes later the glass shows what the memory holds.
    parts_->bus.pass(2 * Time(c.chip().line_ns) * Time(c.chip().height + c.chip().porch_lines));
    const Image seen = picture_of(c.glass(parts_->bus.now()), c.mount().width, c.mount().height);
    return upright(seen, parts_->board.display.orientation);
}

Image SimBoard::memory() const {
    const DcsController& c = parts_->controller;
    return picture_of(c.memory(), c.chip().width, c.chip().height);
}

BoardCounters SimBoard::counters() const {
    const BusCounters& c = parts_->bus.counters();
    return {c.bytes, c.commands, c.pixel_bytes, c.transfers, c.busy_ns};
}

const Violations& SimBoard::violations() const {
    return parts_->controller.violations();
}

std::string SimBoard::violations_text() const {
    std::string text;
    for (const Violation& v : violations())
        text += "rule " + std::to_string(static_cast<int>(v.rule)) + " at " + std::to_string(v.at / 1000) +
                " us: " + v.text + "\n";
    return text;
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
