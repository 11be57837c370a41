// Figures as text in rows and named columns: what is written to CSV files, and read from them again.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/trade/measure.hpp"

namespace spangle::trade {

struct Table {
    using Row = std::vector<std::string>;
    Row columns;
    std::vector<Row> rows;

    /// The cell of that column; empty where there is none.
    const std::string& text(const Row& row, std::string_view column) const;
    std::optional<double> number(const Row& row, std::string_view column) const;
};

/// RFC 4180, with line feeds.
std::string to_csv(const Table& table);
/// Empty, or why the text is no such table.
std::string from_csv(std::string_view text, Table& out);

/// Which job of a sweep: a program in a format. Its tiers are rows of one job.
struct Job {
    int number, of;
    std::string scene;
    Format format;
};

/// The columns of accuracy.csv, and a row of it. The same bytes on every machine.
Table::Row accuracy_columns();
Table::Row accuracy_row(const Job& job, const Tier& tier, const Setting& setting, const Measured& measured);

/// The rows of all parts by job; the tiers of one stay in their order. Empty, or why they are not parts of
/// one sweep: other columns, a job twice, or a job that no part has.
std::string merge(const std::vector<Table>& parts, Table& out);

} // namespace spangle::trade
