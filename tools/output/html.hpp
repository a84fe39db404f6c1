// The one writer of HTML pages: self-contained documents with headings, text, tables and drawings, for reports that
// people open in a browser. Text is escaped; the page loads nothing from anywhere.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/drawing.hpp"

namespace tumble::tools {

struct HtmlCell {
    std::string text;
    bool is_number = false;  // aligned to the right
    bool is_alarm = false;   // drawn in red
};

class HtmlPage {
public:
    explicit HtmlPage(std::string_view title);

    void heading(std::string_view text);
    void paragraph(std::string_view text);
    void table(std::span<const std::string> header, std::span<const std::vector<HtmlCell>> rows);
    void figure(const Drawing& drawing, std::string_view caption);
    void preformatted(std::string_view text);

    // A block that is folded under its summary until it is opened; must be ended.
    void begin_details(std::string_view summary);
    void end_details();

    std::string str() const;  // the whole document

private:
    std::string title_;
    std::string body_;
};

}  // namespace tumble::tools
