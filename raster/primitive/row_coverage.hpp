// The coverage of a row, read from left to right.
#pragma once

#include "raster/primitive/area.hpp"

namespace spangle::raster {

class RowCoverage {
  public:
    /// Coverages of columns [begin, end) of a row; no other column may be asked for.
    RowCoverage(const AreaRow& area, std::int32_t begin, std::int32_t end)
        : area_(area), begin_(area.first() < begin ? begin : area.first()),
          end_(area.last() < end ? area.last() + 1 : end), known_begin_(begin_), known_end_(begin_),
          full_run_begin_(area.core_begin()), full_run_end_(area.core_end()) {
        if (full_run_end_ - full_run_begin_ < least_run)
            full_run_end_ = full_run_begin_ = end_;
        else if (area.fill(full_run_begin_, full_run_begin_ + 1, coverage_); coverage_[0] != full_coverage)
            full_run_end_ = full_run_begin_ = end_;
    }

    std::int32_t begin() const { return begin_; }
    std::int32_t end() const { return end_; }

    /// The run of fully covered pixels that is long enough to be drawn by itself. Where there is none, the
    /// run is empty and lies at end().
    std::int32_t full_run_begin() const { return full_run_begin_; }
    std::int32_t full_run_end() const { return full_run_end_; }
    /// Shorter runs of fully covered pixels are drawn together with their neighbours.
    static constexpr std::int32_t least_run = host_lanes > 1 ? 2 * packet : 2;

    /// The coverages from column x on. `count` is the number that the caller wants, and becomes the number
    /// that there is, which may be smaller.
    const std::uint32_t* from(std::int32_t x, std::int32_t& count) {
        if (x < known_begin_ || x >= known_end_) {
            known_begin_ = x;
            known_end_ = end_ - x < AreaRow::window ? end_ : x + AreaRow::window;
            area_.fill(known_begin_, known_end_, coverage_);
        }
        count = known_end_ - x < count ? known_end_ - x : count;
        return coverage_ + (x - known_begin_);
    }

  private:
    const AreaRow& area_;
    std::int32_t begin_, end_;
    std::int32_t known_begin_, known_end_; ///< columns whose coverage is known
    std::int32_t full_run_begin_, full_run_end_;
    std::uint32_t coverage_[AreaRow::window];
};

} // namespace spangle::raster
