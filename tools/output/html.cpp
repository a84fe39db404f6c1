#include "tools/output/html.hpp"

#include <utility>

#include "tools/output/plot_colors.hpp"

namespace tumble::tools {

namespace {

// Colours are variables, in a light and a dark scheme; those of plots are in plot_colors.cpp. Drawings of shapes keep
// their white ground in both.
constexpr std::string_view kLight = "--ground: #fff; --faint: #546e7a; --code: #f5f7f8; --good: #2e7d32;";
constexpr std::string_view kDark = "--ground: #14191d; --faint: #9fb0ba; --code: #1d252a; --good: #7cc980;";
constexpr std::string_view kStyle = R"(
body { font: 15px/1.5 "DejaVu Sans", Verdana, sans-serif; color: var(--text); background: var(--ground); margin: 2.5rem auto; max-width: 1280px; padding: 0 1.5rem; }
h1, h2 { overflow-wrap: anywhere; }
h1 { font-size: 1.7rem; margin: 0 0 1rem; } h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem; }
p { max-width: 62rem; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; margin: .8rem 0; }
th { text-align: left; border-bottom: 2px solid var(--head); padding: .3rem .9rem .3rem 0; vertical-align: bottom; }
td { border-bottom: 1px solid var(--rule); padding: .25rem .9rem .25rem 0; vertical-align: top; }
td.number { white-space: nowrap; }
th.number, td.number { text-align: right; } .alarm { color: var(--limit); font-weight: bold; } .good { color: var(--good); font-weight: bold; }
.scroll { overflow-x: auto; }
figure { margin: 1rem 0; } figure svg, figure img { max-width: 100%; height: auto; border: 1px solid var(--rule); }
.figures { display: flex; flex-wrap: wrap; gap: 1rem; } .figures figure { margin: 0; min-width: 0; }
figcaption { font-size: 13px; color: var(--faint); max-width: 62rem; }
iframe { width: 100%; border: 1px solid var(--rule); }
pre { background: var(--code); padding: .6rem .8rem; white-space: pre-wrap; overflow-wrap: anywhere; font-size: 12px; }
details { margin: .6rem 0; } summary { cursor: pointer; }
@media (max-width: 760px) { body { margin: 1rem auto; padding: 0 .8rem; } h1 { font-size: 1.35rem; } h2 { font-size: 1.1rem; } }
)";

std::string style() {
    return ":root { color-scheme: light dark; " + std::string(kLight) + plot_variables(false) +
           " }\n@media (prefers-color-scheme: dark) { :root { " + std::string(kDark) + plot_variables(true) + " } }" +
           std::string(kStyle) + plot_style(Scheme::variable);
}

std::string element(std::string_view tag, std::string_view text) {
    const std::string name(tag);
    return "<" + name + ">" + escape_markup(text) + "</" + name + ">\n";
}

std::string cell(std::string_view tag, const HtmlCell& cell) {
    const std::string name(tag);
    std::string classes;
    for (const auto& [has, word] :
         {std::pair(cell.is_number, "number"), std::pair(cell.is_alarm, "alarm"), std::pair(cell.is_good, "good")})
        if (has) classes += (classes.empty() ? "" : " ") + std::string(word);
    const std::string open = classes.empty() ? "<" + name + ">" : "<" + name + " class=\"" + classes + "\">";
    return open + escape_markup(cell.text) + "</" + name + ">";
}

}  // namespace

HtmlPage::HtmlPage(std::string_view title) : title_(title), body_(element("h1", title)) {}

void HtmlPage::heading(std::string_view text) { body_ += element("h2", text); }
void HtmlPage::paragraph(std::string_view text) { body_ += element("p", text); }
void HtmlPage::preformatted(std::string_view text) { body_ += element("pre", text); }

void HtmlPage::table(std::span<const std::string> header, std::span<const std::vector<HtmlCell>> rows) {
    body_ += "<div class=\"scroll\"><table>\n<tr>";
    for (std::size_t column = 0; column < header.size(); ++column) {
        const bool is_number = !rows.empty() && column < rows.front().size() && rows.front()[column].is_number;
        body_ += cell("th", {.text = header[column], .is_number = is_number});
    }
    body_ += "</tr>\n";
    for (const std::vector<HtmlCell>& row : rows) {
        body_ += "<tr>";
        for (const HtmlCell& value : row) body_ += cell("td", value);
        body_ += "</tr>\n";
    }
    body_ += "</table></div>\n";
}

void HtmlPage::figure(const Drawing& drawing, std::string_view caption) {
    body_ += "<figure>\n" + to_svg(drawing) + element("figcaption", caption) + "</figure>\n";
}

void HtmlPage::figure(const Plot& plot, std::string_view caption) {
    body_ += "<figure>\n" + to_svg(plot);
    if (!caption.empty()) body_ += element("figcaption", caption);
    body_ += "</figure>\n";
}

void HtmlPage::picture(const Image& image, std::string_view caption) {
    linked_picture(png_data_url(image), image.width, caption);
}

void HtmlPage::linked_picture(std::string_view file, int width, std::string_view caption) {
    // A long caption must not make the figure wider than its picture.
    body_ += "<figure style=\"max-width: " + std::to_string(width) + "px\">\n<img alt=\"" + escape_markup(caption) +
             "\" src=\"" + escape_markup(file) + "\">\n" + element("figcaption", caption) + "</figure>\n";
}

void HtmlPage::embedded(std::string_view title, std::string_view page, int height) {
    body_ += "<iframe title=\"" + escape_markup(title) + "\" height=\"" + std::to_string(height) + "\" srcdoc=\"" +
             escape_markup(page) + "\"></iframe>\n";
}

void HtmlPage::begin_figures() { body_ += "<div class=\"figures\">\n"; }
void HtmlPage::end_figures() { body_ += "</div>\n"; }

void HtmlPage::begin_details(std::string_view summary) { body_ += "<details>" + element("summary", summary); }
void HtmlPage::end_details() { body_ += "</details>\n"; }

std::string HtmlPage::str() const {
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
           element("title", title_) + "<style>" + style() + "</style>\n</head>\n<body>\n" + body_ +
           "</body>\n</html>\n";
}

}  // namespace tumble::tools
