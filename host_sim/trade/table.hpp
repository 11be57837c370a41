// Figures as text in rows and named columns, which are written to CSV files and read from them again.
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

/// The table as CSV (RFC 4180), with line feeds.
std::string to_csv(const Table& table);
/// Reads a table from CSV. Returns why the text is no table, or an empty string.
std::string from_csv(std::string_view text, Table& out);

/// A job of a sweep: a program in a format. Its tiers are the rows of the job.
struct Job {
    int number, of;
    std::string scene;
    Format format;
};

/// The columns of accuracy.csv, and a row of it. Rows have the same bytes on every machine.
Table::Row accuracy_columns();
Table::Row accuracy_row(const Job& job, const Tier& tier, const Setting& setting, const Measured& measured);

/// Merges the rows of all parts by job; the tiers of a job stay in their order. Returns why these are no
/// parts of one sweep, or an empty string: columns differ, a job comes twice, or no part has a job.
std::string merge(const std::vector<Table>& parts, Table& out);

} // namespace spangle::trade
