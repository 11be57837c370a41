// A model of how a DCS controller finds addresses: memory, window, MADCTL, pixels. It follows the datasheets
// (ST7735R 9.11, ILI9341 8.2.20 to 8.2.29), and is small and independent of the driver.
#pragma once

#include <cstdint>
#include <vector>

namespace hal_test {

struct DcsModel {
    int columns, rows; ///< size of the controller's memory
    int madctl = 0;
    int xs = 0, xe = 0, ys = 0, ye = 0;
    int x = 0, y = 0;
    bool full = false; ///< whether the window was written to its end
    long stray = 0;    ///< pixels addressed outside the memory
    long overrun = 0;  ///< pixels written after the window was full
    std::vector<std::uint32_t> memory;

    DcsModel(int w, int h) : columns(w), rows(h), memory(static_cast<std::size_t>(w * h), 0xDEADBEEF) {}

    void ramwr() { x = xs, y = ys, full = false; }

    void pixel(std::uint32_t value) {
        if (full)
            ++overrun;
        int column = x, row = y;
        if (madctl & 0x20)
            column = y, row = x; // with MV, CASET addresses rows
        if (madctl & 0x40)
            column = columns - 1 - column; // MX mirrors columns
        if (madctl & 0x80)
            row = rows - 1 - row; // MY mirrors rows
        if (column < 0 || column >= columns || row < 0 || row >= rows)
            ++stray;
        else
            memory[static_cast<std::size_t>(row * columns + column)] = value;
        if (++x > xe) {
            x = xs;
            if (++y > ye)
                y = ys, full = true;
        }
    }

    std::uint32_t at(int column, int row) const {
        return memory[static_cast<std::size_t>(row * columns + column)];
    }
};

} // namespace hal_test
