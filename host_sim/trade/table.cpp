#include "host_sim/trade/table.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "raster/reference/shadow.hpp"

namespace spangle::trade {

namespace {

std::string quote_cell(const std::string& cell) {
    if (cell.find_first_of(",\"\n\r") == std::string::npos)
        return cell;
    std::string out = "\"";
    for (const char c : cell)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

/// The name of a column: "vertex_color" of "vertex color".
std::string column_of(const char* stage) {
    std::string out = stage;
    for (char& c : out)
        c = c == ' ' ? '_' : c == '/' ? '_' : c;
    return out;
}

std::string figure_text(double v) {
    return fmt::format("{:.6g}", v);
}

/// Reads the cells of one line; `at` moves to the next line. Returns false where quotes are wrong.
bool read_line(std::string_view text, std::size_t& at, Table::Row& row) {
    for (std::string cell;; cell.clear()) {
        if (at < text.size() && text[at] == '"') {
            for (++at;; ++at) {
                if (at >= text.size())
                    return false;
                if (text[at] == '"' && (at + 1 >= text.size() || text[++at] != '"'))
                    break;
                cell += text[at];
            }
            if (at + 1 == text.size() && text[at] == '"')
                ++at; // the last character of the file closes a cell
        } else {
            while (at < text.size() && text[at] != ',' && text[at] != '\n')
                cell += text[at++];
        }
        row.push_back(cell);
        if (at >= text.size() || text[at] == '\n') {
            ++at;
            return true;
        }
        if (text[at++] != ',')
            return false;
    }
}

const StageError* stage_of(const Measured& m, std::string_view name) {
    for (const StageError& stage : m.stages)
        if (name == stage.stage)
            return &stage;
    return nullptr;
}

} // namespace

const std::string& Table::text(const Row& row, std::string_view column) const {
    static const std::string nothing;
    const auto at =
        static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
    return at < row.size() ? row[at] : nothing;
}

std::optional<double> Table::number(const Row& row, std::string_view column) const {
    const std::string& cell = text(row, column);
    double v = 0;
    const auto end = std::from_chars(cell.data(), cell.data() + cell.size(), v);
    if (cell.empty() || end.ec != std::errc() || end.ptr != cell.data() + cell.size())
        return {};
    return v;
}

std::string to_csv(const Table& table) {
    std::string out;
    const auto line = [&out](const Table::Row& row) {
        for (std::size_t i = 0; i < row.size(); ++i)
            out += (i == 0 ? "" : ",") + quote_cell(row[i]);
        out += '\n';
    };
    line(table.columns);
    for (const Table::Row& row : table.rows)
        line(row);
    return out;
}

std::string from_csv(std::string_view text, Table& out) {
    out = {};
    for (std::size_t at = 0; at < text.size();) {
        Table::Row row;
        if (!read_line(text, at, row))
            return fmt::format("row {} is no CSV", out.rows.size() + 1);
        if (out.columns.empty())
            out.columns = row;
        else if (row.size() != out.columns.size())
            return fmt::format("row {} has {} cells for {} columns", out.rows.size() + 1, row.size(),
                               out.columns.size());
        else
            out.rows.push_back(row);
    }
    return out.columns.empty() ? "the file is empty" : "";
}

Table::Row accuracy_columns() {
    Table::Row out = {"job",         "jobs",        "scene",         "tier",         "format",
                      "size",        "frames",      "dither",        "covered",      "identical",
                      "max_lsb",     "psnr_565",    "psnr_888",      "psnr_to_888",  "perceived",
                      "off_own",     "off_snapped", "off_unsnapped", "off_ideal",    "depth_steps",
                      "order_flips", "texel_worst", "texel_rms",     "wrong_texels", "frame_bytes",
                      "bus_bytes"};
    for (int i = 0; i < raster::shadow_stages; ++i) {
        const std::string stage = column_of(raster::name_of(static_cast<raster::ShadowStage>(i)));
        out.push_back(stage + "_worst");
        out.push_back(stage + "_rms");
    }
    return out;
}

Table::Row accuracy_row(const Job& job, const Tier& tier, const Setting& s, const Measured& m) {
    const StageError* const coord = stage_of(m, "coord 0");
    const auto wrong = [&] { // a fragment is two values, s and t
        return 200.0 * static_cast<double>(coord->flips) / static_cast<double>(coord->count);
    };
    Table::Row out = {std::to_string(job.number),
                      std::to_string(job.of),
                      job.scene,
                      tier.name,
                      job.format.name,
                      fmt::format("{}x{}", s.width, s.height),
                      std::to_string(s.frames),
                      s.dither ? "on" : "off",
                      std::to_string(m.error.pixels),
                      figure_text(m.error.identical_percent()),
                      std::to_string(m.error.max_lsb),
                      figure_text(m.error.psnr_565()),
                      figure_text(m.error.psnr_888()),
                      figure_text(m.psnr_to_888),
                      fmt::format("{:.5f}", m.perceived),
                      std::to_string(m.off_own),
                      std::to_string(m.off_snapped),
                      std::to_string(m.off_unsnapped),
                      std::to_string(m.off_ideal),
                      m.error.compared_depths != 0 ? std::to_string(m.error.depth_steps) : "",
                      m.error.compared_depths != 0 ? std::to_string(m.error.order_flips) : "",
                      coord != nullptr ? figure_text(coord->worst) : "",
                      coord != nullptr ? figure_text(coord->rms) : "",
                      coord != nullptr ? figure_text(wrong()) : "",
                      std::to_string(m.frame_bytes),
                      m.bus_bytes != 0 ? std::to_string(m.bus_bytes) : ""};
    for (int i = 0; i < raster::shadow_stages; ++i) {
        const StageError* const stage = stage_of(m, raster::name_of(static_cast<raster::ShadowStage>(i)));
        out.push_back(stage != nullptr ? figure_text(stage->worst) : "");
        out.push_back(stage != nullptr ? figure_text(stage->rms) : "");
    }
    return out;
}

std::string merge(const std::vector<Table>& parts, Table& out) {
    out = {};
    std::vector<std::pair<int, Table::Row>> rows;
    int jobs = 0;
    for (const Table& part : parts) {
        if (out.columns.empty())
            out.columns = part.columns;
        else if (part.columns != out.columns)
            return "the parts have other columns";
        for (const Table::Row& row : part.rows) {
            const int of = static_cast<int>(part.number(row, "jobs").value_or(0));
            if (of < 1 || (jobs != 0 && of != jobs))
                return "the parts are of other sweeps";
            jobs = of;
            rows.emplace_back(static_cast<int>(part.number(row, "job").value_or(-1)), row);
        }
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<bool> found(static_cast<std::size_t>(jobs));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& [job, row] = rows[i];
        if (job < 0 || job >= jobs)
            return fmt::format("job {} of {} cannot be", job, jobs);
        for (std::size_t k = i; k-- > 0 && rows[k].first == job;)
            if (out.text(rows[k].second, "tier") == out.text(row, "tier"))
                return fmt::format("job {} is in two parts", job);
        found[static_cast<std::size_t>(job)] = true;
        out.rows.push_back(row);
    }
    const auto missing = std::find(found.begin(), found.end(), false);
    return missing == found.end() ? ""
                                  : fmt::format("no part has job {} of {}", missing - found.begin(), jobs);
}

} // namespace spangle::trade
