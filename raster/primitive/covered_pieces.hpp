// Makes spans from the coverage of rows. Pieces of rows are collected until others with the same planes come,
// so that planes are set up once for many rows.
#pragma once

#include "raster/primitive/pen.hpp"
#include "raster/primitive/row_coverage.hpp"

namespace spangle::raster {

/// The planes of a piece: those of a part of its primitive, moved by (dx, dy) pixels.
struct PieceSource {
    int part = 0;
    std::int32_t dx = 0, dy = 0;
    bool moved() const { return (dx | dy) != 0; }
    bool is_before(const PieceSource& s) const { return moved() == s.moved() ? part < s.part : s.moved(); }
};

/// Collects pieces of rows. No two pieces share a pixel, but their parts may overlap. A row first adds pieces
/// that are not moved and then moved pieces, both in the order of their parts.
template <class P> class CoveredPieces {
  public:
    /// Writes the planes of a part into the span.
    struct SetUp {
        void (*run)(void* of, int part) = nullptr; ///< null where the span has its planes already
        void* of = nullptr;
    };
    CoveredPieces(Pen<P>& pen, PrimitiveState& primitive, const SetUp& set_up)
        : pen_(pen), primitive_(primitive), set_up_(set_up) {
        primitive_.antialiased = true;
    }
    ~CoveredPieces() {
        flush();
        primitive_.antialiased = false;
    }
    CoveredPieces(const CoveredPieces&) = delete;
    CoveredPieces& operator=(const CoveredPieces&) = delete;

    /// Adds the pixels that an outline covers in rows [begin, end). The rows lie inside the scissor
    /// rectangle.
    [[gnu::noinline]] void add_rows(const Outline& outline, std::int32_t begin, std::int32_t end,
                                    const PieceSource& source) {
        for (std::int32_t y = begin; y < end; ++y)
            if (const AreaRow area(outline, y); !area.empty()) {
                RowCoverage coverage(area, pen_.column_begin(), pen_.column_end());
                add(coverage, y, area.first(), area.last() + 1, source);
            }
    }
    /// Adds columns [left, right) of row y.
    [[gnu::noinline]] void add(RowCoverage& coverage, std::int32_t y, std::int32_t left, std::int32_t right,
                               const PieceSource& source) {
        std::int32_t x = left < coverage.begin() ? coverage.begin() : left;
        const std::int32_t end = right < coverage.end() ? right : coverage.end();
        Row row{y, left, right, x, x};
        while (x < end) {
            const bool whole = x >= coverage.full_run_begin() && x < coverage.full_run_end();
            std::int32_t till = whole ? coverage.full_run_end()
                                : x < coverage.full_run_begin() && coverage.full_run_begin() < end
                                    ? coverage.full_run_begin()
                                    : end;
            till = till < end ? till : end;
            row.first = x;
            if (whole) {
                row.last = x = till;
                (void)place(row, source, true, 0); // whole pieces store no coverages
                continue;
            }
            std::int32_t count = till - x;
            const std::uint32_t* from = coverage.from(x, count);
            std::int32_t n = 0;
            while (n < count && from[n] != 0) // there is no fragment where coverage is 0
                ++n;
            row.last = x + n;
            if (n != 0) {
                std::uint32_t* const to = place(row, source, false, n);
                for (std::int32_t i = 0; i < n; ++i)
                    to[i] = from[i];
            }
            x += n < count ? n + 1 : n;
        }
    }

  private:
    static constexpr int pieces = host_lanes > 1 ? 128 : 8, coverages = host_lanes > 1 ? 512 : 32,
                         groups = host_lanes > 1 ? 24 : 4;
    static_assert(coverages >= AreaRow::window);
    struct Piece {
        Row row;
        std::int32_t at; ///< index of the piece's first coverage
        std::int32_t next;
    };
    /// Pieces of one source. `whole` says that their pixels are fully covered, so that no coverages are
    /// stored.
    struct PieceGroup {
        PieceSource source;
        bool whole;
        std::int32_t first, last;
        bool is_of(const PieceSource& s, bool w) const {
            return source.part == s.part && source.dx == s.dx && source.dy == s.dy && whole == w;
        }
    };

    /// Adds a piece to the group of its source. Returns the place for its n coverages.
    std::uint32_t* place(const Row& row, const PieceSource& source, bool whole, std::int32_t n) {
        if (piece_count_ == pieces || coverage_count_ + n > coverages)
            flush();
        std::int32_t g = 0;
        while (g < group_count_ && !group_[g].is_of(source, whole))
            ++g;
        if (g == group_count_) {
            if (g == groups) {
                flush();
                g = 0;
            }
            // The groups have the order in which a row adds pieces, because a polygon that is not convex may
            // meet a pixel twice.
            for (; g > 0 && source.is_before(group_[g - 1].source); --g)
                group_[g] = group_[g - 1];
            group_[g] = {source, whole, piece_count_, -1};
            ++group_count_;
        }
        PieceGroup& group = group_[g];
        std::uint32_t* const to = coverage_ + coverage_count_;
        coverage_count_ += n;
        if (group.last >= 0) {
            Piece& before = piece_[group.last];
            if (group.last == piece_count_ - 1 && before.row.y == row.y && before.row.last == row.first) {
                before.row.right = row.right;
                before.row.last = row.last;
                return to;
            }
            before.next = piece_count_;
        }
        group.last = piece_count_;
        piece_[piece_count_++] = {row, coverage_count_ - n, -1};
        return to;
    }

    [[gnu::noinline]] void flush() {
        std::int32_t anchor_x = 0, anchor_y = 0;
        for (std::int32_t g = 0; g < group_count_; ++g) {
            const PieceGroup& group = group_[g];
            if (g == 0 || group.source.part != group_[g - 1].source.part) {
                if (set_up_.run != nullptr)
                    set_up_.run(set_up_.of, group.source.part);
                anchor_x = pen_.span.anchor_x;
                anchor_y = pen_.span.anchor_y;
            }
            pen_.span.anchor_x = anchor_x + group.source.dx;
            pen_.span.anchor_y = anchor_y + group.source.dy;
            draw(group);
            pen_.span.anchor_x = anchor_x;
            pen_.span.anchor_y = anchor_y;
        }
        piece_count_ = coverage_count_ = group_count_ = 0;
    }

    void draw(const PieceGroup& group) {
        primitive_.coverage = nullptr;
        for (std::int32_t i = group.first; i >= 0; i = piece_[i].next) {
            if (!group.whole)
                primitive_.coverage = coverage_ + piece_[i].at;
            pen_.rows()[0] = piece_[i].row;
            pen_.draw(pen_.rows() + 1);
        }
        primitive_.coverage = nullptr;
    }

    Pen<P>& pen_;
    PrimitiveState& primitive_;
    SetUp set_up_;
    std::int32_t piece_count_ = 0, coverage_count_ = 0, group_count_ = 0;
    Piece piece_[pieces];
    std::uint32_t coverage_[coverages];
    PieceGroup group_[groups];
};

} // namespace spangle::raster
