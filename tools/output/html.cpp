#include "tools/output/html.hpp"

namespace tumble::tools {

namespace {

constexpr std::string_view kStyle = R"(
body { font: 15px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #263238; background: #fff; margin: 2.5rem auto; max-width: 1280px; padding: 0 1.5rem; }
h1 { font-size: 1.7rem; margin: 0 0 1rem; } h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem; }
p { max-width: 62rem; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; margin: .8rem 0; }
th { text-align: left; border-bottom: 2px solid #b0bec5; padding: .3rem .9rem .3rem 0; vertical-align: bottom; }
td { border-bottom: 1px solid #e0e6ea; padding: .25rem .9rem .25rem 0; }
td.number { white-space: nowrap; }
th.number, td.number { text-align: right; } .alarm { color: #c62828; font-weight: bold; }
.scroll { overflow-x: auto; }
figure { margin: 1rem 0; } figure svg { max-width: 100%; height: auto; border: 1px solid #e0e6ea; }
figcaption { font-size: 13px; color: #546e7a; }
pre { background: #f5f7f8; padding: .6rem .8rem; overflow-x: auto; font-size: 12px; }
details { margin: .6rem 0; } summary { cursor: pointer; }
)";

std::string element(std::string_view tag, std::string_view text) {
    const std::string name(tag);
    return "<" + name + ">" + escape_markup(text) + "</" + name + ">\n";
}

std::string cell(std::string_view tag, const HtmlCell& cell) {
    const std::string name(tag);
    std::string classes = cell.is_number ? "number" : "";
    if (cell.is_alarm) classes += classes.empty() ? "alarm" : " alarm";
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

void HtmlPage::begin_details(std::string_view summary) { body_ += "<details>" + element("summary", summary); }
void HtmlPage::end_details() { body_ += "</details>\n"; }

std::string HtmlPage::str() const {
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" + element("title", title_) +
           "<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n" + body_ + "</body>\n</html>\n";
}

}  // namespace tumble::tools
