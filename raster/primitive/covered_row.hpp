// From the coverage of a row to spans: runs of whole pixels, and runs with a coverage each.
#pragma once

#include "raster/primitive/area.hpp"
#include "raster/primitive/pen.hpp"

namespace spangle::raster {

template <class P> class CoveredRow {
  public:
    CoveredRow(Pen<P>& pen, PrimitiveState& primitive) : pen_(pen), primitive_(primitive) {
        primitive_.antialiased = true;
    }
    ~CoveredRow() {
        primitive_.coverage = nullptr;
        primitive_.antialiased = false;
    }
    CoveredRow(const CoveredRow&) = delete;
    CoveredRow& operator=(const CoveredRow&) = delete;

    /// What `area` has in columns [left, right) of row y, inside the scissor rectangle's rows.
    void draw(const AreaRow& area, std::int32_t y, std::int32_t left, std::int32_t right) {
        y_ = y;
        left_ = left;
        right_ = right;
        std::int32_t x = left < pen_.column_begin() ? pen_.column_begin() : left;
        const std::int32_t end = right < pen_.column_end() ? right : pen_.column_end();
        while (x < end) {
            const std::int32_t plain = area.plain_end(x);
            const std::uint32_t coverage = area.coverage(x);
            const std::int32_t till = plain <= x ? x + 1 : plain < end ? plain : end;
            if (coverage == full_coverage && till - x > 1) {
                flush();
                emit(x, till, nullptr);
                x = till;
                continue;
            }
            for (; x < till; ++x)
                add(x, coverage);
        }
        flush();
    }

  private:
    void add(std::int32_t x, std::uint32_t coverage) {
        if (count_ == room || coverage == 0)
            flush();
        if (coverage == 0) // no fragment
            return;
        if (count_ == 0)
            from_ = x;
        coverage_[count_++] = coverage;
    }
    void flush() {
        if (count_ != 0)
            emit(from_, from_ + count_, coverage_);
        count_ = 0;
    }
    void emit(std::int32_t first, std::int32_t last, const std::uint32_t* coverage) {
        primitive_.coverage = coverage;
        pen_.rows()[0] = {y_, left_, right_, first, last};
        pen_.draw(pen_.rows() + 1);
    }

    static constexpr int room = 32;
    Pen<P>& pen_;
    PrimitiveState& primitive_;
    std::int32_t y_ = 0, left_ = 0, right_ = 0, from_ = 0;
    int count_ = 0;
    std::uint32_t coverage_[room];
};

} // namespace spangle::raster
