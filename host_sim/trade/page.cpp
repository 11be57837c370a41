#include "host_sim/trade/page.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "host_sim/output/output.hpp"
#include "host_sim/trade/advice.hpp"
#include "host_sim/trade/boxes.hpp"
#include "host_sim/trade/cost.hpp"
#include "host_sim/trade/plot.hpp"

namespace spangle::trade {

namespace {

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Spangle: the trade</title>
<meta name="viewport" content="width=device-width">
<link rel="icon" href="data:,">
<style>
body{font:15px/1.45 system-ui,sans-serif;margin:2em auto;max-width:1080px;padding:0 1em;color:#222}
h1{font-size:1.6em}h2{margin-top:2em}table{border-collapse:collapse;margin:1em 0}
th,td{padding:.25em .6em;border-bottom:1px solid #ddd;text-align:right;white-space:nowrap}
th:first-child,td:first-child,.words{text-align:left}td.words{white-space:normal}
th{background:#f4f4f4}.missed{background:#fde9e7}.take{font-weight:bold}
.scene{border-top:1px solid #ddd;padding-top:1em;margin-top:1.5em}.pair{display:flex;gap:1em;flex-wrap:wrap}
figure{margin:0}figcaption{font-size:.85em;color:#555}img{image-rendering:pixelated;width:320px;max-width:100%;background:#000}
label{display:block;margin-bottom:.6em}input[type=range]{width:320px;vertical-align:middle}.wide{overflow-x:auto}svg{max-width:100%;height:auto}
</style></head><body>
)";

/// The script of the page. The slider of a program shows the pictures of one tier.
constexpr const char* foot = R"(<script>
for (const scene of document.querySelectorAll('.scene')) {
  const slider = scene.querySelector('input');
  const show = () => {
    for (const part of scene.querySelectorAll('[data-tier]'))
      part.hidden = part.dataset.tier !== slider.value;
  };
  slider.addEventListener('input', show);
  show();
}
const axis = document.getElementById('axis');
if (axis) {
  const show = () => {
    for (const plot of document.querySelectorAll('[data-axis]'))
      plot.hidden = plot.dataset.axis !== axis.value;
  };
  axis.addEventListener('change', show);
  show();
}
</script></body></html>
)";

std::string escape_html(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '<'   ? std::string("&lt;")
               : c == '>' ? std::string("&gt;")
               : c == '&' ? std::string("&amp;")
               : c == '"' ? std::string("&quot;")
                          : std::string(1, c);
    return out;
}

std::string base64(const std::string& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
    }
    return out;
}

/// The page under construction, and what could not be read for it.
class Page {
  public:
    Page(const std::string& folder, const Table& accuracy, const Table& cost)
        : folder_(folder), accuracy_table_(accuracy), cost_table_(cost) {}

    std::string html() {
        std::set<std::string> formats;
        for (const Table::Row& row : accuracy_table_.rows)
            formats.insert(accuracy_table_.text(row, "format"));
        html_text_ = head;
        html_text_ +=
            "<h1>Speed against accuracy</h1>\n<p>Every program, in every tier, against the same frames "
            "drawn in "
            "double. docs/trade.md says how to read the figures.</p>\n";
        write_advice();
        tier_plots();
        if (formats.size() > 1)
            write_plot(
                plot_formats(accuracy_table_),
                "Lower looks more like double, further left sends less. A name without room is left out.");
        write_figures();
        pictures();
        return html_text_ + foot;
    }
    const std::string& problem() const { return error_; }
    const std::string& note() const { return notice_; }

  private:
    const std::string& folder_;
    const Table &accuracy_table_, &cost_table_;
    std::string html_text_, error_, notice_;

    /// Adds a plot for each axis that has figures; a list selects which plot is shown.
    void tier_plots() {
        const std::vector<Axis> axes = axes_of(cost_table_);
        if (axes.empty())
            return write_plot({"", "no cost was measured"}, "");
        if (axes.size() > 1) {
            html_text_ += "<label>across <select id=axis>";
            for (std::size_t i = 0; i < axes.size(); ++i)
                html_text_ += fmt::format("<option value={}>{}</option>", i, axes[i].name);
            html_text_ += "</select></label>\n";
        }
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const Plot tiers = plot_tiers(accuracy_table_, cost_table_, axes[i]);
            write_plot(
                tiers,
                "Higher is nearer to double, further left is quicker. A name without room is left out.",
                fmt::format(" data-axis={}", i));
            if (!tiers.problem.empty())
                return; // the problem is the same for plots over the other axes
        }
    }

    void write_plot(const Plot& plot, const char* caption, const std::string& attribute = "") {
        if (plot.problem.empty()) {
            html_text_ += fmt::format("<figure{}>{}<figcaption>{}</figcaption></figure>\n", attribute,
                                      plot.svg, caption);
            return;
        }
        html_text_ += fmt::format("<p>No plot here: {}.</p>\n", escape_html(plot.problem));
        notice_ += plot.problem + "\n";
    }

    void write_advice() {
        html_text_ +=
            "<h2>What to choose</h2>\n<table><tr><th>program<th>format<th>take<th class=words>why</tr>\n";
        for (const Advice& a : advise(accuracy_table_, cost_table_))
            html_text_ += fmt::format("<tr><td>{}<td>{}<td class=take>{}<td class=words>{}</tr>\n",
                                      escape_html(a.scene), a.format, a.take, escape_html(a.why));
        html_text_ += "</table>\n";
    }

    struct CostColumn {
        std::string name, title;
    };
    std::vector<CostColumn> cost_columns_with_figures() const {
        constexpr struct {
            const char *figure, *title;
        } figures[] = {{"instructions", "instructions"},
                       {"per_pixel", "per pixel"},
                       {"per_triangle", "per triangle"},
                       {"flash", "flash"},
                       {"ram", "RAM"}};
        std::vector<CostColumn> all = {{"relative", "time"}}, out;
        for (const std::string& target : target_names())
            for (const auto& f : figures)
                all.push_back({target_column(target, f.figure), fmt::format("{} {}", target, f.title)});
        for (const CostColumn& column : all)
            if (std::any_of(cost_table_.rows.begin(), cost_table_.rows.end(), [&](const Table::Row& row) {
                    return !cost_table_.text(row, column.name).empty();
                }))
                out.push_back(column);
        return out;
    }

    void write_figures() {
        struct Column {
            const char *name, *title;
        };
        constexpr Column columns[] = {{"scene", "program"},
                                      {"format", "format"},
                                      {"tier", "tier"},
                                      {"identical", "identical %"},
                                      {"max_lsb", "565 steps"},
                                      {"psnr_565", "dB in 565"},
                                      {"psnr_to_888", "dB to 888"},
                                      {"perceived", "FLIP-like"},
                                      {"off_own", "off own-snapped"},
                                      {"off_snapped", "off double-snapped"},
                                      {"off_unsnapped", "off unsnapped"},
                                      {"depth_steps", "depth steps"},
                                      {"order_flips", "order flips"},
                                      {"texel_worst", "texel error"},
                                      {"wrong_texels", "wrong texels %"},
                                      {"frame_bytes", "frame bytes"},
                                      {"bus_bytes", "bus bytes"}};
        html_text_ += "<h2>Figures</h2>\n<div class=wide><table><tr>";
        for (const Column& column : columns)
            html_text_ += fmt::format("<th>{}", column.title);
        const std::vector<CostColumn> costs = cost_columns_with_figures();
        for (const CostColumn& column : costs)
            html_text_ += "<th>" + column.title;
        html_text_ += "</tr>\n";
        for (const Table::Row& row : accuracy_table_.rows) {
            const std::vector<std::string> missed = missed_boxes(accuracy_table_, row);
            std::string all;
            for (const std::string& one : missed)
                all += (all.empty() ? "" : "; ") + one;
            html_text_ +=
                missed.empty() ? "<tr>" : fmt::format("<tr class=missed title=\"{}\">", escape_html(all));
            for (const Column& column : columns)
                html_text_ += "<td>" + escape_html(accuracy_table_.text(row, column.name));
            const Table::Row* const cost =
                find_row(cost_table_, accuracy_table_.text(row, "job"), accuracy_table_.text(row, "tier"));
            for (const CostColumn& column : costs)
                html_text_ += "<td>" + (cost != nullptr ? cost_table_.text(*cost, column.name) : "");
            html_text_ += "</tr>\n";
        }
        html_text_ +=
            "</table></div>\n<p>A row in red breaks what its tier promises; point at it to see which.</p>\n";
    }

    std::string image(const std::string& job, const std::string& what) {
        const std::string path = folder_ + picture_name(job, what);
        std::ifstream file(path, std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        if (!file && error_.empty())
            error_ = "cannot read '" + path + "'";
        return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escape_html(what),
                           base64(bytes.str()));
    }

    /// Adds the rows of one program in one format, one for each tier.
    void scene(const std::vector<const Table::Row*>& rows) {
        const std::string &job = accuracy_table_.text(*rows.front(), "job"),
                          &name = accuracy_table_.text(*rows.front(), "scene"),
                          &format = accuracy_table_.text(*rows.front(), "format");
        html_text_ +=
            fmt::format("<div class=scene id=\"job{}\"><h3>{}, {}</h3>\n<label>tier <input type=range min=0 "
                        "max={} value={} step=1 aria-label=\"tier\"></label>\n<div class=pair>\n",
                        job, escape_html(name), format, rows.size() - 1, rows.size() - 1);
        for (const char* what : {"picture", "off"})
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const std::string& tier = accuracy_table_.text(*rows[i], "tier");
                const bool picture = what[0] == 'p';
                html_text_ += fmt::format("<figure data-tier={}>{}<figcaption>{}</figcaption></figure>\n", i,
                                          image(job, picture ? tier : tier + "-off"),
                                          picture ? tier : "where " + tier + " differs from double");
            }
        html_text_ += fmt::format("<figure>{}<figcaption>double</figcaption></figure>\n</div></div>\n",
                                  image(job, "double"));
    }

    void pictures() {
        html_text_ += "<h2>Pictures</h2>\n<p>The last frame. Move a slider from one tier to the next.</p>\n";
        std::vector<const Table::Row*> rows;
        for (const Table::Row& row : accuracy_table_.rows) {
            if (!rows.empty() &&
                accuracy_table_.text(*rows.front(), "job") != accuracy_table_.text(row, "job")) {
                scene(rows);
                rows.clear();
            }
            rows.push_back(&row);
        }
        if (!rows.empty())
            scene(rows);
    }
};

} // namespace

std::string picture_name(const std::string& job, const std::string& what) {
    return std::string(picture_folder) + "/" + job + "-" + what + ".png";
}

std::string write_page(const std::string& folder, const Table& accuracy, const Table& cost,
                       std::string& note) {
    Page page(folder, accuracy, cost);
    const std::string html = page.html();
    note = page.note();
    return page.problem().empty() ? sim::write_file(folder + page_file, html) : page.problem();
}

} // namespace spangle::trade
