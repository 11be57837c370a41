// The memory that a PanelDisplay asks of its owner, for a display that is described at run time.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <spangle/hal/panel_display.hpp>

namespace spangle::sim {

struct Bookkeeping {
    static constexpr std::size_t list = 2048; ///< ops, enough for any frame
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

} // namespace spangle::sim
